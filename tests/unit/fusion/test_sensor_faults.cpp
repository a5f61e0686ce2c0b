// SPDX-License-Identifier: BSD-3-Clause
// A sensor that dies, lags, repeats itself or steps back in time: the pose gets no worse than
// without it, and the watch names what is wrong.
#include <gmock/gmock.h>
#include <rtob/fusion/sensor_watch.h>

#include <deque>
#include <functional>
#include <limits>

#include "motion_run.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;
using Kind = Measurement::Kind;
/// What arrives in place of a reading of the flow, at the time when it was to arrive.
using Fault = std::function<std::vector<Measurement>(const Measurement&)>;

struct Outcome
{
    double rms_m = 0;
    SensorWatch flow;
    double end_s = 0;
};

/// Of the pose just before each scan, over a few runs; flow passes through the fault.
Outcome outcome_of(const std::function<Fault()>& new_fault, bool has_flow = true)
{
    Outcome outcome;
    double sum = 0, count = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
    {
        MotionRunOptions options;
        options.scan_hz = 2;
        options.odometry = false;
        options.flow = has_flow;
        MotionRun run(options, seed);
        auto filter = started_filter(FusionOptions(run_options()));
        SensorWatch watch;
        const Fault fault = new_fault();
        while (run.time_s() < options.duration_s)
            for (const auto& each : run.step())
            {
                if (each.kind == Kind::Pose)
                {
                    const MotionState state = filter.at(run.time_s());
                    sum += (state.mean - run.truth()).head<2>().squaredNorm(), ++count;
                    filter.addPose(each);
                }
                else if (each.kind != Kind::Velocity)
                    filter.add(each);
                else
                    for (const auto& arrived : fault(each))
                    {
                        if (watch.admit(arrived, filter.newest()) != ReadingFate::Used) continue;
                        const auto innovation = filter.add(arrived);
                        if (innovation)
                            watch.took(*innovation);
                        else
                            watch.refused(ReadingFate::TooLate);
                    }
            }
        outcome.flow = watch;
        outcome.end_s = run.time_s();
    }
    outcome.rms_m = std::sqrt(sum / count);
    return outcome;
}

Fault no_fault()
{
    return [](const Measurement& each) { return std::vector<Measurement>{each}; };
}

double rms_without_flow()
{
    return outcome_of(no_fault, false).rms_m;
}
}  // namespace

TEST(SensorFaults, AGoodSensorHelpsAndIsNotNamed)
{
    const auto good = outcome_of(no_fault);
    EXPECT_LT(good.rms_m, 0.5 * rms_without_flow());
    EXPECT_EQ(good.flow.complaint(good.end_s), "");
    EXPECT_NEAR(good.flow.meanNis(), 1, 0.2);
}

TEST(SensorFaults, ADeadSensorIsNamed)
{
    const auto dead = outcome_of(
        []
        {
            return [](const Measurement& each)
            { return each.time_s < 10 ? std::vector{each} : std::vector<Measurement>{}; };
        });
    EXPECT_LT(dead.rms_m, rms_without_flow());
    EXPECT_THAT(dead.flow.complaint(dead.end_s), HasSubstr("silent for the last 10.0 s"));
}

TEST(SensorFaults, ASensorWhoseReadingsArriveLateIsAsGoodAndNamed)
{
    const auto late = outcome_of(
        []
        {
            return [queue = std::deque<Measurement>()](const Measurement& each) mutable
            {
                queue.push_back(each);
                if (queue.size() <= 6) return std::vector<Measurement>{};  // 6 of 20 Hz are 300 ms
                const Measurement first = queue.front();
                queue.pop_front();
                return std::vector{first};
            };
        });
    EXPECT_LT(late.rms_m, 0.8 * rms_without_flow());
    EXPECT_THAT(late.flow.complaint(late.end_s), HasSubstr("late by 0.3"));
}

/// Old readings with new stamps are wrong, and no reading by itself tells.
TEST(SensorFaults, ASensorThatLagsUnderAFalseStampDoesLittleHarm)
{
    const auto lagging = outcome_of(
        []
        {
            return [queue = std::deque<Measurement>()](Measurement each) mutable
            {
                queue.push_back(each);
                each.value = queue.front().value;
                if (queue.size() > 6) queue.pop_front();
                return std::vector{each};
            };
        });
    EXPECT_LT(lagging.rms_m, 1.2 * rms_without_flow());
}

TEST(SensorFaults, RepeatedReadingsAreRefusedAndNamed)
{
    const auto repeating = outcome_of(
        [] { return [](const Measurement& each) {
                 return std::vector{each, each, each};
             }; });
    EXPECT_DOUBLE_EQ(repeating.rms_m, outcome_of(no_fault).rms_m);
    EXPECT_THAT(repeating.flow.complaint(repeating.end_s), HasSubstr("repeat a stamp"));
}

TEST(SensorFaults, StampsThatStepBackAreRefusedAndNamed)
{
    const auto stepping = outcome_of(
        []
        {
            return [](const Measurement& each)
            {
                Measurement old = each;
                old.time_s -= 0.5;
                old.value.setConstant(3);
                return std::vector{each, old};
            };
        });
    EXPECT_DOUBLE_EQ(stepping.rms_m, outcome_of(no_fault).rms_m);
    EXPECT_THAT(stepping.flow.complaint(stepping.end_s), HasSubstr("step back in time"));
}

TEST(SensorFaults, AStuckSensorIsRefusedAndNamed)
{
    const auto stuck = outcome_of(
        []
        {
            return [](Measurement each)
            {
                if (each.time_s > 5) each.value = {0.3, 0.1, 0};
                return std::vector{each};
            };
        });
    EXPECT_LT(stuck.rms_m, 2 * rms_without_flow());
    EXPECT_THAT(stuck.flow.complaint(stuck.end_s), HasSubstr("are stuck at one value"));
}

TEST(SensorWatch, RefusesWhatIsNoNumber)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    SensorWatch watch;
    const Measurement good{Kind::YawRate, 1, {0.1, 0, 0}, Eigen::Matrix3d::Identity()};
    auto bad_value = good, bad_stamp = good, bad_covariance = good;
    bad_value.value[0] = nan;
    bad_stamp.time_s = nan;
    bad_covariance.covariance(0, 0) = 0;
    EXPECT_EQ(watch.admit(bad_value, nan), ReadingFate::NotFinite);
    EXPECT_EQ(watch.admit(bad_stamp, nan), ReadingFate::NotFinite);
    EXPECT_EQ(watch.admit(bad_covariance, nan), ReadingFate::BadCovariance);
    bad_covariance.covariance(0, 0) = nan;
    EXPECT_EQ(watch.admit(bad_covariance, nan), ReadingFate::BadCovariance);
    EXPECT_EQ(watch.admit(good, nan), ReadingFate::Used);
    EXPECT_EQ(watch.with(ReadingFate::NotFinite), 2U);
    EXPECT_EQ(watch.with(ReadingFate::BadCovariance), 2U);
    EXPECT_THAT(watch.complaint(1), HasSubstr("2 of 4 readings are no numbers"));
}

/// A covariance with an eigenvalue below 0, though all variances are positive.
TEST(SensorWatch, RefusesACovarianceThatIsNotPositive)
{
    SensorWatch watch;
    Measurement pose{Kind::Pose, 1, {0, 0, 0}, Eigen::Matrix3d::Identity()};
    pose.covariance(0, 1) = pose.covariance(1, 0) = 2;
    EXPECT_EQ(watch.admit(pose, 1), ReadingFate::BadCovariance);
}

TEST(SensorWatch, DoesNotTakeAVehicleThatStandsForAStuckSensor)
{
    SensorWatch watch;
    for (int i = 0; i < 200; ++i)
    {
        const Measurement pose{Kind::WayBegin, 0.1 * i, {3, 2, 1}, Eigen::Matrix3d::Identity()};
        EXPECT_EQ(watch.admit(pose, 0.1 * i), ReadingFate::Used) << i;
    }
    EXPECT_EQ(watch.complaint(20), "");
}

TEST(SensorWatch, RefusesAStampFromTheFuture)
{
    SensorWatch watch;
    const Measurement ahead{Kind::YawRate, 100, {0.1, 0, 0}, Eigen::Matrix3d::Identity()};
    EXPECT_EQ(watch.admit(ahead, 10), ReadingFate::StampAhead);
    EXPECT_THAT(watch.complaint(10), HasSubstr("ahead of all other sensors"));
}
}  // namespace rtob::test
