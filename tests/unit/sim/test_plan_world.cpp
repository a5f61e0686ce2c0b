// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/sim/world_file.h>

#include <filesystem>

#include "error_message.h"
#include "temporary_folder.h"

using namespace rtob::sim;

namespace
{
/// Free, 40 x 20 cells of 0.1 m, with a wall of two columns from 3.0 to 3.2 m.
mrpt::maps::COccupancyGridMap2D hall_grid()
{
    mrpt::maps::COccupancyGridMap2D grid(0, 4, 0, 2, 0.1F);
    grid.fill(0.95F);
    for (int row = 0; row < 20; ++row)
        for (const int column : {30, 31}) grid.setCell(column, row, 0.05F);
    // One dark pixel tells up from down: lower left.
    grid.setCell(2, 1, 0.05F);
    return grid;
}

double cast(const WorldFile& file, double x, double y, double angle_rad)
{
    return Scene(file.world)
        .cast({{x, y}, 1, {std::cos(angle_rad), std::sin(angle_rad)}, 0})
        .distance_m;
}

std::string world_text(const std::string& plan)
{
    return "vehicle: {radius_m: 0.2}\nstart: {at: [1.5, 1]}\nobjects:\n  - plan: " + plan + "\n";
}

class SimPlanWorld : public testing::Test
{
 protected:
    rtob::test::TemporaryFolder folder_;
};
}  // namespace

TEST_F(SimPlanWorld, APictureIsAWorldOfItsDarkPixels)
{
    hall_grid().saveAsBitmapFile(folder_.file("hall.png"));
    const auto file =
        read_world(folder_.write("hall.yaml", world_text("{file: hall.png, resolution_m: 0.1}")));
    EXPECT_NEAR(cast(file, 1.5, 1, 0), 1.5, 1e-6);
    EXPECT_NEAR(cast(file, 3.6, 1, 3.14159265358979), 0.4, 1e-6);
    EXPECT_NEAR(cast(file, 1.5, 0.15, 3.14159265358979), 1.2, 1e-6);       // the pixel, low
    EXPECT_FALSE(std::isfinite(cast(file, 1.5, 1.85, 3.14159265358979)));  // not high
    // The start may not be in the wall.
    EXPECT_THAT(
        rtob::test::error_message<WorldError>(
            [&]
            {
                (void)read_world(folder_.write(
                    "bad.yaml",
                    "start: {at: [3.1, 1]}\nobjects:\n  - plan: {file: hall.png, "
                    "resolution_m: 0.1}\n"));
            }),
        testing::HasSubstr("bad.yaml:1: start: the vehicle starts inside a wall"));
}

TEST_F(SimPlanWorld, AGridMapBringsScaleAndPlace)
{
    auto grid = hall_grid();
    {
        mrpt::io::CFileGZOutputStream stream(folder_.file("hall.gridmap.gz"));
        auto archive = mrpt::serialization::archiveFrom(stream);
        archive << grid;
    }
    const auto file = read_world(folder_.write("hall.yaml", world_text("{file: hall.gridmap.gz}")));
    EXPECT_NEAR(cast(file, 1.5, 1, 0), 1.5, 1e-6);
    const auto moved =
        read_world(folder_.write("moved.yaml", world_text("{file: hall.gridmap.gz, at: [-1, 0]}")));
    EXPECT_NEAR(cast(moved, 0.5, 1, 0), 1.5, 1e-6);
}

TEST_F(SimPlanWorld, SaysWhatIsWrongWithAPlan)
{
    hall_grid().saveAsBitmapFile(folder_.file("hall.png"));
    const auto complaint = [&](const std::string& plan)
    {
        const auto file = folder_.write("bad.yaml", world_text(plan));
        return rtob::test::error_message<WorldError>([&] { (void)read_world(file); });
    };
    using testing::HasSubstr;
    EXPECT_THAT(complaint("{file: none.png, resolution_m: 0.1}"), HasSubstr("bad.yaml:4: "));
    EXPECT_THAT(complaint("{file: none.png, resolution_m: 0.1}"), HasSubstr("no such file"));
    EXPECT_THAT(complaint("{file: hall.png}"), HasSubstr("needs resolution_m"));
    EXPECT_THAT(complaint("{file: hall.png, resolution_m: 0}"), HasSubstr("must be > 0"));
    folder_.write("text.gridmap", "not a map");
    EXPECT_THAT(complaint("{file: text.gridmap}"), HasSubstr("is not a grid map of MRPT"));
    folder_.write("text.png", "not a picture");
    EXPECT_THAT(complaint("{file: text.png, resolution_m: 0.1}"), HasSubstr("not a picture"));
}
