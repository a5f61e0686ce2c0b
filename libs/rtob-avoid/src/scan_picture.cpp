// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/avoid/fast_bearing.h>
#include <rtob/avoid/scan_picture.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
// The vehicle's motion during a sweep is looked up so often and interpolated between.
constexpr std::size_t kKnots = 9;
// A beam speaks for a little more than its share of the circle, as a turning vehicle spreads beams.
constexpr double kBeamShare = 0.6;

/// The laser's poses during a sweep, seen from the vehicle at its end.
class SweepPoses
{
 public:
    /// @return false when the times are not among the reckoned ones
    bool lookUp(const GuardScan& scan, const Pose2& pose_odom_end, const DeadReckoning& reckoning)
    {
        for (std::size_t k = 0; k < kKnots; ++k)
        {
            const double share = static_cast<double>(k) / (kKnots - 1);
            const auto pose = reckoning.poseAt(scan.stamp_s + share * scan.sweep_s);
            if (!pose) return false;
            poses_end_laser_[k] = compose(between(pose_odom_end, *pose), scan.pose_vehicle_laser);
        }
        return true;
    }

    /// @param share 0 for the first beam, 1 for the last
    [[nodiscard]] Pose2 at(double share) const
    {
        const double knot = share * (kKnots - 1);
        const auto k = std::min(static_cast<std::size_t>(knot), kKnots - 2);
        const double rest = knot - static_cast<double>(k);
        const Pose2 &a = poses_end_laser_[k], &b = poses_end_laser_[k + 1];
        return {
            a.x + rest * (b.x - a.x), a.y + rest * (b.y - a.y),
            a.yaw + rest * wrap_angle(b.yaw - a.yaw)};
    }

 private:
    std::array<Pose2, kKnots> poses_end_laser_;
};
}  // namespace

ScanPicture::ScanPicture(const GuardOptions& options)
    : tolerance_m_(static_cast<float>(options.seen_tolerance_m)),
      no_return_is_free_(options.no_return_is_free),
      hole_bins_(static_cast<int>(options.max_hole_deg * kBins / 360))
{
    clear();
}

void ScanPicture::clear()
{
    bins_.fill({});
    hits_vehicle_.clear();
    horizon_vehicle_.clear();
    findHoles();
    findSights();
}

bool ScanPicture::take(const GuardScan& scan, const DeadReckoning& reckoning)
{
    SweepPoses sweep;
    const auto pose_odom_vehicle = reckoning.poseAt(scan.end_s());
    if (!pose_odom_vehicle || !sweep.lookUp(scan, *pose_odom_vehicle, reckoning)) return false;
    clear();
    pose_odom_vehicle_ = *pose_odom_vehicle;
    time_s_ = scan.end_s();
    max_range_m_ = static_cast<float>(scan.max_range_m);
    const Pose2& mount = scan.pose_vehicle_laser;
    laser_vehicle_ = {static_cast<float>(mount.x), static_cast<float>(mount.y)};
    const double last = scan.beams > 1 ? static_cast<double>(scan.beams - 1) : 1;
    for (std::size_t i = 0; i < scan.beams; ++i)
    {
        const auto beam = static_cast<double>(i);
        Pose2 pose_vehicle_beam = sweep.at(beam / last);
        pose_vehicle_beam.yaw += scan.first_bearing_rad + beam * scan.step_rad;
        takeBeam(scan.ranges_m[i], pose_vehicle_beam, kBeamShare * std::abs(scan.step_rad));
    }
    findHoles();
    findSights();
    return true;
}

void ScanPicture::takeBeam(float range_m, const Pose2& pose_vehicle_beam, double half_step_rad)
{
    bool is_hit = range_m > 0 && range_m < max_range_m_;
    if (!is_hit)
    {
        const bool is_beyond = range_m >= max_range_m_;
        if (!is_beyond && !no_return_is_free_) return;
        range_m = max_range_m_;
    }
    const auto x =
        static_cast<float>(pose_vehicle_beam.x + range_m * std::cos(pose_vehicle_beam.yaw));
    const auto y =
        static_cast<float>(pose_vehicle_beam.y + range_m * std::sin(pose_vehicle_beam.yaw));
    (is_hit ? hits_vehicle_ : horizon_vehicle_).add(x, y);
    markBins(x - laser_vehicle_.x(), y - laser_vehicle_.y(), is_hit, half_step_rad);
}

void ScanPicture::markBins(float x, float y, bool is_hit, double half_step_rad)
{
    const float range_m = std::sqrt(x * x + y * y);
    const float turns = turns_of(x, y);
    const auto half_turns = static_cast<float>(half_step_rad / (2 * kPi));
    // One turn more keeps the truncation from rounding up.
    const int first = static_cast<int>((turns - half_turns + 1) * kBins) - kBins;
    const int last = static_cast<int>((turns + half_turns + 1) * kBins) - kBins;
    for (int bin = first; bin <= last; ++bin)
    {
        Bin& marked = bins_[static_cast<std::size_t>(wrapped(bin))];
        const bool is_first = marked.nearest_m == 0;
        marked.nearest_m = is_first ? range_m : std::min(marked.nearest_m, range_m);
        if (is_hit) marked.farthest_hit_m = std::max(marked.farthest_hit_m, range_m);
    }
}

void ScanPicture::findHoles()
{
    known_bins_ = 0;
    for (const Bin& bin : bins_) known_bins_ += bin.nearest_m > 0 ? 1 : 0;
    // A bin is in a hole when the run of bins without beams around it is longer than allowed.
    std::array<bool, 2 * kBins> is_hole{};
    for (int begin = 0; begin < 2 * kBins;)
    {
        int end = begin;
        while (end < 2 * kBins && bins_[static_cast<std::size_t>(end % kBins)].nearest_m == 0)
            ++end;
        const bool is_wide = end - begin > hole_bins_;
        for (int bin = begin; bin < end; ++bin) is_hole[static_cast<std::size_t>(bin)] = is_wide;
        begin = std::max(end, begin + 1);
    }
    unknown_before_[0] = 0;
    for (std::size_t bin = 0; bin < 2 * kBins; ++bin)
    {
        // What one of the two turns cuts apart, the other one holds in one piece.
        const bool hole = is_hole[bin] || is_hole[(bin + kBins) % (2 * kBins)];
        unknown_before_[bin + 1] = static_cast<std::int16_t>(unknown_before_[bin] + (hole ? 1 : 0));
    }
}

/// A copy of the bins with what sightOf() asks for: no wrapping, no special cases.
void ScanPicture::findSights()
{
    constexpr float kNowhere_m = -1e6F;
    for (int i = 0; i < kBins + 2; ++i)
    {
        const auto bin = [&](int off) -> const Bin&
        { return bins_[static_cast<std::size_t>(wrapped(i - 1 + off))]; };
        const bool is_hit = bin(0).farthest_hit_m > 0;
        sights_[static_cast<std::size_t>(i)] = {
            std::min({bin(-1).nearest_m, bin(0).nearest_m, bin(1).nearest_m}),
            is_hit ? bin(0).nearest_m : kNowhere_m, is_hit ? bin(0).farthest_hit_m : kNowhere_m};
    }
}

Sight ScanPicture::sightOf(float x_vehicle, float y_vehicle) const
{
    const float x = x_vehicle - laser_vehicle_.x(), y = y_vehicle - laser_vehicle_.y();
    const float range_m = std::sqrt(x * x + y * y);
    const BinSight* before = &sights_[static_cast<std::size_t>(sector_of(x, y, kBins))];
    if (before[1].all_free_m > range_m + tolerance_m_) return Sight::Free;
    float off_m = std::numeric_limits<float>::infinity();
    for (int i = 0; i < 3; ++i)
        off_m = std::min(
            {off_m, std::abs(before[i].nearest_m - range_m),
             std::abs(before[i].farthest_m - range_m)});
    return off_m <= tolerance_m_ ? Sight::Seen : Sight::Hidden;
}

bool ScanPicture::isUnknown(double bearing_vehicle_rad, double half_width_rad) const
{
    const double middle = (bearing_vehicle_rad / (2 * kPi) + 1) * kBins;
    const double half = half_width_rad / (2 * kPi) * kBins;
    const auto first = static_cast<int>(std::floor(middle - half));
    const int count = std::min(static_cast<int>(std::floor(middle + half)) - first + 1, kBins);
    const auto begin = static_cast<std::size_t>(wrapped(first));
    return unknown_before_[begin + static_cast<std::size_t>(count)] > unknown_before_[begin];
}
}  // namespace rtob
