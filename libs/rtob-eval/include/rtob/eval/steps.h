// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

/// Which pairs of poses a relative error looks at; evo's rules.
namespace rtob
{
enum class DeltaUnit
{
    Frames,
    Metres  ///< along the path
};

enum class StepChoice
{
    Consecutive,  ///< each step begins where the last one ended
    All           ///< a step from every pose, as far as there is one
};

constexpr auto enum_names(DeltaUnit)
{
    using Entry = std::pair<DeltaUnit, std::string_view>;
    return std::array<Entry, 2>{{{DeltaUnit::Frames, "frames"}, {DeltaUnit::Metres, "metres"}}};
}

constexpr auto enum_names(StepChoice)
{
    using Entry = std::pair<StepChoice, std::string_view>;
    return std::array<Entry, 2>{
        {{StepChoice::Consecutive, "consecutive"}, {StepChoice::All, "all"}}};
}

struct StepOptions
{
    double delta = 1;  ///< > 0; a whole number of frames
    DeltaUnit unit = DeltaUnit::Frames;
    StepChoice choice = StepChoice::Consecutive;
    double tolerance = 0.1;  ///< of delta, >= 0; only for all steps in metres
};

struct Step
{
    std::size_t from = 0, to = 0;
};

/// The steps along a path. Consecutive steps in metres end with the first pose that is at least
/// delta away; of all steps in metres, each ends with the pose whose distance is nearest to delta,
/// and counts when that is within the tolerance. May be none. Throws std::invalid_argument for
/// options out of range.
[[nodiscard]] std::vector<Step> steps_along(
    const std::vector<Pose2>& path, const StepOptions& options);
}  // namespace rtob
