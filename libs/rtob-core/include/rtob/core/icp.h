// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/correspondences.h>
#include <rtob/core/icp_reference.h>
#include <rtob/core/pair_table.h>
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>
#include <Eigen/Core>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace rtob
{
enum class IcpMetric
{
    PointToPoint,  ///< the paper's, closed form
    PointToLine    ///< distance to the local line of the reference
};

constexpr auto enum_names(IcpMetric)
{
    return std::array<std::pair<IcpMetric, std::string_view>, 2>{
        {{IcpMetric::PointToPoint, "point_to_point"}, {IcpMetric::PointToLine, "point_to_line"}}};
}

struct IcpOptions
{
    int iterations = 16;
    double max_pair_distance_m = 0.60;
    double final_pair_distance_m = 0.20;
    IcpMetric metric = IcpMetric::PointToLine;
    RobustKernel kernel = RobustKernel::Tukey;
    double kernel_scale_m = 0.20;
    double line_radius_m = 0.30;
    double weak_share = 0.10;
    int cell_points = 6;
    double stop_step_m = 0.001;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("iterations", s.iterations, "iterations at most; >= 1 [sec. 2.3.1]");
        visit(
            "max_pair_distance_m", s.max_pair_distance_m,
            "pairs farther apart are dropped; > 0 [sec. 2.3.1: maximum correspondence distance]");
        visit(
            "final_pair_distance_m", s.final_pair_distance_m,
            "the same at the end: it shrinks over the first half of the iterations; > 0, at most "
            "max_pair_distance_m");
        visit("metric", s.metric, "what is made small: the paper's point to point, or to the line");
        visit("kernel", s.kernel, "robust weight of a pair");
        visit(
            "kernel_scale_m", s.kernel_scale_m,
            "the kernel's scale at the final pair distance, in proportion before; > 0");
        visit(
            "line_radius_m", s.line_radius_m,
            "reference points within this of a point make its line; > 0, at most "
            "max_pair_distance_m");
        visit(
            "weak_share", s.weak_share,
            "point to line: the guess holds the direction along which less than this share of the "
            "pairs pulls, as along a corridor; 0: never; [0, 0.5]");
        visit(
            "cell_points", s.cell_points,
            "reference points kept in each cell of an eighth of max_pair_distance_m, the oldest "
            "first; 0: all");
        visit(
            "stop_step_m", s.stop_step_m,
            "stop after a smaller step once the pair distance is final; 0: never, so that the cost "
            "is "
            "constant [sec. 2.3.1]");
    }
    void validate() const;
};

/// What one alignment found. The correction turns about the pre-aligned vehicle position and shifts
/// along the map's axes, so that eq. 4 is exact: x' = x_init + x_icp, psi' = psi_init + psi_icp.
struct IcpResult
{
    Pose2 correction;
    int iterations = 0;
    std::size_t pairs = 0;
    double paired_share = 0;        ///< [0, 1] of the scan's points
    double known_share = 0;         ///< [0, 1] of the points where the reference knows something
    double mean_squared_error = 0;  ///< m^2, over the pairs [sec. 2.1.3]
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of x, y, yaw, for 1 m of noise
    /// Of x, y, yaw; m^2, rad^2. Honest: pairs err alike, and bare walls feign to tell the place.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// The direction of translation that pairs say least about.
struct WeakDirection
{
    double share = 0.5;    ///< of the information of both directions; [0, 0.5]
    double angle_rad = 0;  ///< seen from x, in (-pi/2, pi/2]
};
/// @param information of x, y, yaw
[[nodiscard]] WeakDirection weak_direction(const Eigen::Matrix3d& information);

/// What is known of the correction before the scan is looked at: its mean is zero.
struct CorrectionPrior
{
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of x, y, yaw, relative to one pair
};

/// Where the pair distance begins to shrink: the paper's maximum, or the final one already, for a
/// guess that is known to be good.
enum class IcpReach
{
    Far,
    Near
};

/// Eq. 4: the pre-aligned pose with the correction.
[[nodiscard]] Pose2 apply_correction(const Pose2& pose_map_vehicle_init, const Pose2& correction);

/// The fixed-iteration ICP of sec. 2.1.3 and 2.3.1. Keeps buffers only: allocates nothing once
/// warm.
class Icp
{
 public:
    explicit Icp(const IcpOptions& options = {});

    /// @param scan pre-aligned: map axes, seen from the pre-aligned vehicle position.
    /// @param reference in the same frame.
    [[nodiscard]] IcpResult align(
        const PointsView& scan, const PointsView& reference, const CorrectionPrior& prior = {});

    /// The same against a reference that was made ready before.
    /// @param origin the pre-aligned vehicle position, seen from where the reference is.
    /// @param reach how far the guess may be off.
    [[nodiscard]] IcpResult align(
        const PointsView& scan, IcpReference& reference, const Eigen::Vector2d& origin,
        const CorrectionPrior& prior = {}, IcpReach reach = IcpReach::Far);

    /// Makes points ready for align() with these options.
    void prepare(const PointsView& points, IcpReference& reference) const;

 private:
    void takeMemory(std::size_t scan_points);
    [[nodiscard]] static bool isAtRest(const Pose2& before, const Pose2& now, double step_m);
    [[nodiscard]] double pairDistance(int iteration, IcpReach reach) const;
    [[nodiscard]] Pose2 fit(
        const Pose2& pose, const Pose2& start, const CorrectionPrior& prior) const;
    [[nodiscard]] std::size_t countKnown(const NeighbourGrid& reference) const;
    void describe(IcpReference& reference, const Pose2& pose, IcpResult& result);

    IcpOptions options_;
    IcpReference own_reference_;
    PairTable pairs_;  ///< the scan under the current correction
    Correspondences correspondences_;
};
}  // namespace rtob
