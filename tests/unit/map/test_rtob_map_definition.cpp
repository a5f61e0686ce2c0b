// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <rtob/map/rtob_map.h>

#include "error_message.h"

#include <sstream>
#include <string>

using mrpt::config::CConfigFileMemory;
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::TSetOfMetricMapInitializers;
using rtob::RtobMap;
using rtob::test::error_message;
using testing::AllOf;
using testing::HasSubstr;

/// MRPT 2.5 loses the map definition whose loading throws; the leak checker is told so.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:mrpt::maps::TSetOfMetricMapInitializers::loadFromConfigFile\n";
}

namespace
{
CMultiMetricMap maps_from(const std::string& ini)
{
    rtob::register_classes();
    const CConfigFileMemory config(ini);
    TSetOfMetricMapInitializers initializers;
    initializers.loadFromConfigFile(config, "Maps");
    CMultiMetricMap maps;
    maps.setListOfMaps(initializers);
    return maps;
}

std::string with_section(const std::string& section, const std::string& keys)
{
    return "[Maps]\nrtobMap_count = 1\n[Maps_rtobMap_00_" + section + "]\n" + keys + "\n";
}

std::string refusal(const std::string& section, const std::string& keys)
{
    return error_message<std::exception>([&] { maps_from(with_section(section, keys)); });
}
}  // namespace

TEST(RtobMapDefinition, MakesExactlyOneMap)
{
    const auto maps = maps_from("[Maps]\nrtobMap_count = 1\n");
    ASSERT_EQ(maps.maps.size(), 1u);
    const auto map = maps.mapByClass<RtobMap>();
    ASSERT_TRUE(map);
    EXPECT_EQ(map->options().draw.points, rtob::DrawOptions{}.points);
    EXPECT_TRUE(maps.getAsSimplePointsMap() == map.get());
}

TEST(RtobMapDefinition, ReadsEverySection)
{
    const auto maps = maps_from(
        "[Maps]\nrtobMap_count = 1\n"
        "[Maps_rtobMap_00_creationOpts]\ndensity = window\nwindow_s = 12 // s\npoints = 99\n"
        "seed = 18446744073709551615\nenableSaveAs3DObject = no\n"
        "[Maps_rtobMap_00_insertOpts]\nminDistBetweenLaserPoints = 0.25\nisPlanarMap = 1\n"
        "horizontalTolerance = 90\n"
        "[Maps_rtobMap_00_likelihoodOpts]\nsigma_dist = 0.125\ndecimation = 3\n"
        "[Maps_rtobMap_00_renderOpts]\npoint_size = 4\ncolor.R = 0.5\ncolormap = cmJET\n");
    const auto map = maps.mapByClass<RtobMap>();
    ASSERT_TRUE(map);
    EXPECT_EQ(map->options().density.density, rtob::Density::Window);
    EXPECT_EQ(map->options().density.window_s, 12);
    EXPECT_EQ(map->options().draw.points, 99);
    EXPECT_EQ(map->options().seed, 18446744073709551615u);
    EXPECT_FALSE(map->genericMapParams.enableSaveAs3DObject);
    EXPECT_FLOAT_EQ(map->insertionOptions.minDistBetweenLaserPoints, 0.25f);
    EXPECT_TRUE(map->insertionOptions.isPlanarMap);
    EXPECT_FLOAT_EQ(map->insertionOptions.horizontalTolerance, 1.5707964f);
    EXPECT_EQ(map->likelihoodOptions.sigma_dist, 0.125);
    EXPECT_EQ(map->likelihoodOptions.decimation, 3u);
    EXPECT_FLOAT_EQ(map->renderOptions.color.R, 0.5f);
    EXPECT_EQ(map->renderOptions.colormap, mrpt::img::cmJET);
}

TEST(RtobMapDefinition, LeavesMrptsDefaultsWhereNothingIsSaid)
{
    const auto map = maps_from("[Maps]\nrtobMap_count = 1\n").mapByClass<RtobMap>();
    const mrpt::maps::CSimplePointsMap plain;
    EXPECT_EQ(
        map->insertionOptions.minDistBetweenLaserPoints,
        plain.insertionOptions.minDistBetweenLaserPoints);
    EXPECT_NEAR(
        map->insertionOptions.horizontalTolerance, plain.insertionOptions.horizontalTolerance,
        1e-7);
    EXPECT_EQ(map->likelihoodOptions.sigma_dist, plain.likelihoodOptions.sigma_dist);
    EXPECT_EQ(map->renderOptions.colormap, plain.renderOptions.colormap);
}

TEST(RtobMapDefinition, RefusesUnknownKeysWithASuggestion)
{
    EXPECT_THAT(
        refusal("creationOpts", "window = 3"),
        AllOf(HasSubstr("creationOpts"), HasSubstr("'window'"), HasSubstr("window_s")));
    EXPECT_THAT(refusal("insertOpts", "isPlanar = 1"), HasSubstr("isPlanarMap"));
    EXPECT_THAT(refusal("likelihoodOpts", "sigma = 1"), HasSubstr("unknown key 'sigma'"));
    EXPECT_THAT(refusal("renderOpts", "pointsize = 1"), HasSubstr("point_size"));
}

TEST(RtobMapDefinition, RefusesMalformedValues)
{
    EXPECT_THAT(
        refusal("creationOpts", "points = many"), AllOf(HasSubstr("points"), HasSubstr("'many'")));
    EXPECT_THAT(refusal("creationOpts", "density = revisits"), HasSubstr("'revisit'"));
    EXPECT_THAT(refusal("insertOpts", "isPlanarMap = yess"), HasSubstr("'yess'"));
    EXPECT_THAT(refusal("renderOpts", "colormap = blue"), HasSubstr("cmHOT"));
}

TEST(RtobMapDefinition, RefusesValuesOutOfRange)
{
    EXPECT_THAT(refusal("creationOpts", "points = 3"), HasSubstr(">= 10"));
    EXPECT_THAT(refusal("likelihoodOpts", "decimation = 0"), HasSubstr(">= 1"));
    EXPECT_THAT(refusal("insertOpts", "fuseWithExisting = true"), HasSubstr("keeps every point"));
}

TEST(RtobMapDefinition, RefusesMisspeltSections)
{
    EXPECT_THAT(
        refusal("creationOptions", "points = 50"),
        AllOf(HasSubstr("creationOptions"), HasSubstr("creationOpts")));
}

TEST(RtobMapDefinition, PrintsItsOptions)
{
    RtobMap::TMapDefinition definition;
    definition.creationOpts.draw.points = 1234;
    std::ostringstream text;
    definition.dumpToTextStream(text);
    EXPECT_THAT(text.str(), HasSubstr("points = 1234"));
    EXPECT_THAT(text.str(), HasSubstr("minDistBetweenLaserPoints"));
}
