// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/icp_reference.h>
#include <rtob/core/neighbour_grid.h>
#include <rtob/core/pair_table.h>
#include <rtob/core/points.h>
#include <cstdint>
#include <vector>

namespace rtob
{
/// Keeps the points of a scan that moves a little from call to call paired with their nearest
/// reference points.
///
/// A point keeps its neighbour without a search as long as it has moved by less than the other
/// candidates are farther: exact, and nearly free once the scan rests. Nothing is allocated once
/// warm.
class Correspondences
{
 public:
    /// Takes the memory for so many scan points.
    void reserve(std::size_t scan_points);

    /// Forgets what is known of the scan before.
    void reset(std::size_t scan_points);

    /// Pairs all points of the table that have a neighbour within the radius, and measures them.
    /// @param max_distance_m at most that which the reference was built for.
    /// @param with_lines whether the pairs need their lines.
    void find(IcpReference& reference, double max_distance_m, bool with_lines, PairTable& table);

    /// The neighbour of a scan point, NeighbourGrid::kNone where none was within the radius.
    [[nodiscard]] std::int32_t neighbour(std::size_t i) const { return neighbour_[i]; }

 private:
    void choose(const PairTable& table, float radius_m);

    // What the last search of each scan point said, and where it stood then.
    Points searched_at_;
    std::vector<std::int32_t> neighbour_;
    std::vector<float> gap_m_;  ///< no other point was nearer

    // Of the current call.
    std::vector<float> room_m_;             ///< > 0: neighbour_ is surely still right
    std::vector<std::uint32_t> unsettled_;  ///< the scan points to be searched
    Points queries_;
    std::vector<float> reach_m_;
    std::vector<NeighbourGrid::Neighbour> found_;
};
}  // namespace rtob
