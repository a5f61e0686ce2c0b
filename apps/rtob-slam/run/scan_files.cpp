// SPDX-License-Identifier: BSD-3-Clause
#include "run/scan_files.h"

#include <rtob/core/enum_names.h>
#include <rtob/io/tum.h>
#include <rtob/map/option_text.h>

#include <array>
#include <charconv>
#include <cmath>

#include "run/run_counters.h"

namespace rtob
{
namespace
{
/// A stamp that is no number would make the files unreadable.
double written_stamp(const ScanReport& report)
{
    return std::isfinite(report.stamp_s) ? report.stamp_s : 0;
}

std::string stamp_text(const ScanReport& report)
{
    return fixed_text(written_stamp(report), 6);
}

void write_covariance(std::ostream& out, const Eigen::Matrix3d& cov)
{
    for (const double term : {cov(0, 0), cov(0, 1), cov(0, 2), cov(1, 1), cov(1, 2), cov(2, 2)})
        out << ',' << option_text(term);
}

void write_pose_line(std::ostream& out, const ScanReport& report)
{
    const Pose2& pose = report.pose_map_vehicle;
    out << stamp_text(report) << ',' << fixed_text(report.map_time_s, 6) << ','
        << fixed_text(pose.x, 6) << ',' << fixed_text(pose.y, 6) << ',' << fixed_text(pose.yaw, 9)
        << ',' << name_of(report.state) << ',' << name_of(fate_of(report));
    write_covariance(out, report.covariance);
    out << ',' << option_text(report.mean_squared_error_m2) << ','
        << fixed_text(report.paired_share, 4) << ',' << report.pairs << ',' << report.beams.used
        << ',' << report.inserted << ',' << report.anchored << ',' << report.searched;
    write_covariance(out, report.covariance_in_map);
    out << ',' << fixed_text(report.weak.share, 5) << ',' << fixed_text(report.weak.angle_rad, 4)
        << '\n';
}

void write_time_line(std::ostream& out, const ScanReport& report)
{
    const StepTimes& t = report.times;
    out << stamp_text(report);
    for (const double step_s :
         {t.total(), t.filter_s, t.prealign_s, t.draw_s, t.align_s, t.anchor_s, t.search_s,
          t.insert_s})
        out << ',' << fixed_text(1e3 * step_s, 4);
    out << '\n';
}
}  // namespace

std::string fixed_text(double value, int decimals)
{
    std::array<char, 400> text;  // the largest double has 309 digits before the point
    const auto end = std::to_chars(
        text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

ScanFiles::ScanFiles(const OutputFolder& folder)
    : trajectory_(folder.file("trajectory.tum")),
      poses_(folder.file("poses.csv")),
      timing_(folder.file("timing.csv"))
{
    poses_.stream() << "stamp_s,map_time_s,x_m,y_m,yaw_rad,state,scan,cov_x_x_m2,cov_x_y_m2,"
                       "cov_x_yaw_m_rad,cov_y_y_m2,cov_y_yaw_m_rad,cov_yaw_yaw_rad2,"
                       "mean_squared_error_m2,paired_share,pairs,beams_used,inserted,anchored,"
                       "searched,map_cov_x_x_m2,map_cov_x_y_m2,map_cov_x_yaw_m_rad,map_cov_y_y_m2,"
                       "map_cov_y_yaw_m_rad,map_cov_yaw_yaw_rad2,weak_share,"
                       "weak_rad\n";
    timing_.stream() << "stamp_s,total_ms,filter_ms,prealign_ms,draw_ms,align_ms,anchor_ms,"
                        "search_ms,insert_ms\n";
}

void ScanFiles::add(const ScanReport& report)
{
    write_tum(trajectory_.stream(), {{written_stamp(report), report.pose_map_vehicle}});
    write_pose_line(poses_.stream(), report);
    write_time_line(timing_.stream(), report);
}

void ScanFiles::commit()
{
    trajectory_.commit();
    poses_.commit();
    timing_.commit();
}
}  // namespace rtob
