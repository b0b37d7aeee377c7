#include "deploy/press_reading.hpp"

namespace braidzone {

ForcePoint as_read(const ForcePoint& actual, const PressReading& reading, double nominal_diameter)
{
    return {actual.displacement + reading.zero_offset,
            actual.force * (1.0 + reading.stiffening * actual.displacement / nominal_diameter)};
}

}  // namespace braidzone
