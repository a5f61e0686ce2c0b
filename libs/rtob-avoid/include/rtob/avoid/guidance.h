// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/guard_options.h>
#include <rtob/avoid/near_obstacles.h>

#include <array>
#include <cstddef>
#include <vector>

namespace rtob
{
/// Chooses the way past obstacles: the wish's direction or one near it. Compares how far the
/// vehicle would get along the wish. A choice only: what it leads to is checked by others.
class Guidance
{
 public:
    explicit Guidance(const GuardOptions& options);

    /// @param is_closed tells of a bearing that no way may lead there
    /// @return what to add to the wish's bearing; 0 where bending does not help
    template <class IsClosed>
    [[nodiscard]] double bend(
        const NearObstacles& obstacles, double wish_bearing_rad, IsClosed&& is_closed)
    {
        sortIntoSectors(obstacles);
        measureWays(wish_bearing_rad);
        for (std::size_t way = 0; way < free_m_.size(); ++way)
            if (is_closed(wish_bearing_rad + bend_rad_[way])) free_m_[way] = 0;
        return choose();
    }

    /// Forgets which side was taken.
    void reset() { side_ = 0; }

 private:
    static constexpr int kSectors = 180;
    struct Nearest
    {
        float x = 0, y = 0, keep_m = 0, gap_m = 0;
    };
    void sortIntoSectors(const NearObstacles& obstacles);
    void measureWays(double wish_bearing_rad);
    void shorten(float ahead_m, float left_m, float keep_m);
    [[nodiscard]] double choose();
    [[nodiscard]] float worth(std::size_t way) const;

    float lookahead_m_;
    std::array<Nearest, kSectors> nearest_;  ///< obstacle of each sector; gap_m is large without
    // The ways, from right to left; the middle one is straight.
    std::vector<double> bend_rad_;
    std::vector<float> cos_bend_, sin_bend_, free_m_;
    int side_ = 0;  ///< of the last bend: 1 left, -1 right, 0 none yet
};
}  // namespace rtob
