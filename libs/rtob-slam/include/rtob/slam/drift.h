// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/slam/travel_log.h>

#include <cstddef>
#include <optional>

namespace rtob
{
struct DriftOptions
{
    double share = 0.03;
    double trusted_m = 0.3;
    double local_path_m = 20;
    double min_information = 0.04;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "share", s.share,
            "error to expect, as a share of the path since old scans last held the pose; >= 0");
        visit(
            "trusted_m", s.trusted_m,
            "with a larger error to expect, new scans alone are matched against, until old ones "
            "hold the pose again; > 0");
        visit(
            "local_path_m", s.local_path_m,
            "new is also what was seen in this much travel before the pose was last held; >= 0");
        visit(
            "min_information", s.min_information,
            "information a pair along the weak direction below which a fit leaves that direction "
            "open, as along a corridor; [0, 0.5]");
    }
    void validate() const;
};

/// How far the pose may have drifted from the old part of the map. The paper's draw mixes scans of
/// this visit with those of earlier ones (sec. 2.3.3), which helps while both agree, and misleads
/// once they stand apart. So old scans count only while the drift to expect is small.
class Drift
{
 public:
    explicit Drift(const DriftOptions& options = {});

    /// Old scans held the pose with this fit: the drift starts anew, unless it leaves a direction
    /// open.
    void held(const TravelLog& travel, const IcpResult& fit);

    /// The pose is known in the old part of the map.
    void heldNow(const TravelLog& travel) { held_path_m_ = travel.path(); }

    /// Travel since old scans last held the pose.
    [[nodiscard]] double path_m(const TravelLog& travel) const
    {
        return travel.path() - held_path_m_;
    }
    [[nodiscard]] double expected_m(const TravelLog& travel) const
    {
        return options_.share * path_m(travel);
    }

    /// The first scan of the map that agrees with the newest ones.
    [[nodiscard]] std::size_t trustedBegin(const TravelLog& travel) const;

    /// The direction, of unit length, that the fit holds if it holds only one.
    [[nodiscard]] std::optional<Eigen::Vector2d> onlyHeldDirection(const IcpResult& fit) const;

 private:
    DriftOptions options_;
    double held_path_m_ = 0;
};
}  // namespace rtob
