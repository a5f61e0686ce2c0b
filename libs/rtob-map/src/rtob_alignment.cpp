// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <rtob/map/conversions.h>
#include <rtob/map/rtob_alignment.h>
#include <rtob/map/rtob_map.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace rtob
{
namespace
{
const mrpt::maps::CPointsMap& points_of(const mrpt::maps::CMetricMap* map, const char* which)
{
    if (map != nullptr)
    {
        if (const auto* points = dynamic_cast<const mrpt::maps::CPointsMap*>(map)) return *points;
        if (const auto* points = map->getAsSimplePointsMap()) return *points;
    }
    throw std::invalid_argument(
        std::string("RtobAlignment: ") + which +
        " must be a point map, or a multi-metric map that holds exactly one");
}

/// Copies the points by a shift, in doubles: a map's coordinates may be large.
void shift_into(const PointsView& points, double dx, double dy, Points& shifted)
{
    shifted.clear();
    shifted.reserve(points.size);
    for (std::size_t i = 0; i < points.size; ++i)
        shifted.add(static_cast<float>(points.x[i] + dx), static_cast<float>(points.y[i] + dy));
}

void turn_into(const PointsView& points, double yaw, Points& turned)
{
    const double c = std::cos(yaw), s = std::sin(yaw);
    turned.clear();
    turned.reserve(points.size);
    for (std::size_t i = 0; i < points.size; ++i)
    {
        const double x = points.x[i], y = points.y[i];
        turned.add(static_cast<float>(c * x - s * y), static_cast<float>(s * x + c * y));
    }
}

void reference_seen_from(
    const Pose2& pose_map_vehicle, const mrpt::maps::CPointsMap& map,
    const PointsView& scan_vehicle, Points& reference)
{
    if (const auto* rtob_map = dynamic_cast<const RtobMap*>(&map))
    {
        const Reference& sample = rtob_map->sampleFor(scan_vehicle, pose_map_vehicle);
        shift_into(
            sample.points.view(), sample.origin_x - pose_map_vehicle.x,
            sample.origin_y - pose_map_vehicle.y, reference);
    }
    else
        shift_into(view_of(map), -pose_map_vehicle.x, -pose_map_vehicle.y, reference);
}

void report(
    const IcpResult& icp, double seconds,
    mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> result)
{
    if (!result) return;
    result.value().get().executionTime = seconds;
    auto* ours = dynamic_cast<RtobAlignmentResult*>(&result.value().get());
    if (ours == nullptr) return;
    ours->iterations = icp.iterations;
    ours->pairs = icp.pairs;
    ours->paired_share = icp.paired_share;
    ours->mean_squared_error = icp.mean_squared_error;
}
}  // namespace

mrpt::poses::CPosePDF::Ptr RtobAlignment::AlignPDF(
    const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
    const mrpt::poses::CPosePDFGaussian& guess,
    mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> result)
{
    const auto begin = std::chrono::steady_clock::now();
    const auto& map = points_of(m1, "m1");
    const PointsView scan_vehicle = view_of(points_of(m2, "m2"));
    const Pose2 pose_map_guess = to_pose2(guess.mean);

    reference_seen_from(pose_map_guess, map, scan_vehicle, reference_);
    turn_into(scan_vehicle, pose_map_guess.yaw, scan_);
    const IcpResult icp = icp_.align(scan_.view(), reference_.view());

    auto pose = std::make_shared<mrpt::poses::CPosePDFGaussian>();
    pose->mean = to_cpose2d(apply_correction(pose_map_guess, icp.correction));
    pose->cov = icp.covariance;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    report(icp, seconds.count(), result);
    return pose;
}

mrpt::poses::CPose3DPDF::Ptr RtobAlignment::Align3DPDF(
    const mrpt::maps::CMetricMap* m1, const mrpt::maps::CMetricMap* m2,
    const mrpt::poses::CPose3DPDFGaussian& guess,
    mrpt::optional_ref<mrpt::slam::TMetricMapAlignmentResult> result)
{
    constexpr double kLevel_rad = 1e-3;
    if (std::abs(guess.mean.pitch()) > kLevel_rad || std::abs(guess.mean.roll()) > kLevel_rad)
        throw std::invalid_argument(
            "RtobAlignment::Align3DPDF: aligns in the plane only, but the guess has pitch or roll");
    mrpt::poses::CPosePDFGaussian planar_guess;
    planar_guess.mean = mrpt::poses::CPose2D(guess.mean);
    const auto planar = AlignPDF(m1, m2, planar_guess, result);

    mrpt::poses::CPose3DPDFGaussian pose;
    pose.copyFrom(*planar);
    pose.mean.setFromValues(
        pose.mean.x(), pose.mean.y(), guess.mean.z(), pose.mean.yaw(), guess.mean.pitch(),
        guess.mean.roll());
    return std::make_shared<mrpt::poses::CPose3DPDFGaussian>(pose);
}
}  // namespace rtob
