#pragma once

#include "support/hidden/hidden_case.hpp"

#include <span>
#include <vector>

namespace braidzone::blind {

/// How far each effect of a random case stands out of the noise floor beside the others: the
/// index of an ideal observer that knows its shape,
///
///     d' = sqrt(D' C^-1 D)
///
/// D what `clean_case` changes by in the patches' gaps and the ends' positions if the effect is
/// left out, C the covariance of the residuals of the scan as it was measured, with the shipped
/// noise floor (`error_model.hpp`). Near 1 nothing can be seen; a choice among 15 effects with a
/// Bayes factor of 20 takes d'^2 / 2 > 3 + ln 15, d' > 3.4, and more as parameters have to be
/// found.
/// @param made     a case of `random_case`
/// @param effects  that were hidden in it
/// @return d' of each; none for a case without effects
std::vector<double> detectability(const hidden::HiddenCase& made,
                                  std::span<const hidden::EffectChoice> effects);

}  // namespace braidzone::blind
