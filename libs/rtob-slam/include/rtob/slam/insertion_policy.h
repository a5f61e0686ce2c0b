// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

namespace rtob
{
struct InsertionOptions
{
    double distance_m = 0;
    double angle_deg = 0;
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

/// Which matched scans join the map: all, or one after a least movement.
class InsertionPolicy
{
 public:
    explicit InsertionPolicy(const InsertionOptions& options = {});

    [[nodiscard]] bool wants(double time_s, const Pose2& pose_map_vehicle) const;
    void inserted(double time_s, const Pose2& pose_map_vehicle);

 private:
    InsertionOptions options_;
    bool any_ = false;
    double last_time_s_ = 0;
    Pose2 last_pose_;
};
}  // namespace rtob
