// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/convex_area.h>
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>
#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace rtob
{
/// A point that the vehicle's middle must not come nearer to than keep_m; seen from the vehicle.
struct NearObstacle
{
    Eigen::Vector2d place_vehicle = Eigen::Vector2d::Zero();
    double keep_m = 0;
};

/// All obstacles that may matter for one decision. Their numbers lie in arrays, so that the
/// processor takes several at a time. Allocates only where it grows.
class NearObstacles
{
 public:
    explicit NearObstacles(std::size_t room = 0) { makeRoomFor(room); }

    void clear() { size_ = 0; }
    void add(const NearObstacle& obstacle);
    /// Those of the points that lie within reach of the vehicle's middle.
    void add(
        const PointsView& points, const Pose2& pose_vehicle_points, double keep_m, double reach_m);
    /// Those of others that lie nearer to an area than they should.
    void addThoseIn(const ConvexArea& area, const NearObstacles& others);

    /// What comes nearer to an area than it should must come no nearer than that.
    /// @param excused gets all of those, too
    void excuse(const ConvexArea& area, NearObstacles& excused);

    /// Calls take(i) for the numbers of those that lie nearer to an area than they should, until it
    /// says false.
    template <class Take>
    void forEachIn(const ConvexArea& area, Take&& take) const
    {
        std::array<bool, kPortion> may_be_in;
        for (std::size_t begin = 0; begin < size_; begin += kPortion)
        {
            const std::size_t count = std::min(kPortion, size_ - begin);
            if (!findCandidates(area, begin, count, may_be_in)) continue;
            for (std::size_t i = 0; i < count; ++i)
                if (may_be_in[i] && isIn(area, begin + i) && !take(begin + i)) return;
        }
    }
    [[nodiscard]] bool anyIsIn(const ConvexArea& area) const;
    /// Whether setting out in this direction brings the vehicle nearer to any of them.
    [[nodiscard]] bool anyIsAhead(const Eigen::Vector2d& direction) const;

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] NearObstacle at(std::size_t i) const { return {{x_m_[i], y_m_[i]}, keep_m_[i]}; }
    /// The numbers themselves, seen from the vehicle; size() of each.
    [[nodiscard]] const float* x() const { return x_m_.data(); }
    [[nodiscard]] const float* y() const { return y_m_.data(); }
    [[nodiscard]] const float* keep() const { return keep_m_.data(); }

    /// So many are looked at together.
    static constexpr std::size_t kPortion = 256;

 private:
    void makeRoomFor(std::size_t more);
    void dropBeyond(std::size_t begin, float reach2);
    [[nodiscard]] bool findCandidates(
        const ConvexArea& area, std::size_t begin, std::size_t count,
        std::array<bool, kPortion>& may_be_in) const;
    [[nodiscard]] bool isIn(const ConvexArea& area, std::size_t i) const
    {
        return area.isWithin({x_m_[i], y_m_[i]}, keep_m_[i]);
    }

    std::vector<float> x_m_, y_m_, keep_m_;  ///< only the first size_ count
    std::size_t size_ = 0;
};
}  // namespace rtob
