// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <sstream>

#include "error_message.h"
#include "run/run_options.h"
#include "temporary_file.h"
#include "usage_error.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

std::string text_of(const RunConfig& config)
{
    std::ostringstream text;
    save_run_config(text, config);
    return text.str();
}

TEST(LoadRunConfig, FlagsWinOverTheFileAndTheFileOverDefaults)
{
    const TemporaryFile file(".ini", "[Run]\nseed = 5\n[Draw]\npoints = 700\n");
    const auto config = load_run_config(file.path(), {{"--seed", "Run", "seed", "9"}});
    EXPECT_EQ(config.run.seed, 9u);
    EXPECT_EQ(config.slam.seed, 9u) << "the pipeline draws with it";
    EXPECT_EQ(config.slam.draw.points, 700);
    EXPECT_EQ(config.slam.icp.iterations, IcpOptions{}.iterations);
}

TEST(LoadRunConfig, AnEmptyFileGivesTheDefaults)
{
    const TemporaryFile file(".ini", "");
    EXPECT_EQ(text_of(load_run_config(file.path(), {})), text_of({}));
}

TEST(LoadRunConfig, ReadsBackWhatWasSaved)
{
    RunConfig config;
    config.run.seed = 18446744073709551615u;
    config.run.map_resolution_m = 0.1;
    config.slam.sensor.labels = "LASER_FRONT, LASER_REAR";
    config.slam.density.density = Density::Window;
    const TemporaryFile file(".ini", text_of(config));
    EXPECT_EQ(text_of(load_run_config(file.path(), {})), text_of(config));
    EXPECT_NE(text_of(config), text_of({}));
}

/// config/default.ini shows a few keys with the values that they have anyway.
TEST(LoadRunConfig, TheDefaultIniHoldsTheDefaults)
{
    const auto config = load_run_config(RTOB_SOURCE_DIR "/config/default.ini", {});
    EXPECT_EQ(text_of(config), text_of({}));
}

/// config/paper.ini leaves nothing on that the paper does not have.
TEST(LoadRunConfig, ThePaperIniHoldsThePapersMethod)
{
    const auto slam = load_run_config(RTOB_SOURCE_DIR "/config/paper.ini", {}).slam;
    EXPECT_EQ(slam.prealign.source, PrealignSource::LastPose);
    EXPECT_EQ(slam.density.density, Density::Revisit);
    EXPECT_EQ(slam.density.sigma_s, 1);
    EXPECT_EQ(slam.draw.points, 3600);
    EXPECT_EQ(slam.draw.mode, DrawMode::Independent);
    EXPECT_EQ(slam.icp.metric, IcpMetric::PointToPoint);
    EXPECT_EQ(slam.icp.kernel, RobustKernel::None);
    EXPECT_EQ(slam.icp.iterations, 50);
    EXPECT_EQ(slam.icp.stop_step_m, 0);
    EXPECT_EQ(slam.icp.cell_points, 0);
    EXPECT_EQ(slam.icp.max_pair_distance_m, 0.30);
    EXPECT_EQ(slam.icp.final_pair_distance_m, 0.30);
    EXPECT_FALSE(slam.search.enabled);
    EXPECT_FALSE(slam.anchor.enabled);
    EXPECT_FALSE(slam.loop_search.enabled);
}

TEST(LoadRunConfig, RefusesResolutionsThatMakeNoPicture)
{
    for (const char* resolution : {"0", "-1", "0.001", "inf"})
        EXPECT_THAT(
            error_message<UsageError>(
                [&] {
                    static_cast<void>(
                        load_run_config("", {{"--set", "Run", "map_resolution_m", resolution}}));
                }),
            AllOf(HasSubstr("[Run]"), HasSubstr("map_resolution_m")));
}

TEST(ParseSetFlag, SplitsAtTheFirstDotAndTheFirstEquals)
{
    const auto flag = parse_set_flag("Sensor.labels=a=b.c");
    EXPECT_EQ(flag.section, "Sensor");
    EXPECT_EQ(flag.key, "labels");
    EXPECT_EQ(flag.value, "a=b.c");
}

TEST(ParseSetFlag, RefusesOtherForms)
{
    for (const char* text : {"", "Draw", "Draw.points", "points=3", "points=0.5"})
        EXPECT_THROW(static_cast<void>(parse_set_flag(text)), UsageError) << text;
}
}  // namespace
}  // namespace rtob::test
