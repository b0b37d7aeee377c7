#include "discrepancy/remembered_problem.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace braidzone {
namespace {

struct Memory {
    std::mutex access;
    std::map<std::pair<std::size_t, std::vector<double>>, Eigen::VectorXd> known;
};

}  // namespace

DiagnosisProblem remembered(const DiagnosisProblem& problem)
{
    DiagnosisProblem result = problem;
    const auto memory = std::make_shared<Memory>();
    result.residuals = [problem, memory](const std::vector<ActiveEffect>& effects) {
        if (effects.size() != 1) return problem.residuals(effects);
        const std::pair key{effects.front().candidate, effects.front().values};
        {
            const std::scoped_lock lock(memory->access);
            const auto found = memory->known.find(key);
            if (found != memory->known.end()) return found->second;
        }
        Eigen::VectorXd residuals = problem.residuals(effects);
        const std::scoped_lock lock(memory->access);
        memory->known.emplace(key, residuals);
        return residuals;
    };
    return result;
}

}  // namespace braidzone
