// SPDX-License-Identifier: BSD-3-Clause
#include "compare/rtob_variant.h"

#include <mrpt/obs/CObservationOdometry.h>
#include <rtob/map/conversions.h>

namespace rtob
{
namespace
{
SlamOptions without_sensor_options(SlamOptions options)
{
    options.sensor = {};
    return options;
}
}  // namespace

RtobVariant::RtobVariant(const SlamOptions& options) : slam_(without_sensor_options(options)) {}

Pose2 RtobVariant::process(const ScanStep& step)
{
    if (step.pose_odom_vehicle)
    {
        mrpt::obs::CObservationOdometry odometry;
        odometry.odometry = to_cpose2d(*step.pose_odom_vehicle);
        static_cast<void>(slam_.observe(odometry));
    }
    const ScanReport& report = slam_.process(*step.scan);
    if (report.state == TrackingState::Lost) ++lost_scans_;
    return report.pose_map_vehicle;
}

VariantMap RtobVariant::map() const
{
    const PointsView points = slam_.map().points();
    VariantMap map;
    map.size = points.size;
    map.points.x.assign(points.x, points.x + points.size);
    map.points.y.assign(points.y, points.y + points.size);
    return map;
}

Pose2 OdometryVariant::process(const ScanStep& step)
{
    if (step.pose_odom_vehicle) pose_odom_vehicle_ = *step.pose_odom_vehicle;
    return pose_odom_vehicle_;
}
}  // namespace rtob
