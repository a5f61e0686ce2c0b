// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp.h>
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>
#include <rtob/core/reference_draw.h>

#include <cstddef>
#include <optional>

namespace rtob
{
struct ReferenceOptions
{
    double reuse_m = 0.25;
    double reuse_s = 2;
    double less_share = 0.02;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit(
            "reuse_m", s.reuse_m,
            "a drawn sample serves scans until the vehicle is this far from where it was drawn; "
            ">= 0, 0: one draw a scan [sec. 2.3.2]");
        visit("reuse_s", s.reuse_s, "the same in time; >= 0");
        visit(
            "less_share", s.less_share,
            "a sample is drawn anew for a scan whose paired share falls by more than this below "
            "that of the first it served; [0, 1]");
    }
    void validate() const;
};

/// A sample of the map around the vehicle, made ready for matching, that serves several scans: most
/// of what a scan costs is spent on the sample, and a vehicle that has hardly moved would draw
/// nearly the same.
class LocalReference
{
 public:
    explicit LocalReference(const ReferenceOptions& options = {});

    /// Whether a scan may be matched against the sample as it is.
    /// @param needed_map where the scan may need neighbours.
    [[nodiscard]] bool serves(
        double time_s, const Pose2& pose_map_init, const Box& needed_map) const;

    /// What should be drawn, so that it serves the next scans, too.
    [[nodiscard]] Box wanted(const Box& needed_map) const
    {
        return needed_map.grown(options_.reuse_m);
    }

    /// Draws anew: draw(box_map, reference) is called with wanted() and fills the reference.
    template <class Draw>
    void renew(
        const Icp& icp, double time_s, const Pose2& pose_map_init, const Box& needed_map,
        Draw&& draw)
    {
        covered_map_ = wanted(needed_map);
        draw(covered_map_, sample_);
        icp.prepare(sample_.points.view(), prepared_);
        drawn_s_ = time_s;
        drawn_at_ = pose_map_init;
        first_share_.reset();
    }

    /// The next scan draws anew.
    void drop() { drawn_at_.reset(); }

    [[nodiscard]] IcpResult align(
        Icp& icp, const PointsView& points_turned, const Pose2& pose_map_init,
        IcpReach reach = IcpReach::Far);

    /// Whether the sample explains this scan worse than the first.
    [[nodiscard]] bool isWorse(const IcpResult& fit) const;

    [[nodiscard]] std::size_t size() const { return sample_.indices.size(); }

 private:
    ReferenceOptions options_;
    Reference sample_;
    IcpReference prepared_;
    Box covered_map_;
    double drawn_s_ = 0;
    std::optional<Pose2> drawn_at_;
    std::optional<double> first_share_;
};
}  // namespace rtob
