// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace rtob
{
/// A small convex polygon; may be a point or a segment. Metres. Needs no heap.
class ConvexArea
{
 public:
    static constexpr std::size_t kMaxPoints = 80;

    /// The hull of points; those beyond kMaxPoints are refused by an assertion.
    void hullOf(const Eigen::Vector2d* points, std::size_t count);

    /// From a place to the nearest one of the area; 0 inside.
    [[nodiscard]] double squaredDistance(const Eigen::Vector2d& place) const;

    /// Whether a place is nearer than this.
    [[nodiscard]] bool isWithin(const Eigen::Vector2d& place, double distance_m) const;

    /// A circle around the area.
    [[nodiscard]] const Eigen::Vector2d& circleMiddle() const { return circle_middle_; }
    [[nodiscard]] double circleRadius() const { return circle_radius_m_; }

    [[nodiscard]] const Eigen::Vector2d* begin() const { return corners_.data(); }
    [[nodiscard]] const Eigen::Vector2d* end() const { return corners_.data() + size_; }
    [[nodiscard]] std::size_t size() const { return size_; }

 private:
    void findCircle();

    struct Side
    {
        Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< unit vector to the next corner
        double length_m = 0;
    };
    std::array<Eigen::Vector2d, kMaxPoints + 1> corners_;  ///< counter-clockwise
    std::array<Side, kMaxPoints + 1> sides_;  ///< each begins at the corner of the same number
    std::size_t size_ = 0;
    Eigen::Vector2d circle_middle_ = Eigen::Vector2d::Zero();
    double circle_radius_m_ = 0;
};
}  // namespace rtob
