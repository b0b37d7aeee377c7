#include "export/lattice_export.hpp"

#include "core/place_text.hpp"
#include "export/lattice_arrays.hpp"
#include "export/lattice_cost.hpp"
#include "export/lattice_hemoflow.hpp"
#include "export/lattice_json.hpp"
#include "export/lattice_lbpm.hpp"
#include "export/lattice_openlb.hpp"
#include "export/lattice_readme.hpp"
#include "export/lattice_stability.hpp"
#include "export/node_box.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

namespace {

namespace fs = std::filesystem;

/// What the targets leave out.
std::vector<std::string> omission_notes(const LatticeNodes& nodes,
                                        const LatticeExportOptions& options)
{
    std::vector<std::string> notes;
    const bool is_quadratic = std::any_of(nodes.forchheimer.begin(), nodes.forchheimer.end(),
                                          [](double value) { return value > 0.0; });
    for (const LatticeTarget target : options.targets) {
        const TargetTraits& traits = traits_of(target);
        if (!traits.has_linear) {
            notes.push_back(fmt::format("lattice: {} takes the walls, not the device's resistance",
                                        traits.name));
            continue;
        }
        if (target == LatticeTarget::lbpm) {
            notes.push_back(fmt::format("lattice: lbpm takes {}, {:.3g} times the sheet's",
                                        traits.quadratic_limit, lbpm_quadratic_ratio(nodes)));
        } else if (traits.quadratic_limit != nullptr && is_quadratic) {
            notes.push_back(
                fmt::format("lattice: {} takes {}", traits.name, traits.quadratic_limit));
        }
        if (!traits.has_normal && nodes.tangential_ratio.linear != 1.0)
            notes.push_back(
                fmt::format("lattice: {} has one resistance for all directions: the normal one, "
                            "instead of {:.4g} times that along the sheet",
                            traits.name, nodes.tangential_ratio.linear));
    }
    return notes;
}

std::vector<std::string> seal_notes(const LatticeSeal& seal, const std::vector<NeckProbe>& probes,
                                    const LengthUnit& unit)
{
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        if (seal.necks[i] != NeckSeal::leaks) continue;
        notes.push_back(fmt::format(
            "lattice: at {} nodes without resistance lead around the device into what lies behind "
            "it; take a finer grid.spacing, if the device itself closes there",
            place_text(probes[i].centre, unit)));
    }
    return notes;
}

std::vector<LatticeFile> write_target(LatticeTarget target, const fs::path& folder,
                                      const LatticeNodes& nodes, const Vessel& vessel,
                                      const Fluid& fluid, const LatticeUnits& units,
                                      const LatticeFlowOptions& flow)
{
    switch (target) {
        case LatticeTarget::numpy:
            return write_lattice_arrays(folder, nodes);
        case LatticeTarget::openlb:
            return write_openlb(folder, nodes, fluid, units);
        case LatticeTarget::palabos:
            return {write_palabos_geometry(folder / "geometry.dat", nodes, box_of_used(nodes))};
        case LatticeTarget::walberla:
            return {write_walberla_mask(folder / "mask_u8.raw", nodes)};
        case LatticeTarget::hemoflow:
            return write_hemoflow(folder, nodes, vessel, fluid, flow);
        case LatticeTarget::lbpm:
            return write_lbpm(folder, nodes, vessel, units, flow);
    }
    return {};
}

void append(std::vector<std::string>& notes, const std::vector<std::string>& more)
{
    notes.insert(notes.end(), more.begin(), more.end());
}

}  // namespace

double extension_clearance(double spacing)
{
    return 3.0 * spacing;
}

std::vector<std::string> write_lattice(const fs::path& folder, const LatticeNodes& nodes,
                                       const Vessel& vessel, const Fluid& fluid,
                                       const LatticeExportOptions& options)
{
    const LatticeUnits units = propose_units(nodes, fluid, options.flow);
    std::vector<WrittenTarget> targets;
    std::vector<TargetStability> stabilities;
    for (const LatticeTarget target : options.targets) {
        const fs::path place = folder / target_name(target);
        write_text_file(place / "README.md", lattice_readme(target));
        stabilities.push_back(stability_of(target, nodes, fluid, options.flow));
        targets.push_back({stabilities.back(),
                           write_target(target, place, nodes, vessel, fluid, units, options.flow)});
    }
    const LatticeSeal seal = lattice_seal(nodes, options.necks);
    std::vector<std::string> notes = omission_notes(nodes, options);
    append(notes, stability_notes(stabilities));
    append(notes, seal_notes(seal, options.necks, vessel.unit));
    write_lattice_json(folder, {nodes, vessel, fluid, options, units, seal, targets, notes});
    return notes;
}

std::vector<std::string> export_lattice(const fs::path& folder, const PorousField& field,
                                        const Vessel& vessel, const Fluid& fluid,
                                        const LatticeExportOptions& options)
{
    const double spacing = field.grid.spacing;
    const ExtendedVessel extended =
        extend_openings(vessel, {.faces = options.openings,
                                 .inlet = options.inlet,
                                 .clearance = extension_clearance(spacing)});
    fs::create_directories(folder);
    require_room(lattice_cost(extended.vessel, spacing, options.targets), room_at(folder));
    std::vector<std::string> notes = describe(extended.tubes, vessel);
    append(notes, write_lattice(folder, make_lattice_nodes(field, extended.vessel, options.inlet),
                                extended.vessel, fluid, options));
    return notes;
}

}  // namespace braidzone
