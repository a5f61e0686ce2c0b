// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <rtob/io/map_server.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "error_message.h"
#include "temporary_file.h"

namespace rtob::test
{
namespace
{
constexpr auto occupied = OccupancyImage::occupied, free_cell = OccupancyImage::free,
               unknown = OccupancyImage::unknown;

/// The two files of one map, removed with this object.
struct MapFiles
{
    TemporaryFile pgm{".pgm"}, yaml{".yaml"};
    std::string stem = pgm.path().substr(0, pgm.path().size() - 4);
};

/// 3 x 2 cells of 0.5 m; the picture as a person sees it.
OccupancyImage small_image()
{
    return {3, 2, 0.5, {-1, 2, 0}, {occupied, free_cell, unknown, free_cell, free_cell, occupied}};
}

std::string content_of(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(MapServer, WritesThePictureTopRowFirst)
{
    const MapFiles files;
    write_map_server(files.stem, small_image());
    EXPECT_EQ(
        content_of(files.pgm.path()), std::string("P5\n3 2\n255\n\x00\xfe\xcd\xfe\xfe\x00", 17));
}

TEST(MapServer, WritesTheYamlThatMapServerExpects)
{
    const MapFiles files;
    write_map_server(files.stem, small_image());
    const auto image_name = std::filesystem::path(files.pgm.path()).filename().string();
    EXPECT_EQ(
        content_of(files.yaml.path()),
        "image: " + image_name +
            "\nmode: trinary\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(MapServer, IsReadBackByMrptCellByCell)
{
    const MapFiles files;
    write_map_server(files.stem, small_image());
    mrpt::maps::COccupancyGridMap2D grid;
    ASSERT_TRUE(grid.loadFromROSMapServerYAML(files.yaml.path()));
    EXPECT_NEAR(grid.getXMin(), -1, 1e-6);
    EXPECT_NEAR(grid.getYMin(), 2, 1e-6);
    EXPECT_NEAR(grid.getResolution(), 0.5, 1e-6);
    ASSERT_EQ(grid.getSizeX(), 3U);
    ASSERT_EQ(grid.getSizeY(), 2U);
    // The upper row lies at y 2.5 to 3.0; MRPT's cells hold the probability of being free.
    EXPECT_LT(grid.getPos(-0.75F, 2.75F), 0.1F);
    EXPECT_GT(grid.getPos(-0.25F, 2.75F), 0.9F);
    EXPECT_GT(grid.getPos(-0.75F, 2.25F), 0.9F);
    EXPECT_LT(grid.getPos(0.25F, 2.25F), 0.1F);
    const float unknown_cell = grid.getPos(0.25F, 2.75F);
    EXPECT_GT(unknown_cell, 0.1F);
    EXPECT_LT(unknown_cell, 0.9F);
}

TEST(MapServer, RefusesContradictingSizes)
{
    const MapFiles files;
    auto image = small_image();
    image.width = 4;
    const auto error =
        error_message<std::invalid_argument>([&] { write_map_server(files.stem, image); });
    EXPECT_THAT(error, testing::HasSubstr("width x height"));
    EXPECT_FALSE(std::filesystem::exists(files.pgm.path()));
    EXPECT_NE(error_message<std::invalid_argument>([&] { write_map_server(files.stem, {}); }), "");
}

TEST(MapServer, NamesTheFileThatCannotBeWritten)
{
    EXPECT_THAT(
        error_message([] { write_map_server("/nowhere/map", small_image()); }),
        testing::HasSubstr("/nowhere/map.pgm"));
}
}  // namespace
}  // namespace rtob::test
