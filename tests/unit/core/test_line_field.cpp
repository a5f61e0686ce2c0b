// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rtob/core/line_field.h>

#include <cmath>

using rtob::LineField;
using rtob::NeighbourGrid;
using rtob::Points;

namespace
{
/// The lines through all points, fitted within 0.15 m.
struct Field
{
    explicit Field(const Points& points)
    {
        grid.build(points.view(), 0.3);
        lines.reset(grid, 0.15);
    }
    NeighbourGrid grid;
    LineField lines;
};

Points wall(double direction_rad)
{
    Points points;
    for (int i = -20; i <= 20; ++i)
        points.add(
            static_cast<float>(0.03 * i * std::cos(direction_rad)),
            static_cast<float>(0.03 * i * std::sin(direction_rad)));
    return points;
}
}  // namespace

TEST(LineField, ANormalStandsOnItsWall)
{
    for (const double direction_rad : {0.0, 0.4, 1.5707963, 2.5, -1.0})
    {
        Field field(wall(direction_rad));
        for (std::int32_t i = 0; i < 41; ++i)
        {
            const auto& line = field.lines.at(field.grid, i);
            const double along =
                line.normal_x * std::cos(direction_rad) + line.normal_y * std::sin(direction_rad);
            EXPECT_NEAR(along, 0, 1e-3) << direction_rad;
            EXPECT_NEAR(std::hypot(line.normal_x, line.normal_y), 1, 1e-6);
        }
    }
}

TEST(LineField, PointsWithoutADirectionMakeNoLine)
{
    Points points;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
            points.add(0.03f * static_cast<float>(i), 0.03f * static_cast<float>(j));
    points.add(2, 2);  // alone
    points.add(4, 4);  // three are too few
    points.add(4.02f, 4);
    points.add(4.04f, 4);
    Field field(points);
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(points.size()); ++i)
    {
        const auto j = static_cast<std::size_t>(i);
        const float x = field.grid.points().x[j], y = field.grid.points().y[j];
        const bool middle_of_blob = x == 0.06f && y == 0.06f;
        if (x < 1 && !middle_of_blob) continue;
        EXPECT_EQ(field.lines.at(field.grid, i).normal_x, 0) << x << ", " << y;
        EXPECT_EQ(field.lines.at(field.grid, i).normal_y, 0) << x << ", " << y;
    }
}
