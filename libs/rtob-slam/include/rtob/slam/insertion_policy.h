// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

#include <string>
#include <vector>

namespace rtob
{
struct InsertionOptions
{
    double distance_m = 0.1;
    double angle_deg = 5;
    double interval_s = 2;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "distance_m", s.distance_m,
            "write a scan after this motion; 0 here and in angle_deg: every scan; >= 0");
        visit("angle_deg", s.angle_deg, "or after this turn; >= 0");
        visit(
            "interval_s", s.interval_s,
            "or after this time, so that a changing world is seen; > 0");
    }
    void validate() const;
};

/// Which matched scans join the map: all, or those of each laser after a least movement. A vehicle
/// that stands writes little, so people who walk past do not become what it is matched against.
class InsertionPolicy
{
 public:
    explicit InsertionPolicy(const InsertionOptions& options = {});

    /// @param laser the sensor's label: each laser sees another part of the world.
    [[nodiscard]] bool wants(
        const std::string& laser, double time_s, const Pose2& pose_map_vehicle) const;
    void inserted(const std::string& laser, double time_s, const Pose2& pose_map_vehicle);
    /// The map begins anew.
    void clear() { last_.clear(); }

 private:
    struct Insertion
    {
        std::string laser;
        double time_s;
        Pose2 pose_map_vehicle;
    };

    InsertionOptions options_;
    std::vector<Insertion> last_;  ///< of each laser
};
}  // namespace rtob
