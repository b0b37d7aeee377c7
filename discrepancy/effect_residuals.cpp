#include "discrepancy/effect_residuals.hpp"

#include "core/error.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace braidzone {
namespace {

std::size_t index(Eigen::Index i)
{
    return static_cast<std::size_t>(i);
}

}  // namespace

EffectResiduals::EffectResiduals(const DiagnosisProblem& problem,
                                 std::vector<std::size_t> candidates)
    : problem_(problem), candidates_(std::move(candidates))
{
    for (const std::size_t candidate : candidates_) {
        const auto& own = problem_.candidates[candidate].parameters;
        parameters_.insert(parameters_.end(), own.begin(), own.end());
    }
}

std::vector<double> EffectResiduals::values(const Eigen::VectorXd& x) const
{
    std::vector<double> values;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const EffectParameter& p = parameters_[index(i)];
        values.push_back(std::clamp(p.prior_mean + p.prior_sd * x[i], p.lower, p.upper));
    }
    return values;
}

Eigen::VectorXd EffectResiduals::scaled(const std::vector<double>& values) const
{
    Eigen::VectorXd x(size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const EffectParameter& p = parameters_[index(i)];
        x[i] = (std::clamp(values[index(i)], p.lower, p.upper) - p.prior_mean) / p.prior_sd;
    }
    return x;
}

std::vector<ActiveEffect> EffectResiduals::effects(const std::vector<double>& values) const
{
    std::vector<ActiveEffect> effects;
    auto from = values.begin();
    for (const std::size_t candidate : candidates_) {
        const auto to =
            from + static_cast<std::ptrdiff_t>(problem_.candidates[candidate].parameters.size());
        effects.push_back({candidate, {from, to}});
        from = to;
    }
    return effects;
}

bool EffectResiduals::needs_simulation() const
{
    return std::any_of(candidates_.begin(), candidates_.end(), [&](std::size_t candidate) {
        return problem_.candidates[candidate].needs_simulation;
    });
}

std::vector<Eigen::VectorXd> EffectResiduals::at(const std::vector<Eigen::VectorXd>& places)
{
    std::vector<Eigen::VectorXd> results(places.size());
    std::vector<std::string> failures(places.size());
    std::vector<char> is_new(places.size(), 0);
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        const std::vector<double> here = values(places[i]);
        const auto known = known_.find(here);
        if (known != known_.end()) {
            results[i] = known->second;
            return;
        }
        is_new[i] = 1;
        try {
            results[i] = problem_.residuals(effects(here));
        } catch (const Error& error) {
            failures[i] = error.what();
        }
    });
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!is_new[i]) continue;
        num_runs_ += needs_simulation() ? 1 : 0;
        if (results[i].size() > 0) {
            known_.emplace(values(places[i]), results[i]);
        } else {
            failure_ = failures[i];
        }
    }
    return results;
}

std::optional<std::pair<Eigen::VectorXd, Eigen::MatrixXd>> EffectResiduals::with_derivatives(
    const Eigen::VectorXd& x)
{
    std::vector<Eigen::VectorXd> places = {x};
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const EffectParameter& p = parameters_[index(i)];
        const double step = p.step / p.prior_sd;
        const double upper = (p.upper - p.prior_mean) / p.prior_sd;
        Eigen::VectorXd moved = x;
        moved[i] += x[i] + step > upper ? -step : step;
        places.push_back(moved);
    }
    const std::vector<Eigen::VectorXd> results = at(places);
    const Eigen::VectorXd& here = results.front();
    if (here.size() == 0) return std::nullopt;
    Eigen::MatrixXd derivatives(here.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const Eigen::VectorXd& there = results[index(i) + 1];
        if (there.size() == 0) return std::nullopt;
        derivatives.col(i) = (there - here) / (places[index(i) + 1][i] - x[i]);
    }
    return std::pair{here, derivatives};
}

std::vector<Trial> EffectResiduals::trials() const
{
    std::vector<Trial> trials;
    for (const auto& [values, residuals] : known_)
        trials.push_back({values, residuals});
    return trials;
}

}  // namespace braidzone
