#pragma once

#include "core/vessel.hpp"
#include "deploy/deployment.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/neck.hpp"
#include "porous/braid_surface.hpp"
#include "porous/range_check.hpp"
#include "verification/siphons/siphon.hpp"

#include <ctime>
#include <exception>
#include <string>

namespace braidzone::test {

/// What became of a siphon.
struct Outcome {
    std::string unmade;   ///< why the phantom could not be made; empty if it was
    std::string refused;  ///< why it was not deployed; empty if it was
    int inverted = 0;
    int jammed = 0;    ///< rhombi in which the wires of a family touch
    int outside = 0;   ///< nodes farther than 20 um beyond the wall
    int mouths = 0;    ///< that lie wholly behind the device
    int found = 0;     ///< of them
    int invented = 0;  ///< openings where nothing is
    double contact = 0.0;
    double cpu_time = 0.0;  ///< of the deployment [s]
};

inline bool lies_at(const WallOpening& opening, const Deployment& deployment, const Mouth& mouth)
{
    const auto place = [&](int ring) {
        return deployment.ring_arc_length[static_cast<std::size_t>(ring)];
    };
    // A fillet widens a mouth; the rings' spacing is 0.1 to 0.2 mm.
    const double margin = mouth.half_length + 0.8e-3;
    return place(opening.distal_ring) > mouth.position - margin &&
           place(opening.proximal_ring) < mouth.position + margin;
}

inline int nodes_outside(const Deployment& deployment, const WallTree& wall)
{
    int outside = 0;
    for (const Vec3& node : deployment.nodes)
        outside += !wall.contains(node) && wall.nearest(node).distance > 20e-6;
    return outside;
}

inline void count_mouths(Outcome& outcome, const Siphon& siphon, const Deployment& deployment,
                         const std::vector<WallOpening>& openings)
{
    const double distal = deployment.ring_arc_length.front();
    const double proximal = deployment.ring_arc_length.back();
    std::vector<char> explained(openings.size(), 0);
    for (const Mouth& mouth : siphon.mouths) {
        bool seen = false;
        for (std::size_t i = 0; i < openings.size(); ++i) {
            if (!lies_at(openings[i], deployment, mouth)) continue;
            seen = true;
            explained[i] = 1;
        }
        if (mouth.position + mouth.half_length > distal - 1e-3) continue;
        if (mouth.position - mouth.half_length < proximal + 1e-3) continue;
        ++outcome.mouths;
        outcome.found += seen;
    }
    for (const char is_explained : explained)
        outcome.invented += !is_explained;
}

/// Makes and deploys a siphon.
inline Outcome outcome_of(const Siphon& siphon)
{
    Outcome outcome;
    PhantomVessel made;
    try {
        made = make_phantom(siphon.phantom);
    } catch (const std::exception& error) {
        outcome.unmade = error.what();
        return outcome;
    }
    const std::clock_t start = std::clock();
    try {
        const Vessel vessel = make_vessel(made.wall, {"mm", 1e-3});
        const WallTree wall(vessel);
        ReleaseSchedule schedule;
        schedule.sliding = siphon.force_free ? 1.0 : 0.0;
        if (siphon.push) schedule.windows = {{siphon.push->first, siphon.push->second, 0.6}};
        const Deployment deployment =
            deploy(siphon.device, resample(made.centerline), wall, siphon.landing_distal, schedule);
        const std::vector<WallOpening> openings = find_openings(deployment, wall);
        const DeploymentMeasures measures =
            measure(deployment, siphon.device, wall, 3.0 * siphon.device.wire_diameter, openings);
        outcome.inverted = measures.inverted_rhombi;
        for (const Rhombus& rhombus : make_braid_surface(deployment, siphon.device).rhombi)
            outcome.jammed += is_jammed(rhombus);
        outcome.contact = measures.contact_area_fraction;
        outcome.outside = nodes_outside(deployment, wall);
        if (!deployment.converged) outcome.refused = "not at rest";
        count_mouths(outcome, siphon, deployment, openings);
    } catch (const std::exception& error) {
        outcome.refused = error.what();
    }
    outcome.cpu_time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return outcome;
}

}  // namespace braidzone::test
