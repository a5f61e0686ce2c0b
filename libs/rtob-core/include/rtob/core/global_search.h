// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/map_raster.h>
#include <rtob/core/points.h>
#include <rtob/core/pose2.h>
#include <cstdint>
#include <vector>

namespace rtob
{
/// A place where a scan may have been taken.
struct PlaceCandidate
{
    Pose2 pose_map_vehicle;
    double score = 0;  ///< [0, 1] share of the scan's points that fall on the map's
};

/// Looks for a scan in a whole map, whatever the heading: branch and bound over a MapRaster, best
/// bounds first. Keeps the best places, not only the best, so that one can see whether it stands
/// alone. The work is done in portions, so that a scan's share of it is bounded.
class GlobalSearch
{
 public:
    static constexpr std::size_t kMostCandidates = 96;

    /// Starts with another scan. The vehicle is looked for where the map was seen to be free.
    /// @param min_score [0, 1] places that score less are none.
    void begin(const MapRaster& raster, const PointsView& points_vehicle, double min_score);

    /// Goes on, for about so many looks into the raster; true when it has come to its end.
    bool advance(const MapRaster& raster, std::size_t looks);

    /// What was found so far, the best first. Places nearer than half a metre and 15 degrees to
    /// each other are one.
    [[nodiscard]] const std::vector<PlaceCandidate>& candidates() const { return candidates_; }

    /// [0, 1] what a place that is not among the candidates may score at most; 0 where none that
    /// matters was left out.
    [[nodiscard]] double mostLeftOut() const;

 private:
    struct Offset
    {
        std::int16_t x, y;  ///< [cells] from the vehicle
    };
    struct Node
    {
        std::int32_t x, y;
        std::int16_t yaw, score;
    };

    void thin(const PointsView& points_vehicle);
    void turnPoints(const MapRaster& raster);
    void boundHeading(const MapRaster& raster, int yaw);
    void branch(const MapRaster& raster, int level, const Node& node);
    [[nodiscard]] int scoreOf(const MapRaster& raster, int level, const Node& node, int mark);
    void keep(const MapRaster& raster, const Node& leaf);

    Points thinned_;
    int headings_ = 0;
    std::vector<Offset> offsets_;  ///< of all headings, one after the other
    std::vector<Node> nodes_;      ///< top blocks that may hold something
    int next_heading_ = 0;
    std::size_t next_node_ = 0, looks_ = 0;
    int least_ = 0, mark_ = 0;  ///< what scores no more is no candidate
    std::vector<PlaceCandidate> candidates_;
};
}  // namespace rtob
