#include "porous/law_comparison.hpp"

#include <algorithm>

namespace braidzone {

namespace {

/// Area of each rhombus on which its loss counts for the mean.
std::vector<double> acting_areas(const ResistanceSheet& sheet)
{
    const bool acts = std::any_of(sheet.acting.begin(), sheet.acting.end(),
                                  [](double acting) { return acting > 0.0; });
    std::vector<double> areas;
    areas.reserve(sheet.acting.size());
    for (std::size_t i = 0; i < sheet.acting.size(); ++i)
        areas.push_back(sheet.surface.rhombi[i].area * (acts ? sheet.acting[i] : 1.0));
    return areas;
}

LawComparison apply_law(const ResistanceSheet& sheet, const ResistanceLaw& law,
                        const std::vector<double>& areas)
{
    LawComparison result;
    result.law = law_name(law);
    ResistanceSheet other = sheet;
    double area = 0.0;
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const SheetLoss loss = sheet_loss(law, sheet.surface.rhombi[i], sheet.fluid);
        other.losses[i] = loss;
        area += areas[i];
        result.mean.linear += areas[i] * loss.linear;
        result.mean.quadratic += areas[i] * loss.quadratic;
    }
    result.mean.linear /= area;
    result.mean.quadratic /= area;
    result.resistance_integral = resistance_integral(other);
    result.losses = std::move(other.losses);
    result.warnings = range_warnings(law, sheet.surface.rhombi, sheet.fluid);
    return result;
}

}  // namespace

std::vector<LawComparison> compare_laws(const ResistanceSheet& sheet, const ResistanceLaw& own)
{
    std::vector<ResistanceLaw> laws = laws_without_data();
    const bool is_among_them = std::any_of(laws.begin(), laws.end(), [&](const ResistanceLaw& law) {
        return law.index() == own.index();
    });
    if (!is_among_them) laws.push_back(own);

    const std::vector<double> areas = acting_areas(sheet);
    std::vector<LawComparison> comparisons;
    comparisons.reserve(laws.size());
    for (const ResistanceLaw& law : laws) {
        // The case's own options, e.g. without inertia.
        const bool is_own = law.index() == own.index();
        comparisons.push_back(apply_law(sheet, is_own ? own : law, areas));
        comparisons.back().ratio = comparisons.back().mean.linear / comparisons.front().mean.linear;
    }
    return comparisons;
}

}  // namespace braidzone
