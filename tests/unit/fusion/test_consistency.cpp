// SPDX-License-Identifier: BSD-3-Clause
// Whether the filter's errors are as large as it says, over 100 simulated runs (Bar-Shalom): the
// mean NEES and NIS of each time step lie inside their 95 % bounds for at least 90 % of the steps.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "motion_run.h"

namespace rtob::test
{
namespace
{
constexpr int kRuns = 100;

/// Sums over the runs, by time step.
struct StepSums
{
    std::map<int, double> sum;
    int freedom = 0;
    void add(int step, double value, int its_freedom)
    {
        sum[step] += value;
        freedom = its_freedom;
    }
    /// Share of the steps whose mean over the runs lies inside its 95 % bounds.
    [[nodiscard]] double shareInside() const
    {
        const double low = chi_square_quantile(-1.96), high = chi_square_quantile(1.96);
        double inside = 0;
        for (const auto& [step, value] : sum) inside += value > low && value < high;
        return inside / static_cast<double>(sum.size());
    }
    /// Wilson and Hilferty's, good to four digits for the hundred and more degrees of freedom here.
    [[nodiscard]] double chi_square_quantile(double normal_quantile) const
    {
        const double n = kRuns * freedom, spread = 2 / (9 * n);
        return n * std::pow(1 - spread + normal_quantile * std::sqrt(spread), 3);
    }
};

struct Consistency
{
    StepSums nees;
    std::map<Measurement::Kind, StepSums> nis;
};

void add_run(const MotionRunOptions& options, std::uint64_t seed, Consistency& consistency)
{
    constexpr int nees_every = 10;  // steps
    MotionRun run(options, seed);
    auto filter = started_filter();
    // Without a gyro its bias stays what it was drawn: no step would be a new sample.
    const int states = options.gyro ? kGyroBias + 1 : kGyroBias;
    const int steps = static_cast<int>(options.duration_s / MotionRun::kStep_s);
    for (int step = 1; step <= steps; ++step)
    {
        for (const Measurement& reading : run.step())
        {
            const auto innovation = filter.add(reading);
            ASSERT_TRUE(innovation);
            if (innovation->freedom > 0)
                consistency.nis[reading.kind].add(step, innovation->nis, innovation->freedom);
        }
        if (step % nees_every == 0)
            consistency.nees.add(step, nees(filter.at(run.time_s()), run.truth(), states), states);
    }
}

struct Case
{
    const char* name;
    bool gyro, flow, odometry;
};

class FilterConsistency : public testing::TestWithParam<Case>
{
};
}  // namespace

TEST_P(FilterConsistency, ErrorsAreAsLargeAsTheFilterSays)
{
    MotionRunOptions options;
    options.gyro = GetParam().gyro;
    options.flow = GetParam().flow;
    options.odometry = GetParam().odometry;
    Consistency consistency;
    for (int run = 0; run < kRuns; ++run)
        add_run(options, static_cast<std::uint64_t>(run), consistency);
    EXPECT_GE(consistency.nees.shareInside(), 0.9);
    RecordProperty("nees_inside", std::to_string(consistency.nees.shareInside()));
    for (const auto& [kind, nis] : consistency.nis)
    {
        EXPECT_GE(nis.shareInside(), 0.9) << "kind " << static_cast<int>(kind);
        RecordProperty(
            "nis_inside_" + std::to_string(static_cast<int>(kind)),
            std::to_string(nis.shareInside()));
    }
}

INSTANTIATE_TEST_SUITE_P(
    WithAndWithoutEachSensor, FilterConsistency,
    testing::Values(
        Case{"All", true, true, true}, Case{"NoGyro", false, true, true},
        Case{"NoFlow", true, false, true}, Case{"NoOdometry", true, true, false},
        Case{"GyroOnly", true, false, false}, Case{"FlowOnly", false, true, false},
        Case{"OdometryOnly", false, false, true}, Case{"ScansOnly", false, false, false}),
    [](const auto& test) { return test.param.name; });
}  // namespace rtob::test
