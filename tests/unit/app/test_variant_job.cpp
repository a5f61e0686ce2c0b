// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "compare/variant_job.h"
#include "error_message.h"
#include "temporary_file.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

TEST(VariantJob, IsReadBackAsWritten)
{
    VariantJob job;
    job.log = "a \"log\".rawlog";
    job.folder = "out/x";
    job.config_file = "my.ini";
    job.sets = {"Icp.iterations=20", "ScanFilter.max_range_m=9"};
    job.limits.skip_scans = 5;
    job.limits.use_odometry = false;
    job.kind = VariantKind::Mrpt;
    job.density = "window";
    job.variant_file = "icp.ini";
    job.seed = 4;
    job.time_limit_s = 90;
    job.title = "mrpt-stock";
    const TemporaryFile file(".json");
    write_job(file.path(), job);
    const auto read = read_job(file.path());
    EXPECT_EQ(read.log, job.log);
    EXPECT_EQ(read.folder, job.folder);
    EXPECT_EQ(read.config_file, job.config_file);
    EXPECT_EQ(read.sets, job.sets);
    EXPECT_EQ(read.limits.skip_scans, 5u);
    EXPECT_EQ(read.limits.first_scans, RunLimits{}.first_scans);
    EXPECT_FALSE(read.limits.use_odometry);
    EXPECT_EQ(read.kind, VariantKind::Mrpt);
    EXPECT_EQ(read.density, job.density);
    EXPECT_EQ(read.variant_file, job.variant_file);
    EXPECT_EQ(read.seed, 4u);
    EXPECT_EQ(read.time_limit_s, 90);
    EXPECT_EQ(read.title, job.title);
}

TEST(VariantJob, ADamagedOneIsRefusedByName)
{
    const TemporaryFile file(".json", R"({"log": "a"})");
    const auto message = error_message([&] { static_cast<void>(read_job(file.path())); });
    EXPECT_THAT(message, HasSubstr(file.path()));
    EXPECT_THAT(message, HasSubstr("folder"));
}

TEST(VariantJob, AMissingOneIsRefusedByName)
{
    const auto message = error_message([] { static_cast<void>(read_job("no/job.json")); });
    EXPECT_EQ(message, "no/job.json cannot be read");
}

TEST(VariantJob, ItsConfigurationHasSeedDensityAndSets)
{
    VariantJob job;
    job.seed = 9;
    job.density = "window";
    job.sets = {"Icp.iterations=20"};
    const auto config = config_of(job);
    EXPECT_EQ(config.slam.seed, 9u);
    EXPECT_EQ(config.slam.density.density, Density::Window);
    EXPECT_EQ(config.slam.icp.iterations, 20);
}
}  // namespace
}  // namespace rtob::test
