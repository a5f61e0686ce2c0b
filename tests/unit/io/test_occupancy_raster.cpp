// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/io/occupancy_raster.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "error_message.h"

namespace rtob::test
{
namespace
{
using testing::ElementsAre;

constexpr double pi = 3.14159265358979323846;
constexpr double far_m = 100;

/// '#' occupied, '.' free, ' ' unknown; the rows as a person sees them.
std::vector<std::string> drawn(const OccupancyImage& image)
{
    std::vector<std::string> rows(image.height, std::string(image.width, '?'));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        rows[i / image.width][i % image.width] = image.pixels[i] == OccupancyImage::occupied ? '#'
                                                 : image.pixels[i] == OccupancyImage::free   ? '.'
                                                                                             : ' ';
    return rows;
}

Points one_point(float x, float y)
{
    Points points;
    points.add(x, y);
    return points;
}

TEST(OccupancyRaster, MarksARayFreeAndItsEndOccupied)
{
    OccupancyRaster raster(1.0);
    raster.add_scan({0.5, 0.5, 0}, one_point(3, 0).view(), far_m);
    const auto image = raster.image();
    EXPECT_THAT(drawn(image), ElementsAre("...#"));
    EXPECT_EQ(image.origin.x, 0);
    EXPECT_EQ(image.origin.y, 0);
    EXPECT_EQ(image.resolution_m, 1.0);
}

TEST(OccupancyRaster, PutsTheLargestYOnTop)
{
    OccupancyRaster raster(0.5);
    raster.add_scan({-0.25, -0.25, pi / 2}, one_point(1, 0).view(), far_m);  // looks along +y
    const auto image = raster.image();
    EXPECT_THAT(drawn(image), ElementsAre("#", ".", "."));
    EXPECT_EQ(image.origin.x, -0.5);
    EXPECT_EQ(image.origin.y, -0.5);
}

TEST(OccupancyRaster, StartsTheRaysAtTheLaser)
{
    OccupancyRaster raster(1.0);
    // The laser sits 2 m ahead of the vehicle, so the cells between them stay unknown.
    raster.add_scan({0.5, 0.5, 0}, one_point(4, 0).view(), far_m, {2, 0, 0});
    const auto image = raster.image();
    EXPECT_THAT(drawn(image), ElementsAre("..#"));
    EXPECT_EQ(image.origin.x, 2);
}

TEST(OccupancyRaster, CutsRaysAtTheMaximumRangeWithoutAnEnd)
{
    OccupancyRaster raster(1.0);
    raster.add_scan({0.5, 0.5, 0}, one_point(50, 0).view(), 3.0);
    EXPECT_THAT(drawn(raster.image()), ElementsAre("..."));
}

TEST(OccupancyRaster, ANeighboursRayDoesNotEraseWhatTheScanHit)
{
    OccupancyRaster raster(1.0);
    Points points = one_point(2, 0);
    for (int i = 0; i < 3; ++i) points.add(4, 0);  // three rays pass the cell that one ends in
    raster.add_scan({0.5, 0.5, 0}, points.view(), far_m);
    EXPECT_THAT(drawn(raster.image()), ElementsAre("..#.#"));  // 7 - 3 * 2 > 0
}

TEST(OccupancyRaster, WhatMovedAwayIsSeenThrough)
{
    OccupancyRaster raster(1.0);
    for (int i = 0; i < 3; ++i) raster.add_scan({0.5, 0.5, 0}, one_point(2, 0).view(), far_m);
    EXPECT_THAT(drawn(raster.image()), ElementsAre("..#"));
    for (int i = 0; i < 11; ++i) raster.add_scan({0.5, 0.5, 0}, one_point(4, 0).view(), far_m);
    EXPECT_THAT(drawn(raster.image()), ElementsAre("....#"));  // 3 * 7 - 11 * 2 < 0
    // However long it was there, it is gone soon: evidence is bounded.
    for (int i = 0; i < 1000; ++i) raster.add_scan({0.5, 0.5, 0}, one_point(2, 0).view(), far_m);
    for (int i = 0; i < 61; ++i) raster.add_scan({0.5, 0.5, 0}, one_point(4, 0).view(), far_m);
    EXPECT_EQ(drawn(raster.image())[0].substr(0, 3), "...");
}

TEST(OccupancyRaster, GrowsToAllSidesAndKeepsWhatItHad)
{
    OccupancyRaster raster(0.1);
    const double radius_m = 40;
    raster.add_scan({0.05, 0.05, 0}, one_point(1, 0).view(), far_m);
    for (int k = 0; k < 8; ++k)
        raster.add_scan({0.05, 0.05, k * pi / 4}, one_point(float(radius_m), 0).view(), far_m);
    const auto image = raster.image();
    const auto pixel_at = [&image](double x, double y)
    {
        const auto column = std::size_t((x - image.origin.x) / image.resolution_m);
        const auto row = std::size_t((y - image.origin.y) / image.resolution_m);
        return image.pixels.at((image.height - 1 - row) * image.width + column);
    };
    EXPECT_EQ(image.width, 801U);
    EXPECT_EQ(image.height, 801U);
    for (int k = 0; k < 8; ++k)
    {
        const double x = std::cos(k * pi / 4), y = std::sin(k * pi / 4);
        EXPECT_EQ(pixel_at(0.05 + radius_m * x, 0.05 + radius_m * y), OccupancyImage::occupied)
            << k;
        EXPECT_EQ(pixel_at(0.05 + 20 * x, 0.05 + 20 * y), OccupancyImage::free) << k;
    }
    EXPECT_EQ(pixel_at(1.05, 0.05), OccupancyImage::occupied);  // 7 - 2 > 0
    EXPECT_EQ(pixel_at(10, 20), OccupancyImage::unknown);
}

TEST(OccupancyRaster, SurvivesEmptyAndBrokenScans)
{
    OccupancyRaster raster(1.0);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    raster.add_scan({0, 0, 0}, Points().view(), far_m);
    raster.add_scan({0, 0, 0}, one_point(nan, 0).view(), far_m);
    raster.add_scan({0, 0, 0}, one_point(0, inf).view(), far_m);
    raster.add_scan({double(nan), 0, 0}, one_point(1, 0).view(), far_m);
    const auto image = raster.image();
    EXPECT_THAT(drawn(image), ElementsAre(" "));
}

TEST(OccupancyRaster, RefusesAPictureBeyondMemory)
{
    OccupancyRaster raster(0.01);
    raster.add_scan({0, 0, 0}, one_point(1, 0).view(), far_m);
    const auto before = raster.image().pixels;
    EXPECT_THAT(
        error_message<std::length_error>(
            [&] {
                raster.add_scan({9e5, 9e5, 0}, one_point(1, 0).view(), far_m);
            }),
        testing::HasSubstr("coarser resolution"));
    EXPECT_EQ(raster.image().pixels, before);
    EXPECT_NE(error_message<std::invalid_argument>([] { OccupancyRaster(0); }), "");
}
}  // namespace
}  // namespace rtob::test
