#include "porous/resistance_law.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

namespace {

/// From this solidity on the wires of a family touch somewhere and there is no pore to flow
/// through.
constexpr double jammed_solidity = 0.95;

/// One overload for each law.
SheetLoss loss_of(const ConstantLaw& law, const Rhombus& /*rhombus*/, const Fluid& /*fluid*/)
{
    return law.loss;
}

template <typename Law>
SheetLoss loss_of(const Law& law, const Rhombus& rhombus, const Fluid& fluid)
{
    const double densest = densest_solidity(rhombus);
    if (!(densest < jammed_solidity)) {
        throw InputError(
            fmt::format("jammed braid: wires of {:.6g} m at a spacing of {:.6g} m, solidity "
                        "{:.6g}; {} needs less than {:.6g}",
                        rhombus.wire_diameter, std::min(rhombus.spacing_a, rhombus.spacing_b),
                        densest, Law::name, jammed_solidity));
    }
    return sheet_loss(law, rhombus, fluid);
}

template <std::size_t... Indices>
std::vector<std::string> names_of(std::index_sequence<Indices...> /*all*/)
{
    return {std::variant_alternative_t<Indices, ResistanceLaw>::name...};
}

/// The given constants hold where the user says so.
std::vector<RangeCheck> range_checks(const ConstantLaw& /*law*/, const Rhombus& /*rhombus*/,
                                     const Fluid& /*fluid*/)
{
    return {};
}

}  // namespace

std::string law_name(const ResistanceLaw& law)
{
    return std::visit([](const auto& one) { return std::string(one.name); }, law);
}

std::vector<std::string> law_names()
{
    return names_of(std::make_index_sequence<std::variant_size_v<ResistanceLaw>>());
}

std::vector<ResistanceLaw> laws_without_data()
{
    return {BraidStokesLaw{}, BrundrettLaw{}, GedeonWoodLaw{},
            ErgunLaw{},       IdelchikLaw{},  ArmourCannonLaw{}};
}

SheetLoss sheet_loss(const ResistanceLaw& law, const Rhombus& rhombus, const Fluid& fluid)
{
    return std::visit([&](const auto& one) { return loss_of(one, rhombus, fluid); }, law);
}

std::vector<std::string> range_warnings(const ResistanceLaw& law,
                                        const std::vector<Rhombus>& rhombi, const Fluid& fluid)
{
    std::vector<std::vector<RangeCheck>> checks;
    checks.reserve(rhombi.size());
    for (const Rhombus& rhombus : rhombi) {
        checks.push_back(
            std::visit([&](const auto& one) { return range_checks(one, rhombus, fluid); }, law));
    }
    return range_warnings(law_name(law), checks);
}

}  // namespace braidzone
