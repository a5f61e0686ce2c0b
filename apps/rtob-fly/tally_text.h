// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "campaign.h"

namespace rtob::fly
{
/// Head and one row of a Markdown table.
[[nodiscard]] std::string tally_head();
[[nodiscard]] std::string tally_row(const std::string& name, const CampaignTally& tally);
[[nodiscard]] std::string tally_row(
    const std::string& name, const CampaignTally& tally, const DoorTally& doors);

/// What was left out of a campaign's claim, and how often; and where contacts were.
[[nodiscard]] std::string tally_notes(const CampaignTally& tally);
}  // namespace rtob::fly
