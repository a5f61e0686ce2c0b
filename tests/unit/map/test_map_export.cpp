// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <rtob/map/map_export.h>
#include <rtob/map/rtob_map.h>

#include "error_message.h"
#include "temporary_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using mrpt::maps::CSimplePointsMap;
using rtob::RtobMap;
using rtob::test::error_message;
using rtob::test::TemporaryFile;
using testing::HasSubstr;

namespace
{
RtobMap small_map()
{
    rtob::Points points;
    points.add(0.1f, -2);
    points.add(1e-7f, 12345.678f);
    RtobMap map;
    map.insertScan(map.tick(3), {}, points.view());
    points.add(4, 5);
    map.insertScan(map.tick(3.5), {1, 0, 0}, points.view());
    return map;
}

std::string content(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void expect_same_points(const CSimplePointsMap& read, const RtobMap& written)
{
    EXPECT_EQ(read.getPointsBufferRef_x(), written.getPointsBufferRef_x());
    EXPECT_EQ(read.getPointsBufferRef_y(), written.getPointsBufferRef_y());
    EXPECT_EQ(read.getPointsBufferRef_z(), written.getPointsBufferRef_z());
}
}  // namespace

TEST(MapExport, PlyIsReadBackByMrpt)
{
    const TemporaryFile file(".ply");
    const RtobMap map = small_map();
    save_ply(map, file.path());
    CSimplePointsMap read;
    ASSERT_TRUE(read.loadFromPlyFile(file.path())) << read.getLoadPLYErrorString();
    expect_same_points(read, map);
}

TEST(MapExport, TextIsReadBackByMrpt)
{
    const TemporaryFile file(".txt");
    const RtobMap map = small_map();
    save_points_text(map, file.path());
    CSimplePointsMap read;
    ASSERT_TRUE(read.load3D_from_text_file(file.path()));
    expect_same_points(read, map);
}

TEST(MapExport, PcdHasItsHeaderAndOneLineAPoint)
{
    const TemporaryFile file(".pcd");
    save_pcd(small_map(), file.path());
    EXPECT_EQ(
        content(file.path()),
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 5\nHEIGHT 1\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 5\nDATA ascii\n"
        "0.1 -2 0\n1e-07 12345.678 0\n1.1 -2 0\n1.0000001 12345.678 0\n5 5 0\n");
}

TEST(MapExport, ScansAreListed)
{
    const TemporaryFile file(".txt");
    save_scans_text(small_map().scans(), file.path());
    EXPECT_EQ(content(file.path()), "# time_s x_m y_m yaw_rad points\n0 0 0 0 2\n0.5 1 0 0 3\n");
}

TEST(MapExport, AnEmptyMapGivesFilesWithoutPoints)
{
    const TemporaryFile ply(".ply"), pcd(".pcd");
    save_ply(RtobMap(), ply.path());
    save_pcd(RtobMap(), pcd.path());
    EXPECT_THAT(content(ply.path()), HasSubstr("element vertex 0\n"));
    EXPECT_THAT(content(pcd.path()), HasSubstr("POINTS 0\n"));
}

TEST(MapExport, NamesTheFileThatCannotBeWritten)
{
    const std::string file = "/nonexistent-folder/map.ply";
    EXPECT_THAT(error_message([&] { save_ply(RtobMap(), file); }), HasSubstr(file));
    EXPECT_THAT(error_message([&] { save_pcd(RtobMap(), file); }), HasSubstr(file));
    EXPECT_THAT(error_message([&] { save_points_text(RtobMap(), file); }), HasSubstr(file));
    EXPECT_THAT(error_message([&] { save_scans_text(rtob::ScanTable{}, file); }), HasSubstr(file));
    // A full disk shows at the end only.
    EXPECT_THAT(error_message([&] { save_pcd(small_map(), "/dev/full"); }), HasSubstr("/dev/full"));
}

TEST(MapExport, MrptsSaveWritesPointsAndScans)
{
    const TemporaryFile text(".txt"), ply(".ply"), scans("_scans.txt");
    const std::string prefix = text.path().substr(0, text.path().size() - 4);
    small_map().saveMetricMapRepresentationToFile(prefix);
    EXPECT_GT(std::filesystem::file_size(text.path()), 0u);
    EXPECT_GT(std::filesystem::file_size(ply.path()), 0u);
    EXPECT_THAT(content(scans.path()), HasSubstr("0.5 1 0 0 3"));
}
