#pragma once

#include "discrepancy/diagnosis_problem.hpp"

namespace braidzone {

/// The same problem, each simulation of a candidate alone made once: for questions that ask for the
/// same ones again and again. What is remembered is shared by copies of the result.
DiagnosisProblem remembered(const DiagnosisProblem& problem);

}  // namespace braidzone
