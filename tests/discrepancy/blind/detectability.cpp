#include "discrepancy/blind/detectability.hpp"

#include "discrepancy/blind/case_folder.hpp"
#include "discrepancy/error_model.hpp"
#include "discrepancy/hub_slopes.hpp"
#include "discrepancy/whitening.hpp"

#include <map>
#include <utility>

namespace braidzone::blind {
namespace {

/// Gaps by row and column of the patch [m].
using Gaps = std::map<std::pair<int, int>, double>;

Gaps gaps_of(const hidden::HiddenCase& clean, const Simulation& base)
{
    Gaps gaps;
    for (const Patch& patch : make_discrepancy_field(clean.scan.points, {}, base).patches)
        gaps[{patch.row, patch.column}] = patch.gap;
    return gaps;
}

/// What the observations change by from one case to the other. A patch that either lacks, at an
/// end that one reaches and the other does not, tells nothing: there the ends do.
Eigen::VectorXd change(const Observations& observations, const hidden::HiddenCase& from,
                       const hidden::HiddenCase& to, const Simulation& base)
{
    const Gaps before = gaps_of(from, base), after = gaps_of(to, base);
    Eigen::VectorXd changes = Eigen::VectorXd::Zero(num_residuals(observations));
    const ResidualRows rows = residual_rows(observations);
    for (Eigen::Index i = 0; i < rows.num_patches; ++i) {
        const Patch& patch = observations.field.patches[static_cast<std::size_t>(i)];
        const auto one = before.find({patch.row, patch.column});
        const auto other = after.find({patch.row, patch.column});
        if (one != before.end() && other != after.end()) changes[i] = other->second - one->second;
    }
    Eigen::Index row = rows.lengths;
    for (std::size_t i = 0; i < scalar_names.size(); ++i) {
        if (!observations.scalars.values[i]) continue;
        changes[row++] = to.scan.ends.values[i]->value - from.scan.ends.values[i]->value;
    }
    return changes;
}

}  // namespace

std::vector<double> detectability(const hidden::HiddenCase& made,
                                  std::span<const hidden::EffectChoice> effects)
{
    if (effects.empty()) return {};
    const Model model = believed_model(made.belief);
    const Lumen lumen = believed_lumen(made.belief.phantom);
    const Simulation base = simulate(model, lumen);
    Observations observations{made.scan.points, make_discrepancy_field(made.scan.points, {}, base),
                              made.scan.ends};
    set_hub_slopes(observations, model, base, lumen);
    const Whitening whitening(make_error_model(observations, NoiseFloor{}).covariance());
    const hidden::HiddenCase all = hidden::clean_case(effects, made.seed);
    std::vector<double> indices;
    for (std::size_t i = 0; i < effects.size(); ++i) {
        const hidden::HiddenCase less = hidden::clean_case(effects, made.seed, i);
        indices.push_back(whitening(change(observations, less, all, base)).norm());
    }
    return indices;
}

}  // namespace braidzone::blind
