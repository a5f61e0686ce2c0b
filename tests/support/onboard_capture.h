// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gmock/gmock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <rtob/eval/alignment.h>
#include <rtob/eval/trajectory_errors.h>
#include <rtob/io/log_reader.h>
#include <rtob/io/scan_timing.h>

#include <functional>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "onboard_flight.h"

namespace rtob::test
{
/// What a capture holds, up to its damage.
struct CaptureContents
{
    std::vector<double> scans, poses;                     ///< stamps
    std::map<std::string, std::vector<double>> scans_of;  ///< stamps by label
    std::vector<Pose2> pose_map_vehicle;
    std::size_t attitudes = 0, dropped = 0;
    std::string damage;
};

inline CaptureContents read_capture(const std::string& file)
{
    CaptureContents contents;
    const auto log = open_log(file);
    try
    {
        while (const auto entry = log->next())
        {
            const auto& observation = *entry->observation;
            const double stamp_s = mrpt::Clock::toDouble(observation.timestamp);
            if (dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&observation) != nullptr)
            {
                contents.scans.push_back(stamp_s);
                contents.scans_of[observation.sensorLabel].push_back(stamp_s);
            }
            if (const auto* pose =
                    dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&observation))
            {
                contents.poses.push_back(stamp_s);
                contents.pose_map_vehicle.push_back(
                    {pose->pose.mean.x(), pose->pose.mean.y(), pose->pose.mean.yaw()});
            }
            contents.attitudes += observation.sensorLabel == "AUTOPILOT.attitude";
            contents.dropped += is_dropped_record(observation);
        }
    }
    catch (const LogError& error)
    {
        contents.damage = error.what();
    }
    return contents;
}

/// Of these poses against the flight, laid onto it as said.
inline double rms_error_m(const std::vector<PoseMatch>& matches, Alignment alignment)
{
    const auto laid = moved_estimates(matches, alignment_of(matches, alignment));
    return absolute_errors(laid).distance_m.rmse;
}

inline nlohmann::json summary_of(const std::string& flight)
{
    return nlohmann::json::parse(file_content(flight + "/summary.json"));
}

class Onboard : public testing::Test, public FlightFixture
{
 protected:
    [[nodiscard]] std::string logged(const std::string& flight) const
    {
        return flight + "/capture_000.rawlog";
    }

    /// Takes off when the first poses came, flies until this many were told, and ends by SIGTERM.
    /// @param before_takeoff what happens to the program after its first pose
    /// @return the flight's folder; empty where it failed
    [[nodiscard]] std::string fly(
        const std::string& ini, std::size_t poses,
        const std::function<void(const RunningProgram&)>& before_takeoff = {})
    {
        RunningProgram program(RTOB_ONBOARD, {ini});
        const std::size_t wanted = states_.count() + poses;
        EXPECT_TRUE(states_.waitForMore(1));
        if (before_takeoff) before_takeoff(program);
        EXPECT_TRUE(states_.waitForMore(2));
        takeoff_.go();
        EXPECT_TRUE(states_.waitForMore(wanted - std::min(wanted, states_.count())));
        program.send(SIGTERM);
        const auto result = program.wait();
        EXPECT_EQ(0, result.exit_code) << result.err << result.out;
        std::cout << result.out;
        return flights().empty() ? "" : flights().back();
    }

    /// From the first pose on over a short flight; over a long one as a path: the tenths of a
    /// degree by which the first scans miss the direction are a lever then.
    void expectTheTruth(const CaptureContents& capture) const
    {
        constexpr std::size_t short_flight = 160;
        std::vector<PoseMatch> matches;
        for (std::size_t i = 0; i < capture.poses.size(); ++i)
            matches.push_back(
                {i, i, capture.poses[i], capture.pose_map_vehicle[i],
                 takeoff_.pose(capture.poses[i])});
        const double as_path_m = rms_error_m(matches, Alignment::Se2);
        std::cout << matches.size() << " poses, error " << rms_error_m(matches, Alignment::Origin)
                  << " m RMS from the first on, " << as_path_m << " m as a path\n";
        EXPECT_LT(as_path_m, 0.02);
        matches.resize(std::min(matches.size(), short_flight));
        EXPECT_LT(rms_error_m(matches, Alignment::Origin), 0.02);
    }

    /// The log gives the same poses again, to the last digit.
    void expectTheSamePosesAgain(const std::string& flight) const
    {
        const auto replay = run_program(
            RTOB_PROGRAM, {"run", logged(flight), "-c", flight + "/config.effective.ini", "-o",
                           folder_.file("replay"), "--overwrite", "--quiet"});
        ASSERT_EQ(0, replay.exit_code) << replay.err;
        EXPECT_EQ(
            file_content(flight + "/trajectory.tum"),
            file_content(folder_.file("replay") + "/trajectory.tum"));
    }

    /// MRPT's own programs read the capture.
    void expectStockProgramsRead(const std::string& flight) const
    {
        const auto info = run_program("/usr/bin/rawlog-edit", {"--info", "-i", logged(flight)});
        EXPECT_EQ(0, info.exit_code);
        EXPECT_THAT(info.out, testing::HasSubstr("LASER, "));  // and marks, if scans were dropped
        EXPECT_THAT(info.out, testing::HasSubstr("rtob.pose, rtob.scan_timing"));
        EXPECT_THAT(info.out, testing::HasSubstr("Observations format               : Yes"));
        // icp-slam leaves its folder where it is started.
        const auto icp_slam = run_program(
            "/bin/sh", {"-c", "cd \"$0\" && exec icp-slam \"$1\" \"$2\"", folder_.path(),
                        RTOB_SOURCE_DIR "/config/mrpt-icp-slam-dense.ini", logged(flight)});
        EXPECT_EQ(0, icp_slam.exit_code) << icp_slam.out << icp_slam.err;
    }

    Takeoff takeoff_;
};

}  // namespace rtob::test
