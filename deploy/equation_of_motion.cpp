#include "deploy/equation_of_motion.hpp"

namespace braidzone {

double next_displacement(const VerletScheme& scheme, double last_displacement, double force)
{
    const double half_loss = 0.5 * scheme.damping * scheme.time_step / scheme.mass;
    const double impulse = scheme.time_step * scheme.time_step / scheme.mass;
    return ((1.0 - half_loss) * last_displacement + impulse * force) / (1.0 + half_loss);
}

}  // namespace braidzone
