// SPDX-License-Identifier: BSD-3-Clause
// What the readers pass over is counted.
#include <gmock/gmock.h>
#include <mrpt/obs/CObservationComment.h>

#include "carmen_text.h"
#include "drive_log.h"
#include "log_files.h"

namespace rtob::test
{
namespace
{
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

LogLosses losses_of(const std::string& content)
{
    const TemporaryFile file(".log", content);
    const auto log = open_log(file.path());
    while (log->next()) continue;
    return log->losses();
}

TEST(LogLosses, OfACarmenLogAreItsOtherMessages)
{
    const std::string scan = flaser("1 2", "1 0 0", "1 0 0", "10");
    EXPECT_THAT(losses_of(scan), IsEmpty());
    EXPECT_THAT(
        losses_of(
            "# a comment\nPARAM robot_width 1 10 host 0\n" + scan +
            "ODOM 1 0 0 0 0 0 10 host 0\nSONAR 1 2 3\nSONAR 1 2 3\n"),
        ElementsAre(
            Pair(HasSubstr("ODOM lines"), 1), Pair(HasSubstr("PARAM lines"), 1),
            Pair(HasSubstr("SONAR lines"), 2)));
}

TEST(LogLosses, OfACorrectedLogAreItsCorrections)
{
    const std::string log =
        flaser("1 2", "1 0 0", "1 0 0", "10") + flaser("1 2", "1.5 0.3 0", "2.1 0 0", "11");
    EXPECT_THAT(losses_of(log), ElementsAre(Pair(HasSubstr("corrected"), 2)));
}

TEST(LogLosses, OfRemissionsAreFractions)
{
    RobotLaserText text;
    text.remissions = "3 900 901 902";
    EXPECT_THAT(losses_of(text.line()), IsEmpty());
    text.remissions = "3 0.5 1 1";
    EXPECT_THAT(losses_of(text.line()), ElementsAre(Pair(HasSubstr("whole numbers"), 3)));
    text.remissions = "2 1 1";
    EXPECT_THAT(losses_of(text.line()), ElementsAre(Pair(HasSubstr("one a beam"), 2)));
}

TEST(LogLosses, OfARawlogAreItsComments)
{
    EXPECT_THAT(
        losses_of(rawlog_bytes({mrpt::obs::CObservationComment::Create(), scan_on_circle(0)})),
        ElementsAre(Pair("comments", 1)));
}
}  // namespace
}  // namespace rtob::test
