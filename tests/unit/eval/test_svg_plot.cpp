// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/eval/svg_plot.h>

#include <limits>

namespace rtob::test
{
namespace
{
using testing::HasSubstr;
using testing::Not;

/// A picture whose plot is 100 px wide and high: borders are 76 + 16 and 14 + 52 px.
PlotLook square_look()
{
    PlotLook look;
    look.width_px = 192;
    look.height_px = 166;
    return look;
}

std::string path_of(const std::string& svg)
{
    const auto begin = svg.rfind("<path d=\"M", svg.find("stroke-linejoin")) + 9;
    return svg.substr(begin, svg.find('"', begin) - begin);
}

TEST(SvgPlot, PutsPointsWhereTheyBelong)
{
    auto look = square_look();
    look.view = Box{0, 0, 10, 10};
    const auto svg = draw_svg_plot({{"", "red", {0, 10, 5}, {0, 10, 10}}}, look);
    // Left bottom, right top, middle top of the plot.
    EXPECT_EQ(path_of(svg), "M76.0 114.0L176.0 14.0L126.0 14.0");
}

TEST(SvgPlot, ALogarithmicAxisPutsTheGeometricMeanInTheMiddle)
{
    auto look = square_look();
    look.log_y = true;
    const auto svg = draw_svg_plot({{"", "red", {0, 1, 2}, {1, 10, 100}}}, look);
    EXPECT_EQ(path_of(svg), "M76.0 114.0L126.0 64.0L176.0 14.0");
    for (const char* label : {">1<", ">10<", ">100<"}) EXPECT_THAT(svg, HasSubstr(label));
}

TEST(SvgPlot, WithOneScaleACircleStaysRound)
{
    auto look = square_look();
    look.same_scale = true;
    // 10 m wide, 5 m high: 10 px a metre in both directions, the height in the middle.
    const auto svg = draw_svg_plot({{"", "red", {0, 10}, {0, 5}}}, look);
    EXPECT_EQ(path_of(svg), "M76.0 89.0L176.0 39.0");
}

TEST(SvgPlot, WhatIsNoNumberBreaksTheLine)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    auto look = square_look();
    look.view = Box{0, 0, 10, 10};
    const auto svg = draw_svg_plot({{"", "red", {0, 5, 5, 10}, {0, nan, 5, 10}}}, look);
    EXPECT_EQ(path_of(svg), "M76.0 114.0M126.0 64.0L176.0 14.0");
}

TEST(SvgPlot, LeavesOutPointsThatNobodyCouldSee)
{
    auto look = square_look();
    look.view = Box{0, 0, 10, 10};
    // 0.01 is a tenth of a pixel; the last point is drawn whatever its distance.
    const auto svg = draw_svg_plot({{"", "red", {0, 0.01, 10, 10.01}, {0, 0, 0, 0}}}, look);
    EXPECT_EQ(path_of(svg), "M76.0 114.0L176.0 114.0L176.1 114.0");
}

TEST(SvgPlot, TheLegendNamesTheLinesThatHaveAName)
{
    const auto svg = draw_svg_plot(
        {{"a < b", "red", {0, 1}, {0, 1}}, {"", "blue", {0, 1}, {1, 0}}}, square_look());
    EXPECT_THAT(svg, HasSubstr(">a &lt; b</text>"));
    const std::string mark = "stroke-width=\"4\"";
    EXPECT_EQ(svg.find(mark), svg.rfind(mark));  // of the line without a name there is none
}

TEST(SvgPlot, OfNothingIsStillAPicture)
{
    const auto svg = draw_svg_plot({}, {});
    EXPECT_THAT(svg, HasSubstr("<svg"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(SvgPlot, OneValueAloneIsInTheMiddle)
{
    const auto svg = draw_svg_plot({{"", "red", {3}, {7}}}, square_look());
    EXPECT_EQ(path_of(svg), "M126.0 64.0");
}
}  // namespace
}  // namespace rtob::test
