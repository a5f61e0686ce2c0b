// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace rtob
{
/// How much a pair counts, by its residual e and the kernel's scale c.
enum class RobustKernel
{
    None,    ///< 1
    Huber,   ///< 1 up to c, then c / |e|
    Cauchy,  ///< 1 / (1 + (e / c)^2)
    Tukey    ///< (1 - (e / c)^2)^2 up to c, then 0
};

constexpr auto enum_names(RobustKernel)
{
    return std::array<std::pair<RobustKernel, std::string_view>, 4>{
        {{RobustKernel::None, "none"},
         {RobustKernel::Huber, "huber"},
         {RobustKernel::Cauchy, "cauchy"},
         {RobustKernel::Tukey, "tukey"}}};
}

/// What a sum over pairs reads; blocks of as many as the lanes are.
struct PairColumns
{
    const float *x, *y, *u, *v, *nx, *ny, *d2;
    std::size_t blocks;
};

/// The points of a scan, moved to where they are believed to be, each with its neighbour in the
/// reference or alone. One array a quantity, so that the sums over all pairs use the processor's
/// lanes.
class PairTable
{
 public:
    struct Neighbour
    {
        float x, y;                ///< m
        float normal_x, normal_y;  ///< of its line, unit; both 0: it is on no line
    };

    /// Of a point that is alone: a finite place, so that a weight of 0 takes it out of all sums,
    /// whose square is finite, too.
    static constexpr Neighbour kAlone{1e15f, 1e15f, 0, 0};

    /// Takes the memory for so many scan points.
    void reserve(std::size_t scan_points);

    /// Room for so many scan points, all alone.
    void reset(std::size_t scan_points);

    /// Moves the scan: as many points as given to reset(). @param pose of the scan.
    void move(const PointsView& scan, const Pose2& pose);
    void pair(std::size_t i, const Neighbour& neighbour)
    {
        neighbour_x_[i] = neighbour.x;
        neighbour_y_[i] = neighbour.y;
        normal_x_[i] = neighbour.normal_x;
        normal_y_[i] = neighbour.normal_y;
    }
    void leaveAlone(std::size_t i) { pair(i, kAlone); }
    /// Takes the distances of the pairs; farther ones do not count. To be called after moves.
    void measure(double max_distance_m);

    [[nodiscard]] std::size_t scanPoints() const { return size_; }
    [[nodiscard]] std::size_t pairs() const { return pairs_; }
    [[nodiscard]] bool isPaired(std::size_t i) const { return squared_distance_[i] <= limit2_; }
    [[nodiscard]] float squaredDistance(std::size_t i) const { return squared_distance_[i]; }
    /// The scan points, moved.
    [[nodiscard]] PointsView points() const { return {x_.data(), y_.data(), size_}; }
    [[nodiscard]] PairColumns columns() const;

    /// Weighs each pair by its distance; with `to_line` that of the pair from its line, where it
    /// is on one. To be called before the sums below.
    void weigh(RobustKernel kernel, double scale_m, bool to_line);

    /// The weighted least-squares rigid motion from the scan points to their neighbours, in closed
    /// form (2-D Umeyama). The identity where nothing counts.
    [[nodiscard]] Pose2 rigidMotion() const;

    /// The normal equations h step = -g of the weighted squared distances from the lines; yaw turns
    /// about `center`. Distances along a line count by `along_line`, pairs on no line both ways.
    struct NormalEquations
    {
        Eigen::Matrix3d h;
        Eigen::Vector3d g;
    };
    [[nodiscard]] NormalEquations normalEquations(
        double center_x, double center_y, double along_line) const;

 private:
    [[nodiscard]] std::size_t blocks() const;

    std::size_t size_ = 0, pairs_ = 0;
    float limit2_ = 0;  ///< m^2
    // Filled up to a whole number of lanes with points that are alone.
    std::vector<float> x_, y_, neighbour_x_, neighbour_y_, normal_x_, normal_y_, squared_distance_;
    std::vector<float> weight_;
};
}  // namespace rtob
