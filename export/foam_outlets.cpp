#include "export/foam_outlets.hpp"

#include "core/error.hpp"
#include "export/foam_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace braidzone {

namespace {

void require_one_each(std::size_t given, const char* what, std::size_t num_outlets)
{
    if (given == num_outlets) return;
    throw InputError(fmt::format("{} {} for {} outlet{}; one each is needed", given, what,
                                 num_outlets, num_outlets == 1 ? "" : "s"));
}

void set_conditions(const OutletPressures& given, const std::vector<FoamOpening*>& outlets)
{
    if (given.pressures.empty()) return;
    require_one_each(given.pressures.size(), "outlet pressures", outlets.size());
    for (std::size_t i = 0; i < outlets.size(); ++i) {
        if (!std::isfinite(given.pressures[i]))
            throw InputError(fmt::format("pressure {} Pa at {}; it must be finite",
                                         given.pressures[i], outlets[i]->name));
        outlets[i]->pressure = given.pressures[i];
    }
}

void set_conditions(const OutletShares& given, const std::vector<FoamOpening*>& outlets)
{
    const auto& shares = given.shares;
    require_one_each(shares.size(), "outlet shares", outlets.size());
    for (std::size_t i = 0; i < outlets.size(); ++i) {
        if (!(shares[i] > 0.0))
            throw InputError(fmt::format("share {:.6g} of {}; it must be positive", shares[i],
                                         outlets[i]->name));
        outlets[i]->share = shares[i];
    }
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    if (!(std::abs(sum - 1.0) <= share_tolerance))
        throw InputError(fmt::format("outlet shares sum to {:.8g}; they must sum to 1", sum));
    const auto largest = std::max_element(shares.begin(), shares.end()) - shares.begin();
    outlets[static_cast<std::size_t>(largest)]->share.reset();
}

void set_conditions(const MurraySplit&, const std::vector<FoamOpening*>& outlets)
{
    OutletShares cubes;
    for (const FoamOpening* outlet : outlets)
        cubes.shares.push_back(std::pow(outlet->area, 1.5));
    const double sum = std::accumulate(cubes.shares.begin(), cubes.shares.end(), 0.0);
    for (double& share : cubes.shares)
        share /= sum;
    set_conditions(cubes, outlets);
}

}  // namespace

std::vector<FoamOpening> foam_openings(const Vessel& vessel, int inlet, const FoamOutlets& outlets)
{
    if (inlet < 0 || inlet >= static_cast<int>(vessel.openings.size()))
        throw InputError(fmt::format("inlet is opening {}; the vessel has openings 0 to {}", inlet,
                                     vessel.openings.size() - 1));
    const std::vector<std::string> names = patch_names(vessel, inlet);
    std::vector<FoamOpening> openings(names.size());
    std::vector<FoamOpening*> those_out;
    for (std::size_t i = 0; i < names.size(); ++i) {
        openings[i].name = names[i];
        openings[i].area = vessel.openings[i].area;
        openings[i].centre = vessel.openings[i].centre;
        if (!openings[i].is_inlet()) those_out.push_back(&openings[i]);
    }
    std::visit([&](const auto& given) { set_conditions(given, those_out); }, outlets);
    return openings;
}

}  // namespace braidzone
