// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rtob/eval/map_picture.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "error_message.h"
#include "temporary_file.h"

using namespace rtob;
using rtob::test::error_message;
using rtob::test::TemporaryFile;

namespace
{
constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

/// The four walls of a room from (0, 0) to (10, 5), a point each centimetre.
Points room()
{
    Points points;
    for (float x = 0; x <= 10; x += 0.01f)
    {
        points.add(x, 0);
        points.add(x, 5);
    }
    for (float y = 0; y <= 5; y += 0.01f)
    {
        points.add(0, y);
        points.add(10, y);
    }
    return points;
}

cv::Mat drawn(const Points& points, const std::vector<Pose2>& path = {})
{
    return draw_map({points.view(), path, "a room"});
}

/// The pixels between header and footer whose colour passes.
std::vector<cv::Point> found(const cv::Mat& picture, const std::function<bool(cv::Vec3b)>& passes)
{
    std::vector<cv::Point> pixels;
    for (int row = 95; row < picture.rows - 75; ++row)
        for (int column = 0; column < picture.cols; ++column)
            if (passes(picture.at<cv::Vec3b>(row, column))) pixels.emplace_back(column, row);
    return pixels;
}

bool is_wall(cv::Vec3b bgr)
{
    return bgr[0] < 140 && bgr[1] < 120 && bgr[2] < 110;
}
bool is_green(cv::Vec3b bgr)
{
    return bgr[1] > 140 && bgr[0] < 120 && bgr[2] < 60;
}
bool is_red(cv::Vec3b bgr)
{
    return bgr[2] > 200 && bgr[1] < 60 && bgr[0] < 60;
}

cv::Rect bounds(const std::vector<cv::Point>& pixels)
{
    cv::Rect box;
    for (const auto& pixel : pixels) box |= cv::Rect(pixel, cv::Size(1, 1));
    return box;
}

cv::Point2d centre(const std::vector<cv::Point>& pixels)
{
    const cv::Rect box = bounds(pixels);
    return {box.x + box.width / 2.0, box.y + box.height / 2.0};
}
}  // namespace

TEST(DrawMap, ShowsTheWholeRoomInItsProportions)
{
    const cv::Mat picture = drawn(room());
    EXPECT_EQ(picture.type(), CV_8UC3);
    EXPECT_EQ(std::max(picture.cols, picture.rows), 1600);
    const cv::Rect walls = bounds(found(picture, is_wall));
    EXPECT_GT(walls.width, 0.85 * picture.cols);
    EXPECT_LT(walls.width, picture.cols - 80);
    EXPECT_NEAR(walls.width, 2 * walls.height, 6);  // 10 m x 5 m; a wall is a few pixels thick
}

TEST(DrawMap, IsNotShrunkByAFewFarPoints)
{
    Points strays = room();
    const cv::Rect walls = bounds(found(drawn(strays), is_wall));
    for (const float far : {-5000.f, 800.f, 1e9f}) strays.add(far, -far);
    EXPECT_EQ(bounds(found(drawn(strays), is_wall)), walls);
}

TEST(DrawMap, LeavesOutPointsThatAreNotFinite)
{
    Points more = room();
    const cv::Mat picture = drawn(more);
    more.add(nan_f, 1);
    more.add(1, nan_f);
    more.add(std::numeric_limits<float>::infinity(), 1);
    const cv::Mat with_nan = drawn(more);
    ASSERT_EQ(with_nan.size(), picture.size());
    EXPECT_EQ(found(with_nan, is_wall), found(picture, is_wall));
}

TEST(DrawMap, MarksStartGreenAndEndRedWithYUpwards)
{
    // From the lower left to the upper right of the room.
    std::vector<Pose2> path;
    for (int i = 0; i <= 60; ++i) path.push_back({1 + 8 * i / 60.0, 1 + 3 * i / 60.0, 0.36});
    const cv::Mat picture = drawn(room(), path);
    const cv::Rect walls = bounds(found(picture, is_wall));
    const auto green = found(picture, is_green), red = found(picture, is_red);
    ASSERT_FALSE(green.empty());
    ASSERT_FALSE(red.empty());
    const double px_per_m = walls.width / 10.0;
    EXPECT_NEAR(centre(green).x, walls.x + 1 * px_per_m, 3);
    EXPECT_NEAR(centre(green).y, walls.y + 4 * px_per_m, 3);
    EXPECT_NEAR(centre(red).x, walls.x + 9 * px_per_m, 8);  // an arrowhead is not symmetric
    EXPECT_NEAR(centre(red).y, walls.y + 1 * px_per_m, 8);
}

TEST(DrawMap, ShowsAPathThatLeavesTheMap)
{
    const cv::Mat picture = drawn(room(), {{5, 2, 0}, {5, 40, 0}, {5, 45, 1.57}});
    EXPECT_FALSE(found(picture, is_green).empty());
    EXPECT_FALSE(found(picture, is_red).empty());
}

TEST(DrawMap, LeavesOutPosesThatAreNotFiniteOrAbsurdlyFar)
{
    const double nan = nan_f;
    const std::vector<Pose2> good{{1, 1, 0}, {5, 2, 0}, {9, 4, 0}};
    const cv::Mat expected = drawn(room(), good);
    for (const Pose2& bad :
         {Pose2{nan, 1, 0}, {1, nan, 0}, {1, 1, nan}, {1e300, 1, 0}, {1, -1e9, 0}})
    {
        const cv::Mat picture = drawn(room(), {good[0], good[1], good[2], bad});
        ASSERT_EQ(picture.size(), expected.size());
        EXPECT_EQ(centre(found(picture, is_red)), centre(found(expected, is_red)));
    }
}

TEST(DrawMap, DrawsDenseWallsDarkerThanLoneReturns)
{
    Points points;
    for (int repeat = 0; repeat < 20; ++repeat)
        for (float x = 0; x <= 10; x += 0.01f) points.add(x, 0);
    points.add(5, 3);
    points.add(0, 5);
    points.add(10, 5);
    const auto walls = found(drawn(points), is_wall);
    ASSERT_FALSE(walls.empty());
    EXPECT_LT(bounds(walls).height, 12);  // the wall alone; the three returns are fainter
}

TEST(DrawMap, DrawsSomethingForNothing)
{
    const cv::Mat empty = drawn({});
    EXPECT_GE(empty.cols, 400);
    EXPECT_TRUE(found(empty, is_wall).empty());
    EXPECT_FALSE(found(drawn({}, {{7, 7, 0}}), is_green).empty());
    Points one;
    one.add(3, 4);
    EXPECT_FALSE(found(drawn(one), is_wall).empty());
}

TEST(DrawMap, KeepsToTheLongestSideForEveryShape)
{
    for (const auto& [width, height] :
         {std::pair{2.f, 300.f}, {300.f, 2.f}, {0.1f, 0.1f}, {40.f, 40.f}})
    {
        Points points;
        points.add(0, 0);
        points.add(width, height);
        for (const int side : {400, 1000, 1600})
        {
            const cv::Mat picture = draw_map({points.view(), {}, "", side});
            EXPECT_LE(std::max(picture.cols, picture.rows), side) << width << " x " << height;
        }
    }
    EXPECT_THROW((void)draw_map({{}, {}, "", 399}), std::invalid_argument);
}

TEST(WriteMapPicture, WritesThePictureAndNothingElse)
{
    const TemporaryFile file(".png", "old");
    const Points points = room();
    const MapPictureInput input{points.view(), {{1, 1, 0}, {2, 2, 0}}, "a room"};
    write_map_picture(file.path(), input);
    const cv::Mat written = cv::imread(file.path());
    ASSERT_FALSE(written.empty());
    EXPECT_EQ(cv::norm(written, draw_map(input), cv::NORM_INF), 0);
    EXPECT_FALSE(std::filesystem::exists(file.path() + ".part"));
}

TEST(WriteMapPicture, NamesTheFileThatCannotBeWritten)
{
    EXPECT_THAT(
        error_message([] { write_map_picture("/nowhere/map.png", {}); }),
        testing::HasSubstr("/nowhere/map.png"));
}
