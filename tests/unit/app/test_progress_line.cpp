// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <sstream>

#include "run/progress_line.h"

namespace rtob::test
{
namespace
{
using namespace std::chrono_literals;

TEST(ProgressText, SaysShareScansSpeedAndState)
{
    EXPECT_EQ(
        progress_text({0.37, 5043, 1060, 5, TrackingState::Tracking}),
        " 37 %  5043 scans  212x real time  TRACKING");
    EXPECT_EQ(
        progress_text({0, 1, 0, 0, TrackingState::Init}), "  0 %  1 scans  0x real time  INIT");
}

TEST(ProgressLine, DrawsAFewTimesASecondAndClearsItself)
{
    std::ostringstream out;
    const ProgressLine::Clock::time_point start{1h};
    {
        ProgressLine line(out, true);
        line.update({0, 1, 0, 0, TrackingState::Init}, start);
        const auto first = out.str();
        EXPECT_NE(first.find("1 scans"), std::string::npos);
        line.update({0, 2, 0, 0, TrackingState::Init}, start + 199ms);
        EXPECT_EQ(out.str(), first);
        line.update({0, 3, 0, 0, TrackingState::Init}, start + 200ms);
        EXPECT_NE(out.str().find("3 scans"), std::string::npos);
    }
    const std::string cleared = "\r\033[K";
    EXPECT_EQ(out.str().substr(out.str().size() - cleared.size()), cleared);
}

TEST(ProgressLine, SaysNothingWhereNobodyLooks)
{
    std::ostringstream out;
    {
        ProgressLine line(out, false);
        line.update({0, 1, 0, 0, TrackingState::Init}, ProgressLine::Clock::time_point{1h});
    }
    EXPECT_EQ(out.str(), "");
}
}  // namespace
}  // namespace rtob::test
