#include "export/lattice_json.hpp"

#include "core/file_hash.hpp"
#include "export/lattice_lbpm.hpp"
#include "export/node_box.hpp"
#include "export/text_file.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>

namespace braidzone {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json vector_as_json(const Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

/// World coordinates [m] of an index (i, j, k, 1): rows of a 4 x 4 matrix.
Json index_to_world(const VoxelGrid& grid)
{
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) {
        Json numbers = Json::array();
        for (int column = 0; column < 3; ++column)
            numbers.push_back(row == column ? grid.spacing : 0.0);
        numbers.push_back(grid.origin[row]);
        rows.push_back(numbers);
    }
    rows.push_back({0.0, 0.0, 0.0, 1.0});
    return rows;
}

Json openings_as_json(const LatticeNodes& nodes, const Vessel& vessel)
{
    Json openings = Json::array();
    for (const LatticeOpening& entry : nodes.openings) {
        const Opening& opening = vessel.openings[static_cast<std::size_t>(entry.opening)];
        openings.push_back(
            {{"cell_type", entry.code},
             {"kind",
              entry.code == static_cast<std::uint8_t>(NodeType::inlet) ? "inlet" : "outlet"},
             {"centre_m", vector_as_json(opening.centre)},
             {"normal_outwards", vector_as_json(opening.normal)},
             {"area_m2", opening.area},
             {"radius_m", opening.radius},
             {"num_nodes", entry.num_nodes}});
    }
    return openings;
}

Json units_as_json(const LatticeUnits& units, const LatticeExportOptions& options)
{
    return {{"peak_velocity_m_s", options.flow.peak_velocity},
            {"velocity_lu", options.flow.velocity_lu},
            {"time_step_s", units.time_step},
            {"viscosity_lu", units.viscosity_lu},
            {"relaxation_time_lu", units.relaxation_time_lu},
            {"mach", units.mach},
            {"largest_drag_lu", units.largest_drag_lu},
            {"largest_inertia_lu", units.largest_inertia_lu},
            {"drag", "per time step (a + b |u|) u, a = nu D dt, b = F dx / 2"}};
}

Json counts_as_json(const LatticeNodes& nodes)
{
    std::int64_t fluid = 0, wall = 0;
    for (const std::uint8_t type : nodes.type) {
        fluid += type == static_cast<std::uint8_t>(NodeType::fluid);
        wall += type == static_cast<std::uint8_t>(NodeType::wall);
    }
    return {{"all", nodes.type.size()},
            {"fluid", fluid},
            {"wall", wall},
            {"resisting", nodes.resisting.size()}};
}

Json seal_as_json(const LatticeSeal& seal, const std::vector<NeckProbe>& probes)
{
    Json necks = Json::array();
    for (std::size_t i = 0; i < probes.size(); ++i)
        necks.push_back(
            {{"centre_m", vector_as_json(probes[i].centre)}, {"layer", name_of(seal.necks[i])}});
    return {{"necks", necks}, {"num_fluid_behind", seal.num_behind}};
}

Json stability_as_json(const TargetStability& stability)
{
    const StableUnits& proposal = stability.proposal;
    return {{"is_stable", stability.doubts.empty()},
            {"doubts", stability.doubts},
            {"time_step_s", stability.time_step},
            {"velocity_lu", stability.velocity_lu},
            {"relaxation_time_lu", stability.relaxation_time_lu},
            {"largest_drag_lu", stability.largest_drag_lu},
            {"density_error", stability.density_error},
            {"proposal",
             {{"changes", proposal.changes},
              {"spacing_m", proposal.spacing},
              {"peak_velocity_m_s", proposal.peak_velocity},
              {"velocity_lu", proposal.velocity_lu},
              {"time_step_s", proposal.time_step}}}};
}

Json files_as_json(const fs::path& folder, const std::vector<LatticeFile>& files)
{
    Json list = Json::array();
    for (const LatticeFile& file : files) {
        Json entry{{"name", file.name}, {"type", file.type}};
        if (!file.shape.empty()) entry["shape"] = file.shape;
        if (!file.order.empty()) entry["order"] = file.order;
        entry["bytes"] = fs::file_size(folder / file.name);
        entry["sha256"] = sha256_of_file(folder / file.name);
        list.push_back(entry);
    }
    return list;
}

Json targets_as_json(const fs::path& folder, const LatticeDescription& lattice)
{
    Json targets = Json::object();
    for (const WrittenTarget& written : lattice.targets) {
        const TargetTraits& traits = traits_of(written.stability.target);
        Json entry{{"stability", stability_as_json(written.stability)}};
        std::optional<NodeBox> box;  // absent: the whole lattice
        if (traits.flat_openings != nullptr)
            box = box_between_openings(lattice.nodes, lattice.vessel, traits.target).box;
        if (traits.target == LatticeTarget::palabos) box = box_of_used(lattice.nodes);
        if (box) entry["box"] = {{"first", box->first}, {"dims", box->dims()}};
        if (traits.target == LatticeTarget::lbpm)
            entry["quadratic_over_sheet"] = lbpm_quadratic_ratio(lattice.nodes);
        entry["files"] = files_as_json(folder / traits.name, written.files);
        targets[traits.name] = entry;
    }
    return targets;
}

}  // namespace

void write_lattice_json(const fs::path& folder, const LatticeDescription& lattice)
{
    const LatticeNodes& nodes = lattice.nodes;
    Json json;
    json["format"] = 1;
    json["dims"] = nodes.grid.dims;
    json["spacing_m"] = nodes.grid.spacing;
    json["origin_m"] = vector_as_json(nodes.grid.origin);
    json["index_to_world_m"] = index_to_world(nodes.grid);
    json["axis_order"] =
        "node (i, j, k) at origin + spacing (i, j, k), whatever the order of a file";
    json["cell_types"] = {{"unused", 0}, {"wall", 1}, {"fluid", 2}, {"inlet", 10}, {"outlet", 11}};
    json["openings"] = openings_as_json(nodes, lattice.vessel);
    json["num_nodes"] = counts_as_json(nodes);
    json["seal"] = seal_as_json(lattice.seal, lattice.options.necks);
    json["fluid"] = {{"density_kg_m3", lattice.fluid.density},
                     {"viscosity_Pa_s", lattice.fluid.viscosity}};
    json["resistance"] = {
        {"convention", "S = -(mu D + 1/2 rho F |U|) U per volume, along the normal"},
        {"tangential_ratio", nodes.tangential_ratio.linear},
        {"tangential_ratio_quadratic", nodes.tangential_ratio.quadratic},
        {"integral_of_darcy_m", resistance_integral(nodes)}};
    json["units"] = units_as_json(lattice.units, lattice.options);
    json["targets"] = targets_as_json(folder, lattice);
    json["notes"] = lattice.notes;
    write_text_file(folder / "lattice.json", json.dump(2) + "\n");
}

}  // namespace braidzone
