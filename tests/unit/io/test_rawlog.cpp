// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "log_files.h"
#include "temporary_file.h"

namespace rtob::test
{
namespace
{
using namespace mrpt::obs;
using testing::HasSubstr;
using Objects = std::vector<mrpt::serialization::CSerializable::Ptr>;

CObservation2DRangeScan::Ptr scan_at(double time_s, const std::string& label = "laser")
{
    auto scan = CObservation2DRangeScan::Create();
    scan->timestamp = mrpt::Clock::fromDouble(time_s);
    scan->sensorLabel = label;
    scan->resizeScanAndAssign(7, 2.0F, true);
    return scan;
}

CActionCollection::Ptr action_of(double forward_m)
{
    CActionRobotMovement2D movement;
    movement.computeFromOdometry(mrpt::poses::CPose2D(forward_m, 0, 0), {});
    auto actions = CActionCollection::Create();
    actions->insert(movement);
    return actions;
}

CSensoryFrame::Ptr frame_of(const std::vector<CObservation::Ptr>& observations)
{
    auto frame = CSensoryFrame::Create();
    for (const auto& observation : observations) frame->insert(observation);
    return frame;
}

/// "M" a motion, otherwise the observation's label: the order of a log at a glance.
std::string order_of(const ReadLog& log)
{
    std::string order;
    for (const auto& entry : log.entries)
        order += (entry.motion ? std::string("M") : entry.observation->sensorLabel) + " ";
    return order;
}

ReadLog read_objects(const Objects& objects)
{
    const TemporaryFile file(".rawlog", gzip(rawlog_bytes(objects)));
    return read_log(file.path());
}

TEST(Rawlog, GivesObservationsOneByOne)
{
    auto comment = CObservationComment::Create();
    comment->text = "made by hand";
    const auto log = read_objects({comment, scan_at(1, "a"), scan_at(2, "b")});
    EXPECT_EQ(log.error, "");
    EXPECT_EQ(order_of(log), "a b ");
    EXPECT_DOUBLE_EQ(mrpt::Clock::toDouble(log.scans().at(1)->timestamp), 2);
}

TEST(Rawlog, GivesTheActionBeforeItsFrame)
{
    const auto log = read_objects(
        {action_of(0.25), frame_of({scan_at(1, "a"), scan_at(1, "b")}), action_of(0.5),
         frame_of({scan_at(2, "c")})});
    EXPECT_EQ(log.error, "");
    EXPECT_EQ(order_of(log), "M a b M c ");
    EXPECT_DOUBLE_EQ(log.entries[0].motion->rawOdometryIncrementReading.x(), 0.25);
    EXPECT_DOUBLE_EQ(log.entries[3].motion->poseChange->getMeanVal().x(), 0.5);
}

TEST(Rawlog, GivesFramesWithoutActions)
{
    const auto log =
        read_objects({frame_of({scan_at(1, "a")}), frame_of({}), frame_of({scan_at(2, "b")})});
    EXPECT_EQ(log.error, "");
    EXPECT_EQ(order_of(log), "a b ");
}

TEST(Rawlog, PassesOverActionsWithoutAMovement)
{
    const auto log = read_objects({CActionCollection::Create(), frame_of({scan_at(1, "a")})});
    EXPECT_EQ(order_of(log), "a ");
}

TEST(Rawlog, SurvivesAnObservationWithoutAStamp)
{
    auto scan = scan_at(1, "a");
    scan->timestamp = INVALID_TIMESTAMP;
    const auto log = read_objects({scan, frame_of({scan})});
    EXPECT_EQ(log.error, "");
    ASSERT_EQ(log.scans().size(), 2U);
    EXPECT_EQ(log.scans()[0]->timestamp, INVALID_TIMESTAMP);
}

TEST(Rawlog, ReadsPlainPackedAndJoinedFilesWhateverTheirName)
{
    const Objects objects{scan_at(1, "a"), scan_at(2, "b")};
    const std::string bytes = rawlog_bytes(objects);
    for (const auto& content : {bytes, gzip(bytes), bzip2(bytes)})
    {
        const TemporaryFile file(".txt", content);
        const auto log = read_log(file.path());
        EXPECT_EQ(log.error, "");
        EXPECT_EQ(order_of(log), "a b ");
    }
    const TemporaryFile joined(".rawlog", gzip(bytes) + gzip(bytes));
    EXPECT_EQ(read_log(joined.path()).error, "");
    EXPECT_EQ(order_of(read_log(joined.path())), "a b a b ");
}

TEST(Rawlog, NamesAnUnknownClass)
{
    std::string bytes = rawlog_bytes({scan_at(1, "a"), scan_at(2, "b")});
    const std::string known = "CObservation2DRangeScan", unknown = "CObservation9DRangeScan";
    bytes.replace(bytes.rfind(known), known.size(), unknown);
    const TemporaryFile file(".rawlog", gzip(bytes));
    const auto log = read_log(file.path());
    EXPECT_EQ(order_of(log), "a ");
    EXPECT_THAT(log.error, HasSubstr("entry 2"));
    EXPECT_THAT(log.error, HasSubstr(unknown));
    EXPECT_THAT(log.error, HasSubstr(file.path()));
}

TEST(Rawlog, TellsDamageInsideAPlainFile)
{
    std::string bytes = rawlog_bytes({scan_at(1, "a"), scan_at(2, "b")});
    const std::size_t second = bytes.size() / 2;
    bytes[second] = '\x05';  // the second object's mark, top bit set, is gone
    const TemporaryFile file(".rawlog", bytes);
    const auto log = read_log(file.path());
    EXPECT_EQ(order_of(log), "a ");
    EXPECT_THAT(log.error, HasSubstr("entry 2"));
    EXPECT_THAT(log.error, HasSubstr("damaged"));
}

TEST(Rawlog, ProgressGrowsToOne)
{
    const TemporaryFile file(".rawlog", gzip(rawlog_bytes(Objects(2000, scan_at(1)))));
    const auto reader = open_log(file.path());
    double last = reader->progress();
    EXPECT_GE(last, 0);
    while (reader->next())
    {
        EXPECT_GE(reader->progress(), last);
        last = reader->progress();
    }
    EXPECT_DOUBLE_EQ(last, 1);
}
}  // namespace
}  // namespace rtob::test
