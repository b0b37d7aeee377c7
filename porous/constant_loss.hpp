#pragma once

#include "core/fluid.hpp"
#include "porous/range_check.hpp"
#include "porous/rhombus.hpp"
#include "porous/sheet_loss.hpp"

#include <vector>

namespace braidzone {

/// The same given values for every rhombus, whatever its density.
struct ConstantLaw {
    static constexpr const char* name = "constant";
    SheetLoss loss;
};

inline SheetLoss sheet_loss(const ConstantLaw& law, const Rhombus& /*rhombus*/,
                            const Fluid& /*fluid*/)
{
    return law.loss;
}

/// None: the values hold where the user says so.
inline std::vector<RangeCheck> range_checks(const ConstantLaw& /*law*/, const Rhombus& /*rhombus*/,
                                            const Fluid& /*fluid*/)
{
    return {};
}

}  // namespace braidzone
