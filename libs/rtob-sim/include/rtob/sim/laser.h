// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/sim/noise.h>
#include <rtob/sim/pose3.h>
#include <rtob/sim/scene.h>

#include <optional>
#include <vector>

namespace rtob::sim
{
/// A turning 2D laser; the defaults are an RPLidar A2M4.
struct LaserOptions
{
    int beams = 360;
    double rate_hz = 10;
    double field_of_view_deg = 360;
    double min_range_m = 0.15;
    double max_range_m = 6;
    double noise_m = 0.005;
    double noise_per_m = 0.003;
    double dropout = 0.01;
    bool clockwise = true;
    double stamp_at = 0.5;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("beams", s.beams, "a scan, evenly over the field of view; 1 to 100000");
        visit("rate_hz", s.rate_hz, "turns, and so scans, a second; > 0");
        visit("field_of_view_deg", s.field_of_view_deg, "around the front; > 0 to 360");
        visit("min_range_m", s.min_range_m, "nothing nearer is measured; >= 0");
        visit("max_range_m", s.max_range_m, "nothing farther is measured; > min_range_m");
        visit("noise_m", s.noise_m, "standard deviation of a range at 0 m; >= 0");
        visit("noise_per_m", s.noise_per_m, "and what each metre adds to it; >= 0");
        visit("dropout", s.dropout, "chance that a beam is lost, whatever it meets; 0 to 1");
        visit("clockwise", s.clockwise, "the way it turns, seen from above");
        visit(
            "stamp_at", s.stamp_at,
            "what a scan's stamp tells, as a share of its turn: 0 its first beam, 0.5 its middle; "
            "0 to 1");
    }
    /// Throws std::invalid_argument naming key, value and range.
    void validate() const;

    [[nodiscard]] double step_rad() const;  ///< from beam to beam, as it turns: clockwise is < 0
    [[nodiscard]] double first_bearing_rad() const;  ///< as seen from the vehicle
    [[nodiscard]] double period_s() const { return 1 / rate_hz; }
    [[nodiscard]] double beam_interval_s() const
    {
        return period_s() * field_of_view_deg / 360 / beams;
    }
};

/// One turn. Ranges in the order in which they were measured; 0 where nothing came back.
struct LaserScan
{
    double time_s = 0;        ///< its stamp: see LaserOptions::stamp_at
    double first_beam_s = 0;  ///< when the first beam was taken
    double beam_interval_s = 0;
    double first_bearing_rad = 0, step_rad = 0;
    Pose3 pose_map_vehicle;  ///< the truth at the stamp
    std::vector<float> ranges_m;

    [[nodiscard]] double bearing_rad(std::size_t beam) const
    {
        return first_bearing_rad + static_cast<double>(beam) * step_rad;
    }
};

/// Takes beams while the vehicle moves. The laser sits at the vehicle's origin.
class Laser
{
 public:
    Laser(const LaserOptions& options, std::uint64_t seed);

    /// All beams that fall into [from_s, to_s), while the vehicle goes straight from one pose to
    /// the other. The scene must be that of this time.
    void sweep(
        const Scene& scene, double from_s, const Pose3& from_map, double to_s, const Pose3& to_map);
    /// The last finished scan, once.
    [[nodiscard]] std::optional<LaserScan> takeScan();

    /// A whole scan at one instant, as if the laser turned infinitely fast.
    [[nodiscard]] LaserScan snapshot(const Scene& scene, double time_s, const Pose3& pose_map);
    [[nodiscard]] const LaserOptions& options() const { return options_; }

 private:
    [[nodiscard]] double beamTime() const;   ///< of the next beam
    [[nodiscard]] double stampTime() const;  ///< of the scan being taken
    void startScan(double time_s);
    void castBundle(const Scene& scene, const std::vector<Pose3>& poses_map);
    [[nodiscard]] float measure(const Scene& scene, Beam beam);
    [[nodiscard]] float reading(double range_m);

    LaserOptions options_;
    Noise noise_;
    std::uint64_t turn_ = 0;  ///< of the scan being taken
    LaserScan scan_;          ///< being taken
    bool is_stamped_ = false;
    std::optional<LaserScan> finished_;
    std::vector<Pose3> poses_map_;  ///< of the bundle at hand, one a beam
    std::vector<Beam> beams_;       ///< of the bundle at hand
    Selection selection_;
};
}  // namespace rtob::sim
