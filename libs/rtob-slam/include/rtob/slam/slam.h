// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/map/rtob_map.h>
#include <rtob/slam/anchor.h>
#include <rtob/slam/continuity.h>
#include <rtob/slam/drift.h>
#include <rtob/slam/guess_errors.h>
#include <rtob/slam/local_reference.h>
#include <rtob/slam/local_search.h>
#include <rtob/slam/loop_search.h>
#include <rtob/slam/map_belief.h>
#include <rtob/slam/map_thinner.h>
#include <rtob/slam/motion_sense.h>
#include <rtob/slam/pose_belief.h>
#include <rtob/slam/relocaliser.h>
#include <rtob/slam/scan_report.h>
#include <rtob/slam/slam_options.h>
#include <rtob/slam/travel_log.h>

#include <optional>
#include <string>
#include <vector>

namespace rtob
{
/// RTOB-SLAM: takes what a vehicle senses, in order of arrival, and says where it is. One thread.
/// process() allocates nothing once warm (the map's growth apart), locks nothing, logs nothing.
class Slam
{
 public:
    /// @throws std::invalid_argument naming a key out of its range
    explicit Slam(const SlamOptions& options = {});

    /// Takes any observation: what tells of motion is kept for the next scan, a scan of a chosen
    /// laser is processed, anything else is passed over.
    /// @return the report of a scan, or null.
    const ScanReport* observe(const mrpt::obs::CObservation& observation);

    /// Takes the odometry of an action.
    void observe(const mrpt::obs::CActionRobotMovement2D& motion);

    /// One scan, in the steps of the paper's fig. 1.
    const ScanReport& process(const mrpt::obs::CObservation2DRangeScan& scan);

    /// Goes on in a map that was made before (load_map()), the vehicle at rest at this pose of it;
    /// without a pose, LOST until it is found. With options().map.localize nothing is written.
    /// @param map taken over with its points, scans and clock; its options give way to these.
    void continueIn(const RtobMap& map, const std::optional<Pose2>& pose_map_vehicle);

    /// Puts the vehicle elsewhere in the map, at rest.
    void reset(const Pose2& pose_map_vehicle);

    [[nodiscard]] const RtobMap& map() const { return map_; }
    [[nodiscard]] const Pose2& pose() const { return report_.pose_map_vehicle; }
    [[nodiscard]] TrackingState state() const { return tracking_.state(); }
    [[nodiscard]] const SlamOptions& options() const { return options_; }
    [[nodiscard]] const MotionSense& motion() const { return motion_; }
    [[nodiscard]] bool hasOdometry() const { return prealignment_.hasOdometry(); }

 private:
    /// A scan's place in the map, and what speaks for it.
    struct Match
    {
        Pose2 pose_map_vehicle;
        IcpResult fit;
        FitVerdict verdict = FitVerdict::None;
        Pose2 pose_map_local{};                           ///< before old scans corrected it
        IcpResult fit_local{};                            ///< of that
        std::optional<Eigen::Matrix3d> covariance_old{};  ///< of the match with old scans
        bool is_found = false;      ///< by a search, which the next scan has to confirm
        bool is_elsewhere = false;  ///< the vehicle was carried away
    };

    /// A scan did not follow the last one: is the vehicle still where it is tracked?
    struct Doubt
    {
        int scans = 0;                 ///< in a row; 0: none
        double agreement = 1;          ///< of the scan that began it with the one before
        double log_misfit = 0;         ///< of the scans followed, summed, at the tracked place
        std::size_t scans_before = 0;  ///< in the map, when it began
        Pose2 pose_map_first{};        ///< where the scan that began it was tracked
    };

    void begin(const mrpt::obs::CObservation2DRangeScan& scan);
    void filter(const mrpt::obs::CObservation2DRangeScan& scan);
    [[nodiscard]] Pose2 prealign();
    [[nodiscard]] Match matchGuess(const Pose2& pose_map_init);
    [[nodiscard]] Pose2 predicted() const;
    [[nodiscard]] Match matchAround(const Pose2& pose_map_init, IcpReach reach = IcpReach::Far);
    [[nodiscard]] Match alignAround(const Pose2& pose_map_init, IcpReach reach);
    void drawAround(const Pose2& pose_map_init, const Box& needed_map);
    [[nodiscard]] std::size_t trustedBegin() const;
    [[nodiscard]] bool isDoubtful(const Match& match) const;
    [[nodiscard]] double mostMisled_m(const Pose2& pose_map_init) const;
    [[nodiscard]] bool isFalseStart(const Match& match) const;
    void searchAround(const Pose2& pose_map_init, Match& match);
    [[nodiscard]] bool isBetterBeside(const Match& found, const Match& match) const;
    void holdToOdometry(const Pose2& pose_map_init, Match& match);
    void doubt(const Pose2& pose_map_init, const std::string& laser, Match& match);
    [[nodiscard]] bool beginsDoubt(
        const Pose2& pose_map_init, const std::string& laser, const Match& match);
    [[nodiscard]] double explainedShare(const Match& match);
    [[nodiscard]] bool isElsewhere(const Pose2& pose_map_tracked) const;
    [[nodiscard]] std::optional<PlaceEvidence> lookEverywhere(
        const Pose2& pose_map_init, const std::optional<Pose2>& pose_map_tracked);
    void anchor(Match& match);
    void closeLoop(Match& match);
    void bendWay(std::size_t after_old, const Pose2& end, const Pose2& end_now);
    [[nodiscard]] bool wantsToWrite(const Match& match, const std::string& laser) const;
    const ScanReport& startMap(const Pose2& pose_map_init, const std::string& laser);
    const ScanReport& settle(const Match& match);
    const ScanReport& recover(const Pose2& pose_map_init, const std::string& laser);
    void report(const Match& match, TrackingState state);
    void insert(const Match& match, const std::string& laser);
    void keepOnly(const std::vector<char>& keep);
    void takeBackDoubted();
    void believe(const Match& match);

    SlamOptions options_;
    RtobMap map_;
    SensorChoice sensor_;
    ScanFilter filter_;
    MotionSense motion_;
    Prealignment prealignment_;
    PoseBelief belief_;
    Icp icp_;
    TrackingStateMachine tracking_;
    InsertionPolicy insertion_;
    TravelLog travel_;
    Drift drift_;
    Anchor anchor_;
    LoopSearch loop_search_;
    LocalSearch search_;
    Continuity continuity_;
    Relocaliser relocaliser_;
    MapBelief map_belief_;
    MapThinner thinner_;

    Pose2 matched_at_;              ///< in map; where a scan last fitted
    std::size_t scans_of_map_ = 0;  ///< processed since it began, written or not
    GuessErrors guess_errors_;      ///< of odometry
    Doubt doubt_;                   ///< whether the vehicle has been carried away
    Points points_vehicle_;         ///< of the scan in work
    Points matched_vehicle_;        ///< those of them that are matched
    Points points_turned_;          ///< these, with map axes, seen from the vehicle
    LocalReference local_;          ///< what scans are matched against
    LocalReference local_before_;   ///< the same, before the doubt began
    Reference reference_;           ///< what a search looks through
    std::vector<Pose2> bent_way_;   ///< of the scans of a closed loop, in map
    ScanReport report_;
};
}  // namespace rtob
