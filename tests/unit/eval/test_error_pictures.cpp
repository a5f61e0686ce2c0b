// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/eval/error_pictures.h>

#include <functional>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "temporary_folder.h"

using namespace rtob;

namespace
{
constexpr double nan_d = std::numeric_limits<double>::quiet_NaN();

bool is_red(cv::Vec3b bgr)
{
    return bgr[2] > 190 && bgr[1] < 60 && bgr[0] < 60;
}
bool is_blue(cv::Vec3b bgr)
{
    return bgr[0] > 200 && bgr[1] < 150 && bgr[2] < 60;
}
bool is_grey(cv::Vec3b bgr)  // of the reference
{
    return std::abs(bgr[0] - 190) < 4 && std::abs(bgr[1] - 184) < 4 && std::abs(bgr[2] - 178) < 4;
}

/// The box around the pixels of the rows from `top` to `bottom` that pass; empty when none does.
cv::Rect bounds(
    const cv::Mat& picture, int top, int bottom, const std::function<bool(cv::Vec3b)>& passes)
{
    cv::Rect box;
    for (int row = top; row < bottom; ++row)
        for (int column = 0; column < picture.cols; ++column)
            if (passes(picture.at<cv::Vec3b>(row, column))) box |= {column, row, 1, 1};
    return box;
}

/// The part of a path picture that shows the map.
cv::Rect on_map(const cv::Mat& picture, const std::function<bool(cv::Vec3b)>& passes)
{
    return bounds(picture, 95, picture.rows - 75, passes);
}

/// 10 m to the right, the second half of it with a large error; the marks of start and end are
/// green and red, so the last metre is left without error.
ErrorPathInput straight_path()
{
    ErrorPathInput input;
    input.title = "a line";
    for (int i = 0; i <= 100; ++i)
    {
        input.path.push_back({0.1 * i, 0, 0});
        input.errors_m.push_back(i > 50 && i < 90 ? 0.4 : 0);
    }
    return input;
}
}  // namespace

TEST(DrawErrorPath, PaintsLargeErrorsRedAndSmallOnesBlue)
{
    const auto input = straight_path();
    const cv::Mat picture = draw_error_path(input);
    EXPECT_EQ(picture.type(), CV_8UC3);
    EXPECT_EQ(picture.cols, 1600);
    const cv::Rect blue = on_map(picture, is_blue);
    const int middle = picture.cols / 2;
    EXPECT_LT(blue.x, middle / 2);
    const cv::Rect red_line =
        on_map(picture(cv::Rect(0, 0, picture.cols * 85 / 100, picture.rows)), is_red);
    EXPECT_NEAR(red_line.x, middle, 25);  // from 5 m on
    EXPECT_LE(red_line.height, 6) << "a line 3 px wide";
}

TEST(DrawErrorPath, LeavesPosesWithoutErrorGrey)
{
    auto input = straight_path();
    for (auto& error_m : input.errors_m) error_m = nan_d;
    input.errors_m[30] = 0.2;
    const cv::Mat picture = draw_error_path(input);
    const cv::Rect left_half(0, 0, picture.cols / 2, picture.rows);
    const cv::Rect dot = on_map(picture(left_half), is_red);
    EXPECT_GE(dot.width, 2);
    EXPECT_LE(dot.width, 7);
    EXPECT_TRUE(on_map(picture, is_blue).empty());
}

TEST(DrawErrorPath, ShowsTheReferenceAndKeepsItInView)
{
    auto input = straight_path();
    EXPECT_TRUE(on_map(draw_error_path(input), is_grey).empty());
    input.reference = {{0, 5, 0}, {10, 5, 0}};
    const cv::Mat picture = draw_error_path(input);
    const cv::Rect reference = on_map(picture, is_grey), path = on_map(picture, is_blue);
    EXPECT_GT(reference.width, 1200);
    EXPECT_LT(reference.y + 500, path.y) << "5 m above it";
}

TEST(DrawErrorPath, DoesNotLetOneOutlierHideTheRest)
{
    auto input = straight_path();
    input.errors_m[5] = 40;  // 100 times as large
    const cv::Mat picture = draw_error_path(input);
    const cv::Rect right_half(picture.cols / 2 + 60, 0, picture.cols / 4, picture.rows);
    EXPECT_FALSE(on_map(picture(right_half), is_red).empty()) << "0.4 m is still large";
}

TEST(DrawErrorPath, CopesWithOnePoseAndZeroErrorAndPosesAstray)
{
    ErrorPathInput input;
    input.path = {{0, 0, 0}};
    input.errors_m = {0};
    EXPECT_GT(draw_error_path(input).rows, 200);
    input.path.push_back({1e30, 0, 0});
    input.errors_m.push_back(1e30);
    EXPECT_GT(draw_error_path(input).rows, 200);
}

TEST(DrawErrorPath, RefusesErrorsThatDoNotBelongToThePoses)
{
    auto input = straight_path();
    input.errors_m.pop_back();
    EXPECT_THROW(static_cast<void>(draw_error_path(input)), std::invalid_argument);
    input.errors_m.assign(input.path.size(), nan_d);
    EXPECT_THROW(static_cast<void>(draw_error_path(input)), std::invalid_argument);
}

TEST(DrawErrorPlot, HasAPanelForEachCurve)
{
    ErrorPlotInput input;
    input.title = "two curves";
    input.times_s = {1e9, 1e9 + 1, 1e9 + 2};
    input.curves = {{"first, m", {0, 1, 2}, 1, 1.3}};
    const cv::Mat one = draw_error_plot(input);
    input.curves.push_back({"second, deg", {0, 0, 0}, 0, 0});
    const cv::Mat two = draw_error_plot(input);
    EXPECT_EQ(one.cols, two.cols);
    EXPECT_GT(two.rows, one.rows + 300);
}

TEST(DrawErrorPlot, PutsDotsAtTheirTimeAndError)
{
    // Dots at 0, half and all of the time; at 0, half and all of the largest error. The axis ends
    // 8 % above that.
    ErrorPlotInput input;
    input.times_s = {100, 110, 105};
    input.curves = {{"error, m", {0, 2, 1}, 0, 0}};
    const cv::Mat picture = draw_error_plot(input);
    const cv::Rect box = bounds(picture, 100, picture.rows, is_blue);
    const cv::Rect panel(120, 128, 1330, 300);
    EXPECT_NEAR(box.x, panel.x, 3);
    EXPECT_NEAR(box.br().x, panel.br().x, 3);
    EXPECT_NEAR(box.y, panel.br().y - panel.height / 1.08, 3);
    const cv::Rect middle(panel.x + 400, 0, 530, picture.rows);
    const cv::Rect dot = bounds(picture(middle), 100, picture.rows, is_blue);
    EXPECT_NEAR(dot.x + dot.width / 2.0 + middle.x, panel.x + panel.width / 2.0, 2);
    EXPECT_NEAR(dot.y + dot.height / 2.0, panel.br().y - panel.height / 2.16, 2);
}

TEST(DrawErrorPlot, CopesWithOneErrorAndRefusesNone)
{
    ErrorPlotInput input;
    EXPECT_THROW(static_cast<void>(draw_error_plot(input)), std::invalid_argument);
    input.times_s = {5};
    input.curves = {{"error, m", {0.1}, 0.1, 0.1}};
    EXPECT_GT(draw_error_plot(input).rows, 300);
    input.curves.push_back({"too short", {}, 0, 0});
    EXPECT_THROW(static_cast<void>(draw_error_plot(input)), std::invalid_argument);
}

TEST(WriteErrorPictures, WritePng)
{
    const test::TemporaryFolder folder;
    write_error_path(folder.file("path.png"), straight_path());
    EXPECT_EQ(cv::imread(folder.file("path.png")).cols, 1600);
    EXPECT_THROW(write_error_path("/nowhere/path.png", straight_path()), std::runtime_error);
}
