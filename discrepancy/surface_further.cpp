#include "discrepancy/surface_further.hpp"

#include "discrepancy/planned_measurement.hpp"

#include <utility>

namespace braidzone {

FurtherMeasurement further_measurement_of(const SurfaceData& data,
                                          const std::vector<Effect>& catalogue,
                                          const Explanation& explanation)
{
    if (explanation.verdict.finding != Finding::ambiguous) return {};
    const Observations planned =
        with_further_channels(data.observations, data.base, data.setting.base.imaging);
    const ErrorModel error = make_error_model(planned, data.floor);
    const DiagnosisProblem problem = surface_problem(
        {data.lumen, data.setting, data.base, planned, error, data.floor}, catalogue);
    PlannedRows rows = planned_rows(data.observations, planned);
    std::vector<EffectFit> answers;
    for (const Answer& answer : explanation.verdict.answers)
        answers.push_back(explanation.fits[answer.fit]);
    return further_measurement(problem, rows.measured, std::move(rows.channels), answers);
}

}  // namespace braidzone
