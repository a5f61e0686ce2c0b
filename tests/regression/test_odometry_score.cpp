// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/eval/relations.h>
#include <rtob/io/log_reader.h>

#include <cstdlib>
#include <string>

using mrpt::obs::CObservationOdometry;

namespace
{
std::vector<rtob::StampedPose2> odometry_of(const std::string& log)
{
    std::vector<rtob::StampedPose2> trajectory;
    const auto reader = rtob::open_log(log);
    while (const auto entry = reader->next())
    {
        const auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(entry->observation);
        if (!odometry) continue;
        const auto& pose = odometry->odometry;
        trajectory.push_back(
            {mrpt::Clock::toDouble(odometry->timestamp), {pose.x(), pose.y(), pose.phi()}});
    }
    return trajectory;
}
}  // namespace

/// Reader and metric together against figures that were computed apart from them, from the logs'
/// text.
TEST(OdometryScore, OfTheIntelLogIsTheKnownOne)
{
    const char* const folder = std::getenv("RTOB_DATASETS");
    if (!folder) GTEST_SKIP() << "RTOB_DATASETS is not set";
    const std::string intel = std::string(folder) + "/intel/intel";
    const auto errors = rtob::relation_errors(
        odometry_of(intel + ".clf.bz2"), rtob::read_relations(intel + ".relations.gz"));
    EXPECT_EQ(errors.unmatched_relations, 0u);
    EXPECT_NEAR(errors.distance_m.mean, 7.37, 0.005);  // known to two decimals
}
