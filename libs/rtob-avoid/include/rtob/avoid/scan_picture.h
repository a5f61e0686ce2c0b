// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/dead_reckoning.h>
#include <rtob/avoid/guard_options.h>
#include <rtob/avoid/guard_scan.h>
#include <rtob/core/points.h>

#include <array>
#include <cstdint>

namespace rtob
{
/// What a scan says of a place.
enum class Sight
{
    Hidden,  ///< nothing: behind something, or no beam goes there
    Seen,    ///< something is there
    Free     ///< beams pass through
};

/// What one scan shows, as seen from the vehicle at the moment of its last beam: each beam is put
/// where it was when it was taken.
class ScanPicture
{
 public:
    explicit ScanPicture(const GuardOptions& options);

    /// @return false, and nothing changes, when the scan's time is not among the reckoned ones.
    bool take(const GuardScan& scan, const DeadReckoning& reckoning);
    void clear();

    [[nodiscard]] bool isEmpty() const { return known_bins_ == 0; }
    [[nodiscard]] double time_s() const { return time_s_; }  ///< of the last beam
    [[nodiscard]] const Pose2& poseOdomVehicle() const { return pose_odom_vehicle_; }
    /// What the beams hit.
    [[nodiscard]] const Points& hits() const { return hits_vehicle_; }
    /// Ends of beams that hit nothing; what is behind them is unknown.
    [[nodiscard]] const Points& horizon() const { return horizon_vehicle_; }

    [[nodiscard]] Sight sightOf(float x_vehicle, float y_vehicle) const;

    /// Whether the beams leave a hole wider than max_hole_deg within half_width_rad of a bearing.
    [[nodiscard]] bool isUnknown(double bearing_vehicle_rad, double half_width_rad) const;

 private:
    static constexpr int kBins = 360;  ///< of bearings around the laser, with the vehicle's axes
    struct Bin
    {
        float nearest_m = 0;       ///< of all beams; 0: no beam
        float farthest_hit_m = 0;  ///< 0: no beam hit anything
    };
    /// Of the beams of one bin, which stands between its two neighbours.
    struct BinSight
    {
        float all_free_m = 0;                 ///< as far as all three see nothing
        float nearest_m = 0, farthest_m = 0;  ///< far below 0 where nothing was hit
    };
    void takeBeam(float range_m, const Pose2& pose_vehicle_beam, double half_step_rad);
    void markBins(float x, float y, bool is_hit, double half_step_rad);
    void findHoles();
    void findSights();
    [[nodiscard]] static int wrapped(int bin) { return (bin % kBins + kBins) % kBins; }

    const float tolerance_m_;
    const bool no_return_is_free_;
    const int hole_bins_;
    double time_s_ = 0;
    float max_range_m_ = 0;
    Pose2 pose_odom_vehicle_;
    Eigen::Vector2f laser_vehicle_ = Eigen::Vector2f::Zero();
    Points hits_vehicle_, horizon_vehicle_;
    std::array<Bin, kBins> bins_;
    std::array<BinSight, kBins + 2> sights_;  ///< from the last bin over all to the first again
    std::array<std::int16_t, 2 * kBins + 1> unknown_before_;  ///< sums of unknown bins, two turns
    int known_bins_ = 0;
};
}  // namespace rtob
