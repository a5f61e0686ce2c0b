// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/eval/association.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "stamp_index.h"

namespace rtob
{
namespace
{
using Trajectory = std::vector<StampedPose2>;

void check_stamps(const Trajectory& trajectory, const std::string& name)
{
    if (trajectory.empty()) throw std::runtime_error("the " + name + " has no poses");
    for (std::size_t i = 0; i < trajectory.size(); ++i)
        if (!std::isfinite(trajectory[i].time_s))
            throw std::runtime_error(
                "the stamp of pose " + std::to_string(i + 1) + " of the " + name +
                " is not finite");
}

/// A pose of the shorter trajectory that wants a stamp of the longer one.
struct Claim
{
    std::size_t claimant = 0;
    std::size_t place = 0;  ///< the first with that stamp
    double difference_s = 0;
};

/// The nearest claims first; those equally near in the order of their poses.
std::vector<Claim> claims_of(const Trajectory& shorter, const StampIndex& longer)
{
    std::vector<Claim> claims;
    for (std::size_t i = 0; i < shorter.size(); ++i)
    {
        const double time_s = shorter[i].time_s;
        const auto place = longer.nearestPlace(time_s);
        claims.push_back({i, place, std::abs(longer.stampAt(place) - time_s)});
    }
    std::stable_sort(
        claims.begin(), claims.end(),
        [](const Claim& a, const Claim& b) { return a.difference_s < b.difference_s; });
    return claims;
}

struct IndexMatch
{
    std::size_t shorter = 0, longer = 0;
};

std::vector<IndexMatch> granted(
    const std::vector<Claim>& claims, const StampIndex& longer, double max_difference_s)
{
    std::vector<IndexMatch> matches;
    std::vector<std::size_t> used_at(longer.size(), 0);  // of the poses with that place's stamp
    for (const auto& claim : claims)
    {
        if (claim.difference_s > max_difference_s) break;
        const auto place = claim.place + used_at[claim.place];
        if (place == longer.size() || longer.stampAt(place) != longer.stampAt(claim.place))
            continue;
        ++used_at[claim.place];
        matches.push_back({claim.claimant, longer.pose(place)});
    }
    return matches;
}

void check_pose(const StampedPose2& stamped, const char* name)
{
    const Pose2& pose = stamped.pose;
    if (!is_finite(pose))
        throw std::runtime_error(
            "the pose of the " + std::string(name) + " at " + stamp_text(stamped.time_s) +
            " is not finite");
}

[[noreturn]] void throw_no_match(
    const StampIndex& estimate, const StampIndex& reference, double nearest_s,
    double max_difference_s)
{
    throw std::runtime_error(
        "no stamp of the estimate (" + estimate.range() + ") is within " +
        stamp_text(max_difference_s) + " of a stamp of the reference (" + reference.range() +
        "): the nearest two are " + stamp_text(nearest_s) +
        " apart. Take a reference of the same log and clock, or allow a larger difference");
}
}  // namespace

std::vector<PoseMatch> match_by_time(
    const Trajectory& estimate, const Trajectory& reference, double max_difference_s)
{
    if (!(max_difference_s >= 0))
        throw std::invalid_argument("the largest stamp difference must be at least 0 s");
    check_stamps(estimate, "estimate");
    check_stamps(reference, "reference");
    const bool estimate_claims = estimate.size() <= reference.size();
    const StampIndex longer(estimate_claims ? reference : estimate);
    const auto claims = claims_of(estimate_claims ? estimate : reference, longer);

    std::vector<PoseMatch> matches;
    for (const auto& [claimant, claimed] : granted(claims, longer, max_difference_s))
    {
        PoseMatch match;
        match.estimate_index = estimate_claims ? claimant : claimed;
        match.reference_index = estimate_claims ? claimed : claimant;
        check_pose(estimate[match.estimate_index], "estimate");
        check_pose(reference[match.reference_index], "reference");
        match.time_s = estimate[match.estimate_index].time_s;
        match.estimate = estimate[match.estimate_index].pose;
        match.reference = reference[match.reference_index].pose;
        matches.push_back(match);
    }
    if (matches.empty())
        throw_no_match(
            StampIndex(estimate), StampIndex(reference), claims.front().difference_s,
            max_difference_s);
    std::sort(
        matches.begin(), matches.end(),
        [](const PoseMatch& a, const PoseMatch& b) { return a.estimate_index < b.estimate_index; });
    return matches;
}
}  // namespace rtob
