// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/map/options_io.h>
#include <rtob/map/rtob_map.h>

#include "error_message.h"
#include "room.h"

#include <cstring>
#include <string>

using mrpt::io::CMemoryStream;
using mrpt::maps::CMultiMetricMap;
using mrpt::serialization::archiveFrom;
using rtob::Pose2;
using rtob::Reference;
using rtob::RtobMap;
using rtob::RtobMapOptions;
using rtob::test::error_message;
using rtob::test::room_4x3;
using testing::HasSubstr;

namespace
{
/// Every option differs from its default.
RtobMapOptions unusual_options()
{
    RtobMapOptions options;
    RtobMapOptions::fields(
        options,
        [](const char*, auto& value, const char*)
        {
            using Value = std::decay_t<decltype(value)>;
            if constexpr (std::is_arithmetic_v<Value>) value += static_cast<Value>(1.25);
        });
    options.density.density = rtob::Density::Uniform;
    options.draw.points = 50;
    options.draw.mode = rtob::DrawMode::Independent;
    return options;
}

void grow(RtobMap& map, int scans)
{
    for (int k = 0; k < scans; ++k)
    {
        const Pose2 pose{1.5, 1.0 + 0.01 * k, 0.02 * k};
        map.insertScan(map.tick(5 + 0.1 * k), pose, room_4x3().scan_vehicle(pose).view());
    }
}

std::string text_of(const RtobMapOptions& options)
{
    std::ostringstream text;
    rtob::save_options(text, "map", options);
    return text.str();
}

void expect_same(const RtobMap& read, const RtobMap& written)
{
    EXPECT_EQ(read.getPointsBufferRef_x(), written.getPointsBufferRef_x());
    EXPECT_EQ(read.getPointsBufferRef_y(), written.getPointsBufferRef_y());
    EXPECT_EQ(text_of(read.options()), text_of(written.options()));
    EXPECT_EQ(read.clock().now(), written.clock().now());
    ASSERT_EQ(read.scans().size(), written.scans().size());
    for (std::size_t k = 0; k < read.scans().size(); ++k)
    {
        EXPECT_EQ(read.scans().time(k), written.scans().time(k));
        EXPECT_EQ(read.scans().firstPoint(k), written.scans().firstPoint(k));
        EXPECT_EQ(read.scans().pose(k).yaw, written.scans().pose(k).yaw);
    }
}

RtobMap::Ptr round_trip(const RtobMap& map)
{
    CMemoryStream stream;
    auto archive = archiveFrom(stream);
    archive << map;
    stream.Seek(0);
    return std::dynamic_pointer_cast<RtobMap>(archive.ReadObject());
}
}  // namespace

TEST(RtobMapSerialization, ReadsWhatItWrote)
{
    RtobMap map(unusual_options());
    grow(map, 4);
    map.insertionOptions.minDistBetweenLaserPoints = 0.07f;
    map.likelihoodOptions.sigma_dist = 0.5;
    map.renderOptions.point_size = 3;
    map.genericMapParams.enableObservationLikelihood = false;
    const auto read = round_trip(map);
    ASSERT_TRUE(read);
    expect_same(*read, map);
    EXPECT_EQ(read->insertionOptions.minDistBetweenLaserPoints, 0.07f);
    EXPECT_EQ(read->likelihoodOptions.sigma_dist, 0.5);
    EXPECT_EQ(read->renderOptions.point_size, 3);
    EXPECT_FALSE(read->genericMapParams.enableObservationLikelihood);
}

TEST(RtobMapSerialization, ReadsAnEmptyMap)
{
    const auto read = round_trip(RtobMap());
    ASSERT_TRUE(read);
    expect_same(*read, RtobMap());
}

TEST(RtobMapSerialization, GoesOnWhereTheWrittenMapStood)
{
    RtobMap map(unusual_options());
    grow(map, 3);
    const auto read = round_trip(map);
    EXPECT_EQ(read->tick(6.0), map.tick(6.0));
    const auto scan = room_4x3().scan_vehicle({1.5, 1.2, 0});
    EXPECT_EQ(
        read->sampleFor(scan.view(), {1.5, 1.2, 0}).indices,
        map.sampleFor(scan.view(), {1.5, 1.2, 0}).indices);
}

TEST(RtobMapSerialization, SurvivesTheCopyOfAMultiMetricMap)
{
    auto map = std::make_shared<RtobMap>(unusual_options());
    grow(*map, 2);
    CMultiMetricMap maps;
    maps.maps.push_back(map);
    CMemoryStream stream;
    auto archive = archiveFrom(stream);
    archive << maps;
    stream.Seek(0);
    CMultiMetricMap read;
    archive >> read;
    ASSERT_TRUE(read.mapByClass<RtobMap>());
    expect_same(*read.mapByClass<RtobMap>(), *map);
    const CMultiMetricMap copy(maps);
    ASSERT_TRUE(copy.mapByClass<RtobMap>());
    expect_same(*copy.mapByClass<RtobMap>(), *map);
}

namespace
{
std::string bytes_of(const RtobMap& map)
{
    CMemoryStream stream;
    auto archive = archiveFrom(stream);
    archive << map;
    return {
        static_cast<const char*>(stream.getRawBufferData()),
        static_cast<std::size_t>(stream.getTotalBytesCount())};
}

std::string error_reading(const std::string& bytes)
{
    CMemoryStream stream;
    stream.assignMemoryNotOwn(bytes.data(), bytes.size());
    auto archive = archiveFrom(stream);
    return error_message<std::exception>([&] { archive.ReadObject(); });
}
}  // namespace

TEST(RtobMapSerialization, RefusesANewerFormat)
{
    RtobMap map;
    grow(map, 1);
    std::string bytes = bytes_of(map);
    EXPECT_EQ(error_reading(bytes), "");
    // The version is the byte after the class name.
    bytes[bytes.find("rtob::RtobMap") + std::strlen("rtob::RtobMap")] = 9;
    EXPECT_THAT(error_reading(bytes), HasSubstr("format 9"));
    EXPECT_THAT(error_reading(bytes), HasSubstr("newer version of rtob"));
}

TEST(RtobMapSerialization, RefusesTruncatedBytesEverywhere)
{
    RtobMap map;
    map.insertScan(0, {}, room_4x3().scan_vehicle({1, 1, 0}, {8, 0, 0.7, 6}).view());
    const std::string bytes = bytes_of(map);
    for (std::size_t length = 1; length < bytes.size(); length += 7)
        EXPECT_NE(error_reading(bytes.substr(0, length)), "") << length;
}

TEST(RtobMapSerialization, RefusesAMapWithLoosePoints)
{
    RtobMap map;
    map.insertPoint(1, 1, 0);
    EXPECT_THROW(bytes_of(map), std::exception);
}
