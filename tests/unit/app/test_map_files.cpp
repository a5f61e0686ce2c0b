// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/serialization/CArchive.h>

#include "run/map_files.h"
#include "run/packed_object.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using testing::EndsWith;

/// One scan: the vehicle at (0, 0), a single point ahead of it.
RtobMap map_with_point(float x, float y)
{
    RtobMap map;
    Points points;
    points.add(x, y);
    map.insertScan(0, Pose2{}, points.view());
    return map;
}

TEST(WritePackedObject, GivesWhatMrptReads)
{
    const TemporaryFolder folder;
    const auto file = folder.file("a.rtob");
    write_packed_object(file, map_with_point(3, 4));
    mrpt::io::CFileGZInputStream in(file);
    RtobMap map;
    mrpt::serialization::archiveFrom(in) >> map;
    ASSERT_EQ(map.size(), 1u);
    EXPECT_EQ(map.points().y[0], 4);
}

TEST(WritePackedObject, GivesTheSameBytesAtAnyTime)
{
    const TemporaryFolder folder;
    write_packed_object(folder.file("a"), map_with_point(3, 4));
    const auto bytes = file_content(folder.file("a"));
    ASSERT_GT(bytes.size(), 10u);
    // RFC 1952: bytes 4 to 7 of the header are the time of the file.
    EXPECT_EQ(bytes.substr(4, 4), std::string(4, '\0'));
    write_packed_object(folder.file("b"), map_with_point(3, 4));
    EXPECT_EQ(bytes, file_content(folder.file("b")));
}

TEST(WritePackedObject, NamesTheFileThatCannotBeWritten)
{
    EXPECT_THROW(write_packed_object("/nowhere/a.rtob", map_with_point(3, 4)), std::runtime_error);
}

/// The laser 0.25 m ahead of the vehicle's origin sees a point 0.3 m ahead of it: with cells of
/// 0.1 m the ray frees cells 2 to 4 and ends in cell 5.
TEST(WriteMapFiles, CastsRaysFromWhereTheLaserSits)
{
    const TemporaryFolder folder;
    const auto map = map_with_point(0.55f, 0.05f);
    const double resolution_m = write_map_files(
        OutputFolder(folder.path(), false), {map, {{0.25, 0.05, 0}}, {Pose2{}}, 0.1, "title"});
    EXPECT_EQ(resolution_m, 0.1);
    const std::string row{'\xfe', '\xfe', '\xfe', '\0'};
    EXPECT_EQ(file_content(folder.file("map.pgm")), "P5\n4 1\n255\n" + row);
    EXPECT_THAT(file_content(folder.file("map.ply")), EndsWith("end_header\n0.55 0.05 0\n"));
    for (const char* name : {"map.yaml", "map.png", "map.rtob"})
        EXPECT_GT(std::filesystem::file_size(folder.file(name)), 0u) << name;
}

TEST(WriteMapFiles, TakesCoarserCellsForAHugeMap)
{
    const TemporaryFolder folder;
    RtobMap map;
    Points points;
    points.add(0, 0);
    points.add(2000, 2000);
    map.insertScan(0, Pose2{}, points.view());
    // 20000 x 20000 cells are too many, and 10000 x 10000 with room to grow are not.
    const double resolution_m = write_map_files(
        OutputFolder(folder.path(), false), {map, {Pose2{}}, {Pose2{}}, 0.1, "title"});
    EXPECT_EQ(resolution_m, 0.2);
}

TEST(WriteMapFiles, AMapOfNothingIsWrittenToo)
{
    const TemporaryFolder folder;
    write_map_files(OutputFolder(folder.path(), false), {RtobMap(), {}, {Pose2{}}, 0.1, "title"});
    EXPECT_EQ(file_content(folder.file("map.pgm")), "P5\n1 1\n255\n\xcd");
}
}  // namespace
}  // namespace rtob::test
