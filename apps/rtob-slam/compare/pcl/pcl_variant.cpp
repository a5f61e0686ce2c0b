// SPDX-License-Identifier: BSD-3-Clause
#include "compare/pcl/pcl_variant.h"

// gcc 12 is wrong about Eigen's umeyama, as PCL uses it.
#pragma GCC diagnostic ignored "-Warray-bounds"
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>
#include <rtob/core/icp.h>
#include <rtob/slam/turned_points.h>

#include <cmath>

namespace rtob
{
namespace
{
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double kNeverRest = 1e-9;  // sec. 2.3.1: both epsilons, so that all iterations are done

Cloud::Ptr cloud_of(const Points& points)
{
    Cloud::Ptr cloud(new Cloud);
    cloud->reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) cloud->push_back({points.x[i], points.y[i], 0});
    return cloud;
}
}  // namespace

PclVariant::PclVariant(const SlamOptions& options)
    : options_(options),
      map_(map_options(options)),
      filter_(options.scan_filter),
      prealignment_(options.prealign)
{
}

Pose2 PclVariant::process(const ScanStep& step)
{
    filter_.filter(*step.scan, step.scan->sensorPose, points_vehicle_);
    if (step.pose_odom_vehicle) prealignment_.addOdometry(*step.pose_odom_vehicle);
    const double time_s = map_.tick(step.time_s);
    const Pose2 pose_map_init = prealignment_.predict(time_s);
    if (points_vehicle_.size() < static_cast<std::size_t>(options_.fit_gate.min_pairs))
    {
        prealignment_.settle(time_s, pose_map_init, false);
        return pose_map_init;
    }
    Fit fit{{}, true};
    if (!map_.scans().empty())
    {
        turn_points(pose_map_init, points_vehicle_.view(), points_turned_);
        map_.draw(pose_map_init, reference_);
        fit = align(points_turned_);
    }
    const Pose2 pose_map_vehicle =
        fit.is_good ? apply_correction(pose_map_init, fit.correction) : pose_map_init;
    prealignment_.settle(time_s, pose_map_vehicle, fit.is_good);
    if (fit.is_good) map_.insertScan(time_s, pose_map_vehicle, points_vehicle_.view());
    return pose_map_vehicle;
}

PclVariant::Fit PclVariant::align(const Points& scan_turned)
{
    pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
    icp.setMaximumIterations(options_.icp.iterations);
    icp.setTransformationEpsilon(kNeverRest);
    icp.setEuclideanFitnessEpsilon(kNeverRest);
    icp.setMaxCorrespondenceDistance(options_.icp.max_pair_distance_m);
    icp.setInputSource(cloud_of(scan_turned));
    icp.setInputTarget(cloud_of(reference_.points));
    Cloud aligned;
    icp.align(aligned);
    // Over the pairs alone: with all points, a scan that sees new ground would never be accepted.
    const double pair_distance_m = options_.icp.max_pair_distance_m;
    const double mean_squared_error_m2 = icp.getFitnessScore(pair_distance_m * pair_distance_m);
    const auto motion = icp.getFinalTransformation();
    const double yaw = std::atan2(motion(1, 0), motion(0, 0));
    return {
        {motion(0, 3), motion(1, 3), yaw},
        icp.hasConverged() && mean_squared_error_m2 <= options_.fit_gate.max_mean_squared_error_m2};
}

VariantMap PclVariant::map() const
{
    const PointsView points = map_.points();
    VariantMap map;
    map.size = points.size;
    map.points.x.assign(points.x, points.x + points.size);
    map.points.y.assign(points.y, points.y + points.size);
    return map;
}
}  // namespace rtob
