#include "porous/resistance_law.hpp"

#include <utility>
#include <variant>

namespace braidzone {

namespace {

template <std::size_t... Indices>
std::vector<std::string> names_of(std::index_sequence<Indices...> /*all*/)
{
    return {std::variant_alternative_t<Indices, ResistanceLaw>::name...};
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
    if (const auto* given = std::get_if<ConstantLaw>(&law)) return given->loss;
    const Rhombus cell = opened_to_limit(rhombus);
    return std::visit([&](const auto& one) { return sheet_loss(one, cell, fluid); }, law);
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
