// SPDX-License-Identifier: BSD-3-Clause
#include "neighbour_search.h"

#include "lanes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace rtob
{
namespace
{
constexpr std::int32_t kFewRows = 2;  // with so few there is nothing to save
// A little more than a distance, so that rounding loses nothing.
constexpr float kRoundUp = 1.00001f;

/// The best candidate of each lane and a lower bound on the lane's others.
struct Best
{
    FloatLanes squared_distance;
    FloatLanes squared_next;
    IndexLanes index;
};

struct Query
{
    float x, y;
    float reach_m;
};

RTOB_INLINE float next_above(float v)
{
    std::uint32_t bits = 0;
    std::memcpy(&bits, &v, sizeof bits);
    ++bits;
    std::memcpy(&v, &bits, sizeof v);
    return v;
}

/// The last lanes may hold points of the cells behind: they are points like any other.
RTOB_INLINE void look_at_run(
    const CellTable& table, std::uint32_t begin, std::uint32_t end, const Query& query, Best& best)
{
    IndexLanes index;
    count_up(begin, index);
    for (std::uint32_t i = begin; i < end; i += kLanes)
    {
        FloatLanes dx, dy;
        load(table.x + i, dx);
        load(table.y + i, dy);
        dx -= query.x;
        dy -= query.y;
        const FloatLanes d2 = dx * dx + dy * dy;
        const IndexLanes nearer = d2 < best.squared_distance;
        const FloatLanes farther = nearer ? best.squared_distance : d2;
        best.squared_next = farther < best.squared_next ? farther : best.squared_next;
        best.squared_distance = nearer ? d2 : best.squared_distance;
        best.index = nearer ? index : best.index;
        index += static_cast<std::int32_t>(kLanes);
    }
}

/// Calls look(begin, end) for the one or two runs of sorted points in the row's cells within reach.
template <class Look>
RTOB_INLINE void for_runs_of_row(
    const CellTable& table, std::int32_t row, const Query& query, Look&& look)
{
    const std::int32_t mask = table.side - 1;
    const std::int32_t low = cell_of(table, query.x - query.reach_m);
    const std::int32_t high = cell_of(table, query.x + query.reach_m);
    const std::uint32_t* begin = table.cell_begin + (row & mask) * table.side;
    if (high - low >= mask) return look(begin[0], begin[table.side]);
    const std::int32_t first = low & mask, last = high & mask;
    if (first <= last) return look(begin[first], begin[last + 1]);
    // The run crosses the table's edge.
    look(begin[first], begin[table.side]);
    look(begin[0], begin[last + 1]);
}

RTOB_INLINE void look_at_row(
    const CellTable& table, std::int32_t row, const Query& query, Best& best)
{
    for_runs_of_row(
        table, row,
        query, [&](std::uint32_t begin, std::uint32_t end) __attribute__((always_inline)) {
            look_at_run(table, begin, end, query, best);
        });
}

/// Of equally near ones the first.
RTOB_INLINE NeighbourGrid::Neighbour best_of(const Best& best)
{
    constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();
    const float least = smallest(best.squared_distance);
    const IndexLanes is_found = best.index != NeighbourGrid::kNone;
    const IndexLanes candidates = (best.squared_distance == least) & is_found;
    const std::int32_t index = smallest(candidates ? best.index : IndexLanes{} + kNever);
    // All but the winner, and what its own lane put aside.
    const IndexLanes is_winner = best.index == index;
    const float next = smallest(is_winner ? best.squared_next : best.squared_distance);
    return {index == kNever ? NeighbourGrid::kNone : index, least, next};
}

/// Outwards from the middle row: what is found there saves the rows and cells farther out.
RTOB_INLINE NeighbourGrid::Neighbour look_outwards(
    const CellTable& table, Query query, float slack_m, Best& best)
{
    const std::int32_t middle = cell_of(table, query.y);
    std::int32_t low = cell_of(table, query.y - query.reach_m);
    std::int32_t high = cell_of(table, query.y + query.reach_m);
    NeighbourGrid::Neighbour found = best_of(best);
    for (std::int32_t k = 0; middle - k >= low || middle + k <= high; ++k)
    {
        if (middle + k <= high) look_at_row(table, middle + k, query, best);
        if (k > 0 && middle - k >= low) look_at_row(table, middle - k, query, best);
        const std::int32_t before = found.index;
        found = best_of(best);
        if (found.index == before) continue;
        query.reach_m =
            std::min(query.reach_m, std::sqrt(found.squared_distance) * kRoundUp + slack_m);
        low = cell_of(table, query.y - query.reach_m);
        high = cell_of(table, query.y + query.reach_m);
    }
    found.squared_gap = std::min(found.squared_gap, query.reach_m * query.reach_m);
    return found;
}

RTOB_INLINE NeighbourGrid::Neighbour search(
    const CellTable& table, const Query& query, float slack_m)
{
    // The start value lets a point at exactly the radius in.
    const float beyond2 = next_above(query.reach_m * query.reach_m);
    Best best{FloatLanes{} + beyond2, FloatLanes{} + beyond2, IndexLanes{} + NeighbourGrid::kNone};
    const std::int32_t low = cell_of(table, query.y - query.reach_m);
    const std::int32_t high = cell_of(table, query.y + query.reach_m);
    if (high - low > kFewRows) return look_outwards(table, query, slack_m, best);
    for (std::int32_t row = low; row <= high; ++row) look_at_row(table, row, query, best);
    return best_of(best);
}

/// How far it is to a point that is known, and the slack.
RTOB_INLINE float reach_to(
    const CellTable& table, std::int32_t point, float x, float y, float slack_m)
{
    const float dx = table.x[point] - x, dy = table.y[point] - y;
    return std::sqrt(dx * dx + dy * dy) * kRoundUp + slack_m;
}
}  // namespace

RTOB_SIMD_CLONES void sum_neighbours(
    const CellTable& table, float x, float y, float radius_m, NeighbourGrid::Sums& sums)
{
    const Query query{x, y, radius_m};
    FloatLanes n{}, sx{}, sy{}, sxx{}, sxy{}, syy{};
    const std::int32_t low = cell_of(table, y - radius_m);
    const std::int32_t high = std::min(cell_of(table, y + radius_m), low + table.side - 1);
    for (std::int32_t row = low; row <= high; ++row)
        for_runs_of_row(
            table, row,
            query, [&](std::uint32_t begin, std::uint32_t end) __attribute__((always_inline)) {
                IndexLanes index;
                count_up(begin, index);
                for (std::uint32_t i = begin; i < end; i += kLanes)
                {
                    FloatLanes dx, dy;
                    load(table.x + i, dx);
                    load(table.y + i, dy);
                    dx -= x;
                    dy -= y;
                    // Points of the cells behind come in their own run, if at all.
                    const IndexLanes counts = (dx * dx + dy * dy <= radius_m * radius_m) &
                                              (index < static_cast<std::int32_t>(end));
                    const FloatLanes one = counts ? FloatLanes{} + 1.0f : FloatLanes{};
                    dx = counts ? dx : FloatLanes{};
                    dy = counts ? dy : FloatLanes{};
                    n += one;
                    sx += dx;
                    sy += dy;
                    sxx += dx * dx;
                    sxy += dx * dy;
                    syy += dy * dy;
                    index += static_cast<std::int32_t>(kLanes);
                }
            });
    sums = {sum_of(n), sum_of(sx), sum_of(sy), sum_of(sxx), sum_of(sxy), sum_of(syy)};
}

RTOB_SIMD_CLONES void search_neighbours(
    const CellTable& table, const PointsView& queries, const float* radius_m, float max_radius_m,
    float slack_m, NeighbourGrid::Neighbour* found)
{
    std::int32_t before = NeighbourGrid::kNone;
    for (std::size_t i = 0; i < queries.size; ++i)
    {
        Query query{queries.x[i], queries.y[i], radius_m[i]};
        // Such cells have no number; this is also true of what is no number.
        if (!(std::abs(query.x) < NeighbourGrid::kFarthest_m &&
              std::abs(query.y) < NeighbourGrid::kFarthest_m))
        {
            found[i] = {};
            continue;
        }
        if (query.reach_m < 0)
            query.reach_m =
                before == NeighbourGrid::kNone
                    ? max_radius_m
                    : std::min(max_radius_m, reach_to(table, before, query.x, query.y, slack_m));
        found[i] = search(table, query, slack_m);
        if (found[i].index != NeighbourGrid::kNone) before = found[i].index;
    }
}
}  // namespace rtob
