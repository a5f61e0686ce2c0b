// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "error_message.h"
#include "eval/eval_flags.h"
#include "usage_error.h"

using namespace rtob;
using testing::HasSubstr;

namespace
{
std::string refusal(const EvalFlags& flags)
{
    return test::error_message<UsageError>([&] { static_cast<void>(score_options(flags)); });
}

std::string delta_refusal(const std::string& delta)
{
    EvalFlags flags;
    flags.deltas = {delta};
    return refusal(flags);
}
}  // namespace

TEST(EvalFlags, AskForAnAlignedAteAndOneRpeWhenNotGiven)
{
    const auto options = score_options({});
    EXPECT_EQ(options.alignment, Alignment::Se2);
    EXPECT_EQ(options.max_difference_s, 0.01);
    ASSERT_EQ(options.relative.size(), 1u);
    EXPECT_EQ(options.relative[0].steps.delta, 1);
    EXPECT_EQ(options.relative[0].steps.unit, DeltaUnit::Frames);
    EXPECT_EQ(options.relative[0].steps.choice, StepChoice::Consecutive);
    EXPECT_FALSE(options.relative[0].steps_of_reference);
    EXPECT_EQ(EvalFlags{}.trajectoryFlag(), "");
}

TEST(EvalFlags, BecomeOptions)
{
    EvalFlags flags;
    flags.align = "origin";
    flags.max_difference = "0.5";
    flags.deltas = {"10", "2.5m"};
    flags.tolerance = "0.2";
    flags.all_steps = flags.steps_of_reference = true;
    const auto options = score_options(flags);
    EXPECT_EQ(options.alignment, Alignment::Origin);
    EXPECT_EQ(options.max_difference_s, 0.5);
    ASSERT_EQ(options.relative.size(), 2u);
    EXPECT_EQ(options.relative[0].steps.delta, 10);
    EXPECT_EQ(options.relative[0].steps.unit, DeltaUnit::Frames);
    EXPECT_EQ(options.relative[1].steps.delta, 2.5);
    EXPECT_EQ(options.relative[1].steps.unit, DeltaUnit::Metres);
    for (const auto& relative : options.relative)
    {
        EXPECT_EQ(relative.steps.choice, StepChoice::All);
        EXPECT_EQ(relative.steps.tolerance, 0.2);
        EXPECT_TRUE(relative.steps_of_reference);
    }
}

TEST(EvalFlags, RefuseBadValuesByTheFlagsName)
{
    EvalFlags flags;
    flags.align = "se3";
    EXPECT_THAT(refusal(flags), HasSubstr("--align: 'se3' is not one of: none, origin, se2"));
    flags = {};
    flags.max_difference = "-1";
    EXPECT_THAT(refusal(flags), HasSubstr("--max-diff: '-1' is not a number of at least 0"));
    flags = {};
    flags.tolerance = "10%";
    EXPECT_THAT(refusal(flags), HasSubstr("--delta-tolerance: '10%'"));
    for (const std::string delta : {"", "m", "1.5", "0", "0m", "-1m", "nan", "1cm", "1e999"})
        EXPECT_THAT(delta_refusal(delta), HasSubstr("--delta: '")) << delta;
}

TEST(EvalFlags, TellWhichOnesRelationsDoNotNeed)
{
    EvalFlags flags;
    flags.json = true;
    EXPECT_EQ(flags.trajectoryFlag(), "");
    flags.all_steps = true;
    EXPECT_EQ(flags.trajectoryFlag(), "--all-steps");
    flags.deltas = {"1"};
    EXPECT_EQ(flags.trajectoryFlag(), "--delta");
}
