#pragma once

#include <vector>

namespace braidzone {

/// Value of a curve that is known at equal steps, between them by Catmull and Rom's cubic; its
/// slope is continuous. Beyond the ends it goes on along the outer pieces' cubics, which is good
/// for a fraction of a step.
/// @param values  at 0, step, 2 step, ...; at least two
/// @param step    > 0, in the unit of x
double value_on_even_curve(const std::vector<double>& values, double step, double x);

}  // namespace braidzone
