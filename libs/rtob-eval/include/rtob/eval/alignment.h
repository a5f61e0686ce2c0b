// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/association.h>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace rtob
{
/// How the estimate's map is laid onto the reference's before they are compared; never scaled.
enum class Alignment
{
    None,
    Origin,  ///< the first matched poses coincide, heading included
    Se2      ///< the matched positions lie as near as they can, by least squares (Umeyama 1991)
};

constexpr auto enum_names(Alignment)
{
    using Entry = std::pair<Alignment, std::string_view>;
    return std::array<Entry, 3>{
        {{Alignment::None, "none"}, {Alignment::Origin, "origin"}, {Alignment::Se2, "se2"}}};
}

/// The motion that lays the estimate's map onto the reference's. Throws std::runtime_error without
/// a match, and for Se2 where the positions leave the turn open: one pose, or a vehicle that
/// stands.
[[nodiscard]] Pose2 alignment_of(const std::vector<PoseMatch>& matches, Alignment alignment);

/// The matches with their estimates seen from the reference's map.
[[nodiscard]] std::vector<PoseMatch> moved_estimates(
    std::vector<PoseMatch> matches, const Pose2& pose_reference_estimate);
}  // namespace rtob
