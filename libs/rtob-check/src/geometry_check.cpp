// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/geometry_check.h>

#include <cmath>

#include "figures.h"

namespace rtob
{
namespace
{
constexpr double kSame_m = 1e-4, kSame_rad = 1e-4;
constexpr double kTilt_rad = 0.02;
constexpr double kRepeatedShare = 0.01;
constexpr std::size_t kFewBeams = 60;

bool same(double a, double b, double tolerance)
{
    return std::abs(a - b) < tolerance;
}

/// Half-circle and full-circle scanners have 180, 181, 360, 361, 720 or 721 beams; importers that
/// assume 0.5 degrees a beam give 180 of them 90 degrees.
bool looks_halved(std::size_t beams, double aperture_rad)
{
    const bool is_half_circle_count = beams == 180 || beams == 181;
    return is_half_circle_count && std::abs(aperture_rad * kRadToDeg - 90) < 1.0;
}

std::string side(double value_m, const char* plus, const char* minus)
{
    return fixed(std::abs(value_m), 3) + " m " + (value_m >= 0 ? plus : minus);
}
}  // namespace

bool GeometryCheck::Geometry::operator==(const Geometry& other) const
{
    return beams == other.beams && same(aperture_rad, other.aperture_rad, kSame_rad) &&
           right_to_left == other.right_to_left && same(mount_x_m, other.mount_x_m, kSame_m) &&
           same(mount_y_m, other.mount_y_m, kSame_m) && same(mount_z_m, other.mount_z_m, kSame_m) &&
           same(yaw_rad, other.yaw_rad, kSame_rad) && same(pitch_rad, other.pitch_rad, kSame_rad) &&
           same(roll_rad, other.roll_rad, kSame_rad);
}

void GeometryCheck::add(const mrpt::obs::CObservation2DRangeScan& scan)
{
    ++scans_;
    const std::size_t beams = scan.getScanSize();
    if (beams < 2)
    {
        ++without_beams_;
        return;
    }
    const auto& mount = scan.sensorPose;
    const Geometry geometry{beams,     scan.aperture, scan.rightToLeft, mount.x(),   mount.y(),
                            mount.z(), mount.yaw(),   mount.pitch(),    mount.roll()};
    if (!first_) first_ = geometry;
    if (!(*first_ == geometry)) ++changed_;

    bool is_same = last_ranges_m_.size() == beams;
    last_ranges_m_.resize(beams);
    for (std::size_t i = 0; i < beams; ++i)
    {
        is_same = is_same && last_ranges_m_[i] == scan.getScanRange(i);
        last_ranges_m_[i] = scan.getScanRange(i);
    }
    if (is_same) ++repeated_;
}

void GeometryCheck::report(CheckReport& report) const
{
    reportBeams(report);
    if (!first_) return;
    reportDirection(report);
    reportMount(report);
    reportRepeats(report);
}

void GeometryCheck::reportBeams(CheckReport& report) const
{
    Finding finding;
    finding.id = "laser.beams";
    finding.values = {
        {"scans", static_cast<double>(scans_)},
        {"scans_without_beams", static_cast<double>(without_beams_)},
        {"scans_of_another_geometry", static_cast<double>(changed_)}};
    if (!first_)
    {
        finding.severity = Severity::Fail;
        finding.text = "none of the " + counted(scans_, "scan") + " has beams";
        finding.fix = "Check the driver or the conversion: there is nothing to match";
        report.findings.push_back(std::move(finding));
        return;
    }
    const double aperture_deg = first_->aperture_rad * kRadToDeg;
    const double step_deg = aperture_deg / static_cast<double>(first_->beams - 1);
    const double middle_deg = first_->yaw_rad * kRadToDeg;
    finding.values.emplace_back("beams", static_cast<double>(first_->beams));
    finding.values.emplace_back("aperture_deg", aperture_deg);
    finding.values.emplace_back("step_deg", step_deg);
    finding.text = counted(scans_, "scan") + " of " + std::to_string(first_->beams) +
                   " beams, from " + fixed(middle_deg - aperture_deg / 2, 1) + " to " +
                   fixed(middle_deg + aperture_deg / 2, 1) + " deg of the vehicle, " +
                   fixed(step_deg, 3) + " deg apart";
    if (looks_halved(first_->beams, first_->aperture_rad))
    {
        finding.severity = Severity::Fail;
        finding.fix =
            "Scanners of so many beams look over 180 deg: MRPT's carmen2rawlog halves "
            "them. Use the original log, or set the aperture anew";
    }
    else if (changed_ > 0 || without_beams_ > 0)
    {
        finding.severity = Severity::Warn;
        finding.text += "; " + std::to_string(changed_) + " are of another geometry, " +
                        std::to_string(without_beams_) + " have no beams";
        finding.fix = "Give different lasers different labels, and name one in [Sensor] labels";
    }
    else if (first_->beams < kFewBeams)
    {
        finding.severity = Severity::Warn;
        finding.fix = "So few beams hold a pose badly";
    }
    report.findings.push_back(std::move(finding));
}

void GeometryCheck::reportDirection(CheckReport& report) const
{
    Finding finding;
    finding.id = "laser.direction";
    finding.values = {{"clockwise", first_->right_to_left ? 0.0 : 1.0}};
    finding.text = first_->right_to_left
                       ? "the beams run counter-clockwise"
                       : "the beams run clockwise, and the log says so: run takes them rightly";
    report.findings.push_back(std::move(finding));
}

void GeometryCheck::reportMount(CheckReport& report) const
{
    const auto& mount = *first_;
    Finding finding;
    finding.id = "laser.mount";
    finding.values = {
        {"x_m", mount.mount_x_m},
        {"y_m", mount.mount_y_m},
        {"z_m", mount.mount_z_m},
        {"yaw_of_middle_deg", mount.yaw_rad * kRadToDeg}};
    const bool is_at_origin =
        same(mount.mount_x_m, 0, kSame_m) && same(mount.mount_y_m, 0, kSame_m);
    finding.text = "the laser sits at the vehicle's origin";
    if (!is_at_origin)
        finding.text = "the laser sits " + side(mount.mount_x_m, "ahead of", "behind") + " and " +
                       side(mount.mount_y_m, "left of", "right of") +
                       " the vehicle's origin; run uses this, a program that ignores it is off by "
                       "as much";
    const bool hangs = same(std::abs(mount.roll_rad), M_PI, kTilt_rad);
    const double roll_rad = hangs ? 0 : mount.roll_rad;
    if (hangs) finding.text += "; it hangs upside down";
    if (std::abs(mount.pitch_rad) > kTilt_rad || std::abs(roll_rad) > kTilt_rad)
    {
        finding.severity = Severity::Warn;
        finding.text += "; it is tilted by " + fixed(mount.pitch_rad * kRadToDeg, 1) +
                        " deg (pitch) and " + fixed(roll_rad * kRadToDeg, 1) + " deg (roll)";
        finding.fix = "A tilted laser sees the floor and slanted walls; level it";
    }
    report.findings.push_back(std::move(finding));
}

void GeometryCheck::reportRepeats(CheckReport& report) const
{
    const double share = share_of(repeated_, scans_);
    Finding finding;
    finding.id = "laser.repeats";
    finding.values = {{"repeated_scans", static_cast<double>(repeated_)}};
    finding.text = counted(repeated_, "scan") + " repeat the one before, beam for beam";
    if (share > kRepeatedShare)
    {
        finding.severity = Severity::Warn;
        finding.text += " (" + percent(share) + ")";
        finding.fix =
            "The driver gave scans out twice, or simulated ones stand still: the same "
            "data counts more often, and the true rate is lower";
    }
    report.findings.push_back(std::move(finding));
}
}  // namespace rtob
