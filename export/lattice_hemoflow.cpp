#include "export/lattice_hemoflow.hpp"

#include "core/error.hpp"
#include "export/npy_header.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>
#include <minizip/zip.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace braidzone {

namespace {

constexpr double weight_scale = 1000.0;         // S
constexpr double hemoflow_viscosity = 3.22e-6;  // kinematic [m^2/s], its nuInf
constexpr double hemoflow_velocity_lu = 0.05;   // its U_AVG_LB
constexpr double most_drag_lu = 0.9;            // above, its explicit force diverges

/// A part of the lattice: from the first node to the last one along each axis.
struct NodeBox {
    std::array<int, 3> first{}, last{};
};

/// The box whose faces the openings lie on.
NodeBox box_with_flat_openings(const LatticeNodes& nodes, const Vessel& vessel)
{
    NodeBox box;
    for (std::size_t axis = 0; axis < 3; ++axis)
        box.last[axis] = nodes.grid.dims[axis] - 1;
    for (const LatticeOpening& entry : nodes.openings) {
        std::array<int, 3> lowest, highest;
        lowest.fill(std::numeric_limits<int>::max());
        highest.fill(-1);
        for (std::size_t node = 0; node < nodes.type.size(); ++node) {
            if (nodes.type[node] != entry.code) continue;
            const std::array<int, 3> place = place_of(nodes.grid, static_cast<std::int64_t>(node));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                lowest[axis] = std::min(lowest[axis], place[axis]);
                highest[axis] = std::max(highest[axis], place[axis]);
            }
        }
        const Opening& opening = vessel.openings[static_cast<std::size_t>(entry.opening)];
        Eigen::Index direction = 0;
        const double along = opening.normal.cwiseAbs().maxCoeff(&direction);
        const auto axis = static_cast<std::size_t>(direction);
        if (lowest[axis] != highest[axis]) {
            throw ConfigError(fmt::format(
                "export.targets: hemoflow wants openings flat on the faces of the box; that at "
                "({:.4g}, {:.4g}, {:.4g}) mm is turned by {:.2g} degrees from an axis. Turn the "
                "vessel, or leave this target out",
                1e3 * opening.centre[0], 1e3 * opening.centre[1], 1e3 * opening.centre[2],
                std::acos(std::min(1.0, along)) * 180.0 / std::numbers::pi));
        }
        (opening.normal[direction] < 0.0 ? box.first : box.last)[axis] = lowest[axis];
    }
    return box;
}

/// Calls visit(node) for every node of a box, z fastest, x slowest.
template <typename Visit>
void for_each_node(const LatticeNodes& nodes, const NodeBox& box, Visit visit)
{
    for (int i = box.first[0]; i <= box.last[0]; ++i)
        for (int j = box.first[1]; j <= box.last[1]; ++j)
            for (int k = box.first[2]; k <= box.last[2]; ++k)
                visit(nodes.grid.index(i, j, k));
}

void require_fluid_inside(const LatticeNodes& nodes, const NodeBox& box)
{
    std::size_t inside = 0;
    for_each_node(nodes, box, [&](std::size_t node) {
        inside += nodes.type[node] == static_cast<std::uint8_t>(NodeType::fluid);
    });
    const auto all = static_cast<std::size_t>(std::count(
        nodes.type.begin(), nodes.type.end(), static_cast<std::uint8_t>(NodeType::fluid)));
    if (inside == all) return;
    throw ConfigError(fmt::format(
        "export.targets: hemoflow wants openings on the faces of the box, but {} of {} fluid nodes "
        "lie beyond one; leave this target out",
        all - inside, all));
}

/// A zip archive; what is not closed is no archive.
class Archive {
public:
    explicit Archive(const std::filesystem::path& path)
        : path_(path), file_(zipOpen(path.c_str(), APPEND_STATUS_CREATE))
    {
        if (file_ == nullptr) fail();
    }
    ~Archive()
    {
        if (file_ != nullptr) zipClose(file_, nullptr);
    }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    /// Adds an array, compressed; without a date, so that equal arrays give equal files.
    template <typename Value>
    void add(const char* name, const char* type, const std::string& shape,
             const std::vector<Value>& values)
    {
        const std::string header = npy_header(type, shape, NpyOrder::last_fastest);
        const zip_fileinfo no_date{};
        constexpr int fastest = 1;
        bool good =
            zipOpenNewFileInZip(file_, fmt::format("{}.npy", name).c_str(), &no_date, nullptr, 0,
                                nullptr, 0, nullptr, Z_DEFLATED, fastest) == ZIP_OK;
        good = good && write(header.data(), header.size());
        good = good && write(values.data(), values.size() * sizeof(Value));
        good = good && zipCloseFileInZip(file_) == ZIP_OK;
        if (!good) fail();
    }

    void close()
    {
        if (zipClose(std::exchange(file_, nullptr), nullptr) != ZIP_OK) fail();
    }

private:
    bool write(const void* bytes, std::size_t count)
    {
        return zipWriteInFileInZip(file_, bytes, static_cast<unsigned>(count)) == ZIP_OK;
    }
    [[noreturn]] void fail() const
    {
        throw IoError(fmt::format("{} cannot be written", path_.string()));
    }

    std::filesystem::path path_;
    zipFile file_;
};

/// The sheet's constants, mean over its area: a [Pa s/m], b [Pa s^2/m^2].
SheetLoss mean_loss(const LatticeNodes& nodes, const Fluid& fluid)
{
    const auto sum = [](const std::vector<double>& values) {
        return std::accumulate(values.begin(), values.end(), 0.0);
    };
    const double area = sum(nodes.surface_density);
    if (!(area > 0.0)) return {};
    return {fluid.viscosity * sum(nodes.darcy) / area,
            0.5 * fluid.density * sum(nodes.forchheimer) / area};
}

/// Weights of the resisting nodes, 0 elsewhere.
std::vector<std::uint16_t> weights_of(const LatticeNodes& nodes, const NodeBox& box,
                                      const Fluid& fluid, const SheetLoss& loss)
{
    std::vector<std::uint16_t> of_node(nodes.type.size(), 0), weights;
    for (std::size_t i = 0; i < nodes.resisting.size(); ++i) {
        const double weight = weight_scale * fluid.viscosity * nodes.darcy[i] * nodes.grid.spacing /
                              std::max(loss.linear, 1e-300);
        of_node[static_cast<std::size_t>(nodes.resisting[i])] = static_cast<std::uint16_t>(
            std::min(std::round(weight), double{std::numeric_limits<std::uint16_t>::max()}));
    }
    for_each_node(nodes, box, [&](std::size_t node) { weights.push_back(of_node[node]); });
    return weights;
}

void write_archive(const std::filesystem::path& path, const LatticeNodes& nodes,
                   const Vessel& vessel, const NodeBox& box,
                   const std::vector<std::uint16_t>& weights)
{
    std::vector<std::uint16_t> flags, indices;
    for_each_node(nodes, box, [&](std::size_t node) { flags.push_back(nodes.type[node]); });
    std::vector<double> radii, ratios, centres, tangents;
    double outflow = 0.0;
    for (const LatticeOpening& entry : nodes.openings)
        if (entry.code != static_cast<std::uint8_t>(NodeType::inlet))
            outflow += std::pow(vessel.openings[static_cast<std::size_t>(entry.opening)].radius, 3);
    for (const LatticeOpening& entry : nodes.openings) {
        const Opening& opening = vessel.openings[static_cast<std::size_t>(entry.opening)];
        const bool is_inlet = entry.code == static_cast<std::uint8_t>(NodeType::inlet);
        indices.push_back(entry.code);
        radii.push_back(opening.radius);
        // Murray's law; the inlet takes all.
        ratios.push_back(is_inlet ? 1.0 : std::pow(opening.radius, 3) / outflow);
        const Vec3 place = (opening.centre - nodes.grid.origin) / nodes.grid.spacing;
        for (int axis = 0; axis < 3; ++axis) {
            centres.push_back(place[axis] - box.first[static_cast<std::size_t>(axis)]);
            tangents.push_back(is_inlet ? -opening.normal[axis] : opening.normal[axis]);
        }
    }
    const std::string grid =
        fmt::format("{}, {}, {}", box.last[0] - box.first[0] + 1, box.last[1] - box.first[1] + 1,
                    box.last[2] - box.first[2] + 1);
    const std::string list = fmt::format("{},", indices.size());
    const std::string vectors = fmt::format("{}, 3", indices.size());
    Archive archive(path);
    archive.add("geometryFlag", "<u2", grid, flags);
    archive.add("stent", "<u2", grid, weights);
    archive.add("dx", "<f8", "1,", std::vector<double>{nodes.grid.spacing});
    archive.add("openingIndex", "<u2", list, indices);
    archive.add("openingRadius", "<f8", list, radii);
    archive.add("openingNormalizedQRatio", "<f8", list, ratios);
    archive.add("openingCenter", "<f8", vectors, centres);
    archive.add("openingTangent", "<f8", vectors, tangents);
    archive.close();
}

}  // namespace

void write_hemoflow(const std::filesystem::path& folder, const LatticeNodes& nodes,
                    const Vessel& vessel, const Fluid& fluid, const LatticeFlowOptions& flow)
{
    const NodeBox box = box_with_flat_openings(nodes, vessel);
    require_fluid_inside(nodes, box);
    const double mean_velocity = 0.5 * flow.peak_velocity;
    const double time_step = hemoflow_velocity_lu * nodes.grid.spacing / mean_velocity;
    const double largest =
        nodes.darcy.empty() ? 0.0 : *std::max_element(nodes.darcy.begin(), nodes.darcy.end());
    const double drag_lu = fluid.viscosity / fluid.density * largest * time_step;
    if (!(drag_lu < most_drag_lu)) {
        throw ConfigError(fmt::format(
            "export.targets: hemoflow's explicit force diverges with a drag of {:.3g} a time step; "
            "allowed is less than {:.3g}; a peak_velocity above {:.3g} m/s gives shorter steps",
            drag_lu, most_drag_lu, flow.peak_velocity * drag_lu / most_drag_lu));
    }
    const SheetLoss loss = mean_loss(nodes, fluid);
    write_archive(folder / "case.npz", nodes, vessel, box, weights_of(nodes, box, fluid, loss));
    const Opening& inlet =
        vessel.openings[static_cast<std::size_t>(nodes.openings.front().opening)];
    write_text_file(folder / "setup.xml",
                    fmt::format(R"(<?xml version="1.0" ?>

<simulation>
    <Re>{:.9g}</Re>
    <blockSize>50</blockSize>
    <outputDir>output</outputDir>
    <simLength>0.5</simLength>
    <saveFrequency>0.1</saveFrequency>
</simulation>

<geometry>
    <inletFlowrateFunc>flow.txt</inletFlowrateFunc>
    <file>case.npz</file>
</geometry>

<flowdiverter>
    <linCoeff>{:.9g}</linCoeff>
    <quadCoeff>{:.9g}</quadCoeff>
</flowdiverter>
)",
                                mean_velocity * 2.0 * inlet.radius / hemoflow_viscosity,
                                loss.linear / weight_scale, loss.quadratic / weight_scale));
    // Steady: the same factor at both ends of a second.
    write_text_file(folder / "flow.txt", "2\n0 1\n1 1\n");
}

}  // namespace braidzone
