// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace rtob
{
/// Which message carries the pose.
enum class PoseMessage
{
    Odometry,
    VisionPositionEstimate
};

constexpr auto enum_names(PoseMessage)
{
    return std::array<std::pair<PoseMessage, std::string_view>, 2>{
        {{PoseMessage::Odometry, "odometry"},
         {PoseMessage::VisionPositionEstimate, "vision_position_estimate"}}};
}

/// [Autopilot]
struct AutopilotOptions
{
    std::string link;
    unsigned baud = 921600;
    PoseMessage message = PoseMessage::Odometry;
    double pose_hz = 30;
    double heading_deg = 0;
    unsigned system_id = 1;
    unsigned component_id = 197;
    double max_extrapolation_s = 0.3;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "link", s.link,
            "empty: none; udp:HOST:PORT sends there; udpin:ADDRESS:PORT answers who calls; or a "
            "serial port, e.g. /dev/serial0");
        visit("baud", s.baud, "of a serial link");
        visit("message", s.message, "what carries the pose; PX4 and ArduPilot take both");
        visit(
            "pose_hz", s.pose_hz,
            "0: one pose a scan, with the scan's time (ArduPilot); else carried on to this rate "
            "with growing covariance (PX4 wants 30 to 50); at most 100");
        visit(
            "heading_deg", s.heading_deg,
            "of the map's x axis, clockwise from north; the pose then is NED instead of FRD");
        visit("system_id", s.system_id, "the vehicle's; 1 to 255");
        visit("component_id", s.component_id, "ours; 197 is visual-inertial odometry; 1 to 255");
        visit(
            "max_extrapolation_s", s.max_extrapolation_s,
            "a pose is carried on for no longer than this; 0.05 to 1");
    }
    void validate() const;
};
}  // namespace rtob
