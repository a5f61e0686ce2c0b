// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/slam/map_file.h>
#include <rtob/slam/slam.h>

#include "error_message.h"
#include "house.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
RtobMap map_of_the_house(int scans)
{
    Slam slam;
    for (int k = 0; k < scans; ++k) slam.process(scan_in_house(k));
    return slam.map();
}

TEST(MapFile, ComesBackWithPointsScansAndClock)
{
    const TemporaryFolder folder;
    const RtobMap map = map_of_the_house(30);
    save_map(folder.file("a.rtob"), map);
    const RtobMap read = load_map(folder.file("a.rtob"));
    EXPECT_EQ(map_checksum(read), map_checksum(map));
    EXPECT_EQ(read.scans().size(), map.scans().size());
    EXPECT_EQ(read.clock().now(), map.clock().now());
}

TEST(MapFile, TheSameMapGivesTheSameBytes)
{
    const TemporaryFolder folder;
    const RtobMap map = map_of_the_house(5);
    save_map(folder.file("a"), map);
    save_map(folder.file("b"), map);
    EXPECT_EQ(file_content(folder.file("a")), file_content(folder.file("b")));
}

TEST(MapFile, IsRefusedWhenCutShort)
{
    const TemporaryFolder folder;
    save_map(folder.file("a.rtob"), map_of_the_house(5));
    const std::string whole = file_content(folder.file("a.rtob"));
    const auto cut = folder.write("cut.rtob", whole.substr(0, whole.size() / 2));
    EXPECT_THAT(
        error_message([&] { (void)load_map(cut); }),
        testing::AllOf(
            testing::HasSubstr("cut.rtob: this rtob map is cut short or damaged"),
            testing::HasSubstr("Copy it again")));
}

TEST(MapFile, AnEmptyMapIsNothingToLocaliseIn)
{
    const TemporaryFolder folder;
    SlamOptions options;
    options.map.file = folder.file("a.rtob");
    options.map.localize = true;
    save_map(options.map.file, RtobMap());
    Slam slam(options);
    EXPECT_THAT(error_message([&] { enter_map(slam); }), testing::HasSubstr("a.rtob: is empty"));
}

TEST(MapChecksum, ChangesWithEveryPointAndPoseNotWithTheClock)
{
    RtobMap map;
    Points points;
    points.add(1, 2);
    map.insertScan(map.tick(10), {0, 0, 0}, points.view());
    const auto before = map_checksum(map);
    map.tick(11);
    EXPECT_EQ(map_checksum(map), before);
    RtobMap turned, moved;
    turned.insertScan(turned.tick(10), {0, 0, 1e-9}, points.view());
    EXPECT_NE(map_checksum(turned), before);
    points.y[0] = 2.0001F;
    moved.insertScan(moved.tick(10), {0, 0, 0}, points.view());
    EXPECT_NE(map_checksum(moved), before);
}
}  // namespace
}  // namespace rtob::test
