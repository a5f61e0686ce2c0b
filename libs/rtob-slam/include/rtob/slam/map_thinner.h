// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/map/rtob_map.h>
#include <rtob/slam/map_belief.h>
#include <rtob/slam/travel_log.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtob
{
/// Keeps a map under a cap for ever. When the cap is reached, the newest quarter stays, and of the
/// older scans those go that have most others beside them: places are told apart by position and
/// heading, each keeps its share, evenly over time and always its oldest scan, which ties the map
/// to itself. Where even one scan a place is too much, places get larger. A fifth of the cap is
/// made free at once, so that this comes seldom; its cost is bounded by the cap. Allocates nothing
/// after makeRoom().
class MapThinner
{
 public:
    /// @param max_points 0: no cap.
    explicit MapThinner(int max_points) : max_points_(static_cast<std::size_t>(max_points)) {}

    /// All the memory that the map will ever need.
    void makeRoom(RtobMap& map, TravelLog& travel, MapBelief& belief);

    [[nodiscard]] bool isDue(const RtobMap& map, std::size_t more_points) const
    {
        return max_points_ > 0 &&
               (map.size() + more_points > max_points_ || map.scans().size() >= mostScans());
    }

    /// Which scans stay: one entry each.
    [[nodiscard]] const std::vector<char>& choose(const ScanTable& scans);

 private:
    struct Visit
    {
        std::uint64_t place;
        std::uint32_t scan;
    };
    struct Amount
    {
        std::size_t points = 0, scans = 0;
    };

    [[nodiscard]] std::size_t mostScans() const { return max_points_ / 16; }
    [[nodiscard]] Amount target() const { return {max_points_ / 5 * 4, mostScans() / 5 * 4}; }
    [[nodiscard]] bool fits(const Amount& amount) const
    {
        return amount.points <= target().points && amount.scans <= target().scans;
    }
    [[nodiscard]] std::size_t newestBegin(const ScanTable& scans) const;
    void sortByPlace(const ScanTable& scans, std::size_t end, double cell_m, int headings);
    Amount keepAPlace(const ScanTable& scans, std::size_t quota);
    [[nodiscard]] std::size_t mostAPlace() const;

    std::size_t max_points_;
    std::vector<Visit> visits_;  ///< of the older scans, place by place
    std::vector<char> keep_;
};
}  // namespace rtob
