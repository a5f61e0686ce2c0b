// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/map/conversions.h>
#include <rtob/map/rtob_map.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rtob
{
namespace
{
using mrpt::maps::TMatchingParams;
using mrpt::tfest::TMatchingPairList;

void check(const TMatchingParams& params)
{
    if (params.offset_other_map_points >= params.decimation_other_map_points)
        throw std::invalid_argument(
            "determineMatching2D: offset_other_map_points must be below "
            "decimation_other_map_points, which must be at least 1");
    if (params.onlyUniqueRobust && !params.onlyKeepTheClosest)
        throw std::invalid_argument(
            "determineMatching2D: onlyUniqueRobust needs onlyKeepTheClosest");
}

const mrpt::maps::CPointsMap& as_points(const mrpt::maps::CMetricMap* map)
{
    const auto* points = dynamic_cast<const mrpt::maps::CPointsMap*>(map);
    if (points == nullptr)
        throw std::invalid_argument(
            "RtobMap::determineMatching2D: only a point map can be matched against it");
    return *points;
}

/// A pair may be the farther apart, the farther its place is from the pivot (the laser).
class PairRadius
{
 public:
    explicit PairRadius(const TMatchingParams& params) : params_(params) {}

    [[nodiscard]] double at(double x_map, double y_map) const
    {
        const auto& pivot = params_.angularDistPivotPoint;
        return params_.maxDistForCorrespondence + params_.maxAngularDistForCorrespondence *
                                                      std::hypot(x_map - pivot.x, y_map - pivot.y);
    }

    /// No smaller than at() for any of the points.
    [[nodiscard]] double most(const PointsView& points, const Pose2& pose_map_points) const
    {
        if (params_.maxAngularDistForCorrespondence <= 0) return params_.maxDistForCorrespondence;
        double reach2 = 0;
        for (std::size_t i = 0; i < points.size; ++i)
        {
            const double x = points.x[i], y = points.y[i];
            reach2 = std::max(reach2, x * x + y * y);
        }
        return at(pose_map_points.x, pose_map_points.y) +
               params_.maxAngularDistForCorrespondence * std::sqrt(reach2);
    }

 private:
    const TMatchingParams& params_;
};

/// The nearest drawn point of each point of the other map. Until the pairs are complete their
/// globalIdx counts drawn points, so that filtering costs what the sample costs, not the map.
void find_pairs(
    const MatchSample& sample, const mrpt::maps::CPointsMap& other, const Pose2& pose_map_other,
    const TMatchingParams& params, TMatchingPairList& pairs)
{
    const PairRadius radius(params);
    const double c = std::cos(pose_map_other.yaw), s = std::sin(pose_map_other.yaw);
    pairs.reserve(other.size() / params.decimation_other_map_points + 1);
    for (std::size_t i = params.offset_other_map_points; i < other.size();
         i += params.decimation_other_map_points)
    {
        float x = 0, y = 0, z = 0;
        other.getPointFast(i, x, y, z);
        const double x_map = pose_map_other.x + c * x - s * y;
        const double y_map = pose_map_other.y + s * x + c * y;
        const auto near = sample.nearest(x_map, y_map, radius.at(x_map, y_map));
        if (!near) continue;
        auto& pair = pairs.emplace_back(
            static_cast<std::uint32_t>(near->drawn), static_cast<std::uint32_t>(i), 0.0f, 0.0f,
            0.0f, x, y, z);
        pair.errorSquareAfterTransformation = static_cast<float>(near->squared_distance);
    }
}

/// As MRPT's own point maps: sumSqrDist is the mean, and pairs count before they are filtered.
void describe(
    const TMatchingPairList& pairs, std::size_t other_points, const TMatchingParams& params,
    mrpt::maps::TMatchingExtraResults& extra)
{
    if (pairs.empty()) return;
    double squared_distances = 0;
    for (const auto& pair : pairs)
        squared_distances += static_cast<double>(pair.errorSquareAfterTransformation);
    extra.sumSqrDist = static_cast<float>(squared_distances / static_cast<double>(pairs.size()));
    extra.correspondencesRatio =
        static_cast<float>(params.decimation_other_map_points * pairs.size()) /
        static_cast<float>(other_points);
}
}  // namespace

const Reference& RtobMap::sampleFor(
    const PointsView& scan_vehicle, const Pose2& pose_map_vehicle) const
{
    const std::uint64_t hash = scan_hash(scan_vehicle);
    // Half the vicinity: then most of what the density takes for near still is.
    if (!matching_.sample.isFor(hash, pose_map_vehicle, state_.density.vicinity() / 2))
    {
        Random random(state_.options.seed ^ hash);
        matching_.draw.draw(
            view(), state_.density, momentAt(pose_map_vehicle), gateAround(pose_map_vehicle),
            random, matching_.sample.renew(hash));
    }
    return matching_.sample.reference();
}

void RtobMap::determineMatching2D(
    const mrpt::maps::CMetricMap* other_map, const mrpt::poses::CPose2D& other_map_pose,
    TMatchingPairList& pairs, const TMatchingParams& params,
    mrpt::maps::TMatchingExtraResults& extra) const
{
    check(params);
    const auto& other = as_points(other_map);
    const Pose2 pose = to_pose2(other_map_pose);
    extra = {};
    pairs.clear();
    if (other.empty() || empty()) return;

    const Reference& reference = sampleFor(view_of(other), pose);
    const PairRadius radius(params);
    matching_.sample.prepare(params.maxDistForCorrespondence, radius.most(view_of(other), pose));
    find_pairs(matching_.sample, other, pose, params, pairs);
    describe(pairs, other.size(), params, extra);
    if (params.onlyUniqueRobust)
    {
        TMatchingPairList unique;
        pairs.filterUniqueRobustPairs(reference.indices.size(), unique);
        pairs.swap(unique);
    }
    for (auto& pair : pairs)
    {
        const std::size_t i = reference.indices[pair.globalIdx];
        pair.globalIdx = static_cast<std::uint32_t>(i);
        pair.global = {m_x[i], m_y[i], m_z[i]};
    }
}

float RtobMap::squareDistanceToClosestCorrespondence(float x, float y) const
{
    if (matching_.sample.empty())
        return CSimplePointsMap::squareDistanceToClosestCorrespondence(x, y);
    return static_cast<float>(matching_.sample.squaredDistance(x, y));
}
}  // namespace rtob
