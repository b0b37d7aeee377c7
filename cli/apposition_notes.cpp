#include "cli/apposition_notes.hpp"

#include "cli/pipeline.hpp"
#include "core/place_text.hpp"
#include "deploy/braid_kinematics.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/device_library.hpp"
#include "deploy/opening_kind.hpp"
#include "deploy/wall_profile.hpp"
#include "deploy/wire_stretch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace braidzone {
namespace {

constexpr double least_contact = 0.5, most_off_the_wall = 0.1;
constexpr double largest_stretch = 0.01;

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// How the part of a device that should lie on the wall does so.
struct Apposition {
    double touching = 0.0, off = 0.0;  ///< shares of that part's area [-]
    int farthest_node = -1;            ///< from the wall; -1 if there is no such part
};

Apposition apposition_of(const PlacedDevice& placed)
{
    const Deployment& deployment = placed.deployment;
    std::vector<WallOpening> mouths;
    for (const WallOpening& opening : placed.openings) {
        if (opening.kind != OpeningKind::end || opening.in_sac) mouths.push_back(opening);
    }
    const std::vector<char> is_mouth = nodes_of(mouths, deployment.lattice.num_nodes());
    const std::vector<double> areas = node_areas(deployment.lattice, deployment.nodes);
    Apposition apposition;
    double total = 0.0;
    for (int node = 0; node < deployment.lattice.num_nodes(); ++node) {
        if (is_mouth[index(node)]) continue;
        const double distance = deployment.wall_distance[index(node)];
        total += areas[index(node)];
        if (deployment.in_contact[index(node)]) apposition.touching += areas[index(node)];
        if (distance > wall_gap(placed.device)) apposition.off += areas[index(node)];
        if (apposition.farthest_node < 0 ||
            distance > deployment.wall_distance[index(apposition.farthest_node)])
            apposition.farthest_node = node;
    }
    if (!(total > 0.0)) return {1.0, 0.0, -1};
    apposition.touching /= total;
    apposition.off /= total;
    return apposition;
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Of the lumen behind a device [m].
double widest_diameter(const Deployment& deployment, const WallTree& wall)
{
    const double reach = 4.0 * deployment.lattice.nominal_radius;
    double widest = 0.0;
    for (const CrossSection& ring : deployment.rings)
        widest = std::max(widest, 2.0 * median(wall_profile(wall, ring, reach)));
    return widest;
}

std::vector<double> made_diameters(const FlowDiverter& device)
{
    for (const DeviceModel& model : device_library()) {
        if (model.name == device.name) return model.nominal_diameters;
    }
    return {};
}

std::string fitting_size(const FlowDiverter& device, double vessel_diameter)
{
    if (vessel_diameter <= device.nominal_diameter) return "";
    std::string text =
        fmt::format("; the vessel is up to {:.3g} mm wide there and the device {:.3g} mm: ",
                    1e3 * vessel_diameter, 1e3 * device.nominal_diameter);
    const std::vector<double> made = made_diameters(device);
    const bool is_made =
        !made.empty() && device.nominal_diameter <= *std::max_element(made.begin(), made.end());
    if (!is_made) return text + fmt::format("{:.3g} mm would fit", 1e3 * vessel_diameter);
    std::optional<double> fitting;
    for (const double diameter : made) {
        if (diameter >= vessel_diameter && (!fitting || diameter < *fitting)) fitting = diameter;
    }
    if (fitting) return text + fmt::format("the size of {:.3g} mm would fit", 1e3 * *fitting);
    return text + fmt::format("it is not made wider than {:.3g} mm",
                              1e3 * *std::max_element(made.begin(), made.end()));
}

void add_apposition(std::vector<std::string>& notes, const PlacedDevice& placed,
                    const WallTree& wall, const LengthUnit& unit)
{
    const Apposition apposition = apposition_of(placed);
    const bool is_well =
        apposition.touching >= least_contact && apposition.off <= most_off_the_wall;
    if (is_well) return;
    const Deployment& deployment = placed.deployment;
    const int node = apposition.farthest_node;
    notes.push_back(fmt::format(
        "where no sac or branch opens, the device touches the wall on {:.3g} % of its area and "
        "lies more than {:.2g} mm off it on {:.3g} %, at most {:.3g} mm, {:.4g} mm along the "
        "centerline at {}{}",
        100.0 * apposition.touching, 1e3 * wall_gap(placed.device), 100.0 * apposition.off,
        1e3 * deployment.wall_distance[index(node)],
        1e3 * deployment.ring_arc_length[index(node / deployment.lattice.nodes_per_ring)],
        place_text(deployment.nodes[index(node)], unit),
        fitting_size(placed.device, widest_diameter(deployment, wall))));
}

void add_openings(std::vector<std::string>& notes, const PlacedDevice& placed,
                  const LengthUnit& unit)
{
    for (const WallOpening& opening : placed.openings) {
        if (opening.kind == OpeningKind::sac) continue;
        const OpeningEnds ends = ends_of(opening, placed.deployment.lattice);
        const std::string end = ends.distal && ends.proximal ? "both ends"
                                : ends.distal                ? "the distal end"
                                                             : "the proximal end";
        const std::string where =
            fmt::format("{:.3g} mm2 of it about {}", 1e6 * opening.area,
                        place_text(middle_of(opening, placed.deployment), unit));
        if (opening.kind == OpeningKind::end) {
            notes.push_back(fmt::format("{} of the device {}: {}", end,
                                        opening.in_sac
                                            ? "lies in the mouth of a sac, or in a widening"
                                            : "does not lie on the wall",
                                        where));
        } else {
            notes.push_back(
                fmt::format("the device {} the ostium of the branch that leads to opening {}: {}",
                            ends.distal || ends.proximal ? "ends in" : "crosses",
                            fmt::join(opening.vessel_openings, ", "), where));
        }
    }
}

/// Between the end rings, with wires of constant length [m].
double predicted_length(const PlacedDevice& placed)
{
    const BraidLattice& lattice = placed.deployment.lattice;
    const std::vector<double> expansion = radial_expansion(placed.deployment);
    std::vector<double> radii(index(lattice.num_rings), 0.0);
    for (int node = 0; node < lattice.num_nodes(); ++node)
        radii[index(node / lattice.nodes_per_ring)] +=
            expansion[index(node)] / lattice.nodes_per_ring;
    const double largest = std::hypot(1.0, placed.device.braid_ratio);
    double length = 0.0;
    for (std::size_t ring = 1; ring < radii.size(); ++ring) {
        const double ratio = 0.5 * (radii[ring - 1] + radii[ring]) / lattice.nominal_radius;
        length += lattice.ring_spacing *
                  length_ratio(placed.device.braid_ratio, std::min(ratio, largest));
    }
    return length;
}

void add_length(std::vector<std::string>& notes, const PlacedDevice& placed)
{
    const double stretch = wire_stretch(placed.deployment).total;
    if (!(std::abs(stretch) > largest_stretch)) return;
    std::string text =
        fmt::format("the wires are {:.3g} % {} than they are made, which real ones hardly are",
                    100.0 * std::abs(stretch), stretch < 0.0 ? "shorter" : "longer");
    const ReleaseSchedule& schedule = placed.schedule;
    if (schedule.windows.empty() && schedule.table.empty()) {
        const auto& places = placed.deployment.ring_arc_length;
        text += fmt::format(
            ": with wires of constant length the device would be about {:.3g} mm long, not {:.3g} "
            "mm (deployment.release = \"force_free\")",
            1e3 * predicted_length(placed), 1e3 * (places.front() - places.back()));
    }
    notes.push_back(std::move(text));
}

}  // namespace

std::vector<std::string> apposition_notes(const PlacedDevice& placed, const WallTree& wall,
                                          const LengthUnit& unit)
{
    std::vector<std::string> notes;
    add_apposition(notes, placed, wall, unit);
    add_openings(notes, placed, unit);
    add_length(notes, placed);
    return notes;
}

}  // namespace braidzone
