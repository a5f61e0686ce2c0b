// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>
#include <cstdint>
#include <vector>

namespace rtob
{
/// How far from the guess to look: +- in x and in y [m], +- in yaw [rad].
struct SearchWindow
{
    double half_width_m = 2.0;
    double half_angle_rad = 0.2;
    double min_score = 0;  ///< what scores less is not told from nothing: the more, the faster
};

struct SearchResult
{
    Pose2 correction;  ///< as IcpResult::correction: about the origin, along the axes
    double score = 0;  ///< [0, 1] share of the points that fall on the reference
};

/// Finds the best correction in a whole window, whatever lies between: a correlative search on a
/// raster of the reference, by branch and bound over coarser and coarser rasters (as Hess et al.
/// 2016, sec. V). For guesses that are farther off than ICP's pairs reach.
class WideSearch
{
 public:
    /// @param points to be placed, at most a few hundred, seen from the vehicle with map axes.
    /// @param reference in the same frame.
    [[nodiscard]] SearchResult search(
        const PointsView& points, const PointsView& reference, const SearchWindow& window);

 private:
    static constexpr int kLevels = 6;  // the coarsest cell looks 32 fine cells ahead

    struct Shift
    {
        int x, y, score;
    };
    struct CellOf
    {
        int x, y;
    };
    void drawRaster(const PointsView& reference, const Box& within);
    [[nodiscard]] int scoreOf(int level, int shift_x, int shift_y, int mark) const;
    void branch(int level, const Shift& parent, Shift& best);

    int width_ = 0, height_ = 0;
    double min_x_ = 0, min_y_ = 0;
    int half_cells_ = 0;
    std::vector<std::vector<std::uint8_t>> levels_;
    std::vector<CellOf> cells_;  ///< of the turned points
};
}  // namespace rtob
