#include "export/lattice_hemoflow.hpp"

#include "core/error.hpp"
#include "export/node_box.hpp"
#include "export/npy_header.hpp"
#include "export/resisting_planes.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>
#include <minizip/zip.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace braidzone {

namespace {

constexpr double weight_scale = 1000.0;  // S

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
        begin(name, type, shape);
        write(values);
        end();
    }

    /// Begins an array whose values follow by `write`, the last index fastest.
    void begin(const char* name, const char* type, const std::string& shape)
    {
        const zip_fileinfo no_date{};
        constexpr int fastest = 1;
        const std::string file = fmt::format("{}.npy", name);
        require(zipOpenNewFileInZip(file_, file.c_str(), &no_date, nullptr, 0, nullptr, 0, nullptr,
                                    Z_DEFLATED, fastest));
        const std::string header = npy_header(type, shape, NpyOrder::last_fastest);
        require(zipWriteInFileInZip(file_, header.data(), static_cast<unsigned>(header.size())));
    }

    template <typename Value>
    void write(const std::vector<Value>& values)
    {
        const auto num_bytes = static_cast<unsigned>(values.size() * sizeof(Value));
        require(zipWriteInFileInZip(file_, values.data(), num_bytes));
    }

    void end() { require(zipCloseFileInZip(file_)); }

    void close() { require(zipClose(std::exchange(file_, nullptr), nullptr)); }

private:
    void require(int status) const
    {
        if (status != ZIP_OK) fail();
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

std::uint16_t weight_of(double darcy, const LatticeNodes& nodes, const Fluid& fluid,
                        const SheetLoss& loss)
{
    if (!(loss.linear > 0.0)) return 0;
    const double weight = weight_scale * fluid.viscosity * darcy * nodes.grid.spacing / loss.linear;
    constexpr double most = std::numeric_limits<std::uint16_t>::max();
    if (!(weight <= most)) {
        throw ConfigError(fmt::format(
            "export.targets: hemoflow holds weights up to {:.0f}, but a node has {:.4g} times the "
            "mean resistance of the device, {:.4g} at most; leave this target out",
            most, weight / weight_scale, most / weight_scale));
    }
    return static_cast<std::uint16_t>(std::lround(weight));
}

/// Types and weights, both x slowest and z fastest, plane by plane.
void add_node_arrays(Archive& archive, const LatticeNodes& nodes, const NodeBox& box,
                     const Fluid& fluid, const SheetLoss& loss)
{
    const auto& [nx, ny, nz] = box.dims();
    const std::string shape = fmt::format("{}, {}, {}", nx, ny, nz);
    const auto place_in_plane = [&](int j, int k) {
        return static_cast<std::size_t>((j - box.first[1]) * nz + k - box.first[2]);
    };
    std::vector<std::uint16_t> plane(static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz));
    archive.begin("geometryFlag", "<u2", shape);
    for (int i = box.first[0]; i <= box.last[0]; ++i) {
        for (int j = box.first[1]; j <= box.last[1]; ++j)
            for (int k = box.first[2]; k <= box.last[2]; ++k)
                plane[place_in_plane(j, k)] = nodes.type[nodes.grid.index(i, j, k)];
        archive.write(plane);
    }
    archive.end();
    const ResistingPlanes planes(nodes, 0);
    archive.begin("stent", "<u2", shape);
    for (int i = box.first[0]; i <= box.last[0]; ++i) {
        std::fill(plane.begin(), plane.end(), std::uint16_t{0});
        for (const std::size_t node : planes.in_plane(i)) {
            const std::array<int, 3> place = place_of(nodes.grid, nodes.resisting[node]);
            plane[place_in_plane(place[1], place[2])] =
                weight_of(nodes.darcy[node], nodes, fluid, loss);
        }
        archive.write(plane);
    }
    archive.end();
}

void write_archive(const std::filesystem::path& path, const LatticeNodes& nodes,
                   const Vessel& vessel, const NodeBox& box, const Fluid& fluid,
                   const SheetLoss& loss)
{
    std::vector<std::uint16_t> indices;
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
    const std::string list = fmt::format("{},", indices.size());
    const std::string vectors = fmt::format("{}, 3", indices.size());
    Archive archive(path);
    add_node_arrays(archive, nodes, box, fluid, loss);
    archive.add("dx", "<f8", "1,", std::vector<double>{nodes.grid.spacing});
    archive.add("openingIndex", "<u2", list, indices);
    archive.add("openingRadius", "<f8", list, radii);
    archive.add("openingNormalizedQRatio", "<f8", list, ratios);
    archive.add("openingCenter", "<f8", vectors, centres);
    archive.add("openingTangent", "<f8", vectors, tangents);
    archive.close();
}

}  // namespace

std::vector<LatticeFile> write_hemoflow(const std::filesystem::path& folder,
                                        const LatticeNodes& nodes, const Vessel& vessel,
                                        const Fluid& fluid, const LatticeFlowOptions& flow)
{
    const NodeBox box = box_between_openings(nodes, vessel, LatticeTarget::hemoflow).box;
    const double mean_velocity = 0.5 * flow.peak_velocity;
    const double time_step = hemoflow_velocity_lu * nodes.grid.spacing / mean_velocity;
    const double largest =
        nodes.darcy.empty() ? 0.0 : *std::max_element(nodes.darcy.begin(), nodes.darcy.end());
    const double drag_lu = fluid.viscosity / fluid.density * largest * time_step;
    if (!(drag_lu < hemoflow_most_drag_lu)) {
        throw ConfigError(fmt::format(
            "export.targets: hemoflow's explicit force diverges with a drag of {:.3g} a time step; "
            "allowed is less than {:.3g}; a peak_velocity above {:.3g} m/s gives shorter steps",
            drag_lu, hemoflow_most_drag_lu, flow.peak_velocity * drag_lu / hemoflow_most_drag_lu));
    }
    const SheetLoss loss = mean_loss(nodes, fluid);
    write_archive(folder / "case.npz", nodes, vessel, box, fluid, loss);
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
    return {{"case.npz", "zip of NumPy arrays: geometryFlag and stent uint16, openings",
             shape_of(box.dims()), "last index fastest"},
            {"setup.xml", "text", {}, ""},
            {"flow.txt", "text", {}, ""}};
}

}  // namespace braidzone
