// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "house.h"
#include "recovery/kidnap_trials.h"
#include "recovery/recovery_text.h"
#include "recovery/relocalise_trials.h"

namespace rtob
{
namespace
{
using testing::HasSubstr;
using testing::Not;

/// Two laps through the house, so that what a trial leaves out of the map is known from the other.
const DrivenLog& laps()
{
    static const DrivenLog driven = []
    {
        Slam slam;
        DrivenLog log;
        for (int k = 0; k < 2 * test::house_lap_scans; ++k)
        {
            const auto scan = mrpt::obs::CObservation2DRangeScan::Create(test::scan_in_house(k));
            const ScanReport& report = slam.process(*scan);
            log.scans.push_back({scan, report.map_time_s, report.pose_map_vehicle});
        }
        log.map = slam.map();
        return log;
    }();
    return driven;
}

TEST(RecoveryTrials, AVehicleThatWakesUpIsFound)
{
    RelocaliseTrials trials;
    trials.count = 6;
    const auto done = relocalise_trials(laps(), {}, trials);
    ASSERT_EQ(done.size(), 6u);
    for (const RelocaliseTrial& trial : done)
    {
        EXPECT_EQ(trial.outcome, Outcome::Right) << "scan " << trial.scan;
        EXPECT_GE(trial.scans, RelocaliseOptions().confirm_scans);
        EXPECT_LT(trial.error_m, 0.1);
        EXPECT_GT(trial.total_ms, 0);
    }
    EXPECT_THAT(relocalise_text(done, trials), HasSubstr("6 (100.0 %)"));
}

TEST(RecoveryTrials, AVehicleThatIsCarriedAwayIsLostAndFound)
{
    KidnapTrials trials;
    trials.count = 6;
    trials.least_m = 4;
    const auto done = kidnap_trials(laps(), {}, trials);
    ASSERT_EQ(done.size(), 6u);
    for (const KidnapTrial& trial : done)
    {
        const Pose2 way = between(
            laps().scans[trial.from].pose_map_vehicle, laps().scans[trial.to].pose_map_vehicle);
        EXPECT_GT(std::hypot(way.x, way.y), 3.5) << "5 scans from where it began";
        EXPECT_FALSE(trial.was_followed());
        EXPECT_GT(trial.lost_after, 0) << trial.from << " to " << trial.to;
        EXPECT_GE(trial.found_after, trial.lost_after);
        EXPECT_FALSE(trial.is_false_accept);
        EXPECT_TRUE(trial.map_unchanged);
    }
}

TEST(RecoveryTrials, ACoveredLaserIsNoticed)
{
    KidnapTrials trials;
    trials.count = 3;
    trials.mishap = Mishap::Covered;
    for (const KidnapTrial& trial : kidnap_trials(laps(), {}, trials))
    {
        EXPECT_EQ(trial.lost_after, TrackingOptions().lost_after);
        EXPECT_GT(trial.found_after, 0);
        EXPECT_TRUE(trial.map_unchanged);
    }
}

TEST(RecoveryTrials, NoPlaceIsFarEnoughInASmallRoom)
{
    KidnapTrials trials;
    trials.count = 3;
    trials.least_m = 50;
    EXPECT_TRUE(kidnap_trials(laps(), {}, trials).empty());
}

TEST(RecoveryText, TellsOfAPlaceThatIsHardlyMappedFromOneThatIsNotFound)
{
    RelocaliseTrial right, missed, unmapped;
    right.outcome = Outcome::Right;
    missed.scan = 22;
    missed.explained_at_truth = 0.95;
    unmapped.scan = 33;
    unmapped.explained_at_truth = 0.4;
    const std::string text = relocalise_text({right, missed, unmapped}, {});
    EXPECT_THAT(text, HasSubstr("1 (33.3 %)"));
    EXPECT_THAT(text, HasSubstr("not found                          2\n"));
    EXPECT_THAT(
        text, HasSubstr("not right, and hardly mapped       1 (less than 0.8 of a scan)\n"));
    EXPECT_THAT(text, HasSubstr("scan 33: not found"));
}

TEST(RecoveryText, CountsWhatWasNoticedInTimeAndNamesTheRest)
{
    KidnapTrial in_time, late, followed, missed;
    in_time.from = 11;
    in_time.lost_after = 4;
    in_time.found_after = 6;
    late.from = 22;
    late.lost_after = 9;
    late.found_after = 12;
    followed.from = 33;
    missed.from = 44;
    missed.tracking_wrong = 40;
    missed.map_unchanged = false;
    const std::string text = kidnap_text({in_time, late, followed, missed}, {});
    EXPECT_THAT(text, HasSubstr("LOST within 5 scans                1\n"));
    EXPECT_THAT(text, HasSubstr("TRACKING on, at the right place    1\n"));
    EXPECT_THAT(text, HasSubstr("TRACKING again within 40 scans     2\n"));
    EXPECT_THAT(text, HasSubstr("map changed in between             1\n"));
    EXPECT_THAT(text, Not(HasSubstr("scan 11 to")));
    EXPECT_THAT(text, HasSubstr("scan 22 to"));
    EXPECT_THAT(text, Not(HasSubstr("scan 33 to")));
    EXPECT_THAT(text, HasSubstr("scan 44 to"));
}
}  // namespace
}  // namespace rtob
