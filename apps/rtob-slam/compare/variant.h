// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>

#include <cstdint>
#include <optional>
#include <string>

namespace rtob
{
/// What every program under comparison is given, a scan at a time.
struct ScanStep
{
    double time_s = 0;  ///< map time: never runs back
    /// Beams that nobody shall use are marked invalid; the program may keep or change it.
    mrpt::obs::CObservation2DRangeScan::Ptr scan;
    /// Where odometry says the vehicle is at this scan; none where it said nothing since the last.
    std::optional<Pose2> pose_odom_vehicle;
};

/// The map that a program has made.
struct VariantMap
{
    Points points;  ///< for a picture, in the program's own map frame
    std::uint64_t size = 0;
    std::string unit = "points";  ///< of size
};

/// A SLAM program under comparison.
class Variant
{
 public:
    Variant() = default;
    Variant(const Variant&) = delete;
    Variant& operator=(const Variant&) = delete;
    virtual ~Variant() = default;

    /// Takes odometry and scan, and says where the vehicle was at this scan: pose_map_vehicle.
    virtual Pose2 process(const ScanStep& step) = 0;

    [[nodiscard]] virtual VariantMap map() const = 0;

    /// At how many scans the program itself said that it did not know where it was; none where it
    /// has no way to say so.
    [[nodiscard]] virtual std::optional<std::uint64_t> lostScans() const { return std::nullopt; }
};
}  // namespace rtob
