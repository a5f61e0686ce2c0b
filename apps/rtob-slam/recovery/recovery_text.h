// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "recovery/kidnap_trials.h"
#include "recovery/relocalise_trials.h"

namespace rtob
{
/// What the trials came to, for a person: a block of lines each, and a line for each trial that did
/// not go as it should.
[[nodiscard]] std::string relocalise_text(
    const std::vector<RelocaliseTrial>& done, const RelocaliseTrials& trials);
[[nodiscard]] std::string kidnap_text(
    const std::vector<KidnapTrial>& done, const KidnapTrials& trials);
}  // namespace rtob
