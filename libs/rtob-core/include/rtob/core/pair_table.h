// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
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

/// Pairs of a scan point, moved to where it is believed to be, and its neighbour in the reference.
/// One array a quantity, so that the sums over all pairs use the processor's lanes.
class PairTable
{
 public:
    struct Pair
    {
        std::uint32_t scan_point;
        std::int32_t neighbour;
        float x, y;                        ///< the scan point, moved; m
        float neighbour_x, neighbour_y;    ///< m
        float normal_x = 0, normal_y = 0;  ///< of the neighbour's line, unit; 0: it is on no line
        float squared_distance = 0;        ///< m^2
    };

    void clear();
    /// Room for so many pairs, so that add() does not look at it.
    void reserve(std::size_t pairs);
    void add(const Pair& pair);

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Pair at(std::size_t i) const;
    [[nodiscard]] std::uint32_t scanPoint(std::size_t i) const { return scan_point_[i]; }

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

    std::size_t size_ = 0;
    std::vector<std::uint32_t> scan_point_;
    std::vector<std::int32_t> neighbour_;
    // Filled up to a whole number of lanes with pairs of weight 0.
    std::vector<float> x_, y_, neighbour_x_, neighbour_y_, normal_x_, normal_y_, squared_distance_;
    std::vector<float> weight_;
};
}  // namespace rtob
