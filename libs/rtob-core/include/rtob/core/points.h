// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace rtob
{
/// Points that someone else owns, x and y apart as MRPT's point maps keep them. Metres.
struct PointsView
{
    const float* x = nullptr;
    const float* y = nullptr;
    std::size_t size = 0;
};

/// Points of our own, in the frame that the variable's name ends in.
struct Points
{
    std::vector<float> x, y;

    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] PointsView view() const { return {x.data(), y.data(), x.size()}; }
    void clear()
    {
        x.clear();
        y.clear();
    }
    void reserve(std::size_t n)
    {
        x.reserve(n);
        y.reserve(n);
    }
    void add(float px, float py)
    {
        x.push_back(px);
        y.push_back(py);
    }
};

/// An axis-parallel rectangle, borders included. Metres.
struct Box
{
    double min_x = 0, min_y = 0, max_x = 0, max_y = 0;

    [[nodiscard]] static Box around(double x, double y, double half_width)
    {
        return {x - half_width, y - half_width, x + half_width, y + half_width};
    }
    [[nodiscard]] bool contains(double x, double y) const
    {
        return x >= min_x && x <= max_x && y >= min_y && y <= max_y;
    }
    [[nodiscard]] bool contains(const Box& other) const
    {
        return other.min_x >= min_x && other.max_x <= max_x && other.min_y >= min_y &&
               other.max_y <= max_y;
    }
    [[nodiscard]] Box grown(double by) const
    {
        return {min_x - by, min_y - by, max_x + by, max_y + by};
    }
    /// What lies in both; contains nothing where they are apart.
    [[nodiscard]] Box common(const Box& other) const
    {
        return {
            std::max(min_x, other.min_x), std::max(min_y, other.min_y),
            std::min(max_x, other.max_x), std::min(max_y, other.max_y)};
    }
};
}  // namespace rtob
