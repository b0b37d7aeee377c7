#pragma once

namespace braidzone::test {

/// The smallest case file.
constexpr auto smallest_case = R"([vessel]
surface = "vessel.stl"
length_unit = "mm"
[device]
name = "pipeline-flex"
diameter = "4 mm"
length = "20 mm"
[deployment]
landing_distal = "18 mm"
)";

}  // namespace braidzone::test
