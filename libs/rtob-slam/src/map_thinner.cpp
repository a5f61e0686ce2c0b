// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/map_thinner.h>

#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double kPlace_m = 0.5;  // at first
constexpr int kHeadings = 12;
constexpr double kTwoPi = 6.283185307179586;

std::size_t points_of(const ScanTable& scans, std::size_t scan)
{
    return static_cast<std::size_t>(scans.firstPoint(scan + 1) - scans.firstPoint(scan));
}

/// Cells of position and heading as one number; 24 bits for x and y each go round, which at worst
/// takes two far places for one.
std::uint64_t place_of(const Pose2& pose, double cell_m, int headings)
{
    const auto cell = [&](double at_m)
    {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(at_m / cell_m))) &
               0xFFFFFF;
    };
    const auto heading =
        static_cast<std::uint64_t>(std::floor((pose.yaw / kTwoPi + 1) * headings)) %
        static_cast<std::uint64_t>(headings);
    return cell(pose.x) << 40 | cell(pose.y) << 16 | heading;
}
}  // namespace

void MapThinner::makeRoom(RtobMap& map, TravelLog& travel, MapBelief& belief)
{
    if (max_points_ == 0) return;
    const std::size_t scans = std::max(mostScans(), map.scans().size() + 1);
    map.reserveOnce(scans, std::max(max_points_, map.size()));
    travel.reserve(scans);
    belief.reserve(scans);
    visits_.reserve(scans);
    keep_.reserve(scans);
}

const std::vector<char>& MapThinner::choose(const ScanTable& scans)
{
    const std::size_t newest = newestBegin(scans);
    double cell_m = kPlace_m;
    for (int headings = kHeadings;; headings = std::max(1, headings / 2), cell_m *= 2)
    {
        sortByPlace(scans, newest, cell_m, headings);
        // The largest share of each place with which the map is small enough.
        std::size_t enough = 0, too_much = mostAPlace() + 1;
        while (too_much - enough > 1)
        {
            const std::size_t quota = (enough + too_much) / 2;
            (fits(keepAPlace(scans, quota)) ? enough : too_much) = quota;
        }
        const bool is_one_place = mostAPlace() == visits_.size();
        if (enough == 0 && !is_one_place) continue;
        keepAPlace(scans, enough);
        return keep_;
    }
}

/// The newest scans with a quarter of what may stay.
std::size_t MapThinner::newestBegin(const ScanTable& scans) const
{
    Amount newest;
    std::size_t begin = scans.size();
    while (begin > 0)
    {
        newest.points += points_of(scans, begin - 1);
        ++newest.scans;
        if (4 * newest.points > target().points || 4 * newest.scans > target().scans) break;
        --begin;
    }
    return begin;
}

void MapThinner::sortByPlace(const ScanTable& scans, std::size_t end, double cell_m, int headings)
{
    visits_.clear();
    for (std::size_t scan = 0; scan < end; ++scan)
        visits_.push_back(
            {place_of(scans.pose(scan), cell_m, headings), static_cast<std::uint32_t>(scan)});
    std::sort(
        visits_.begin(), visits_.end(),
        [](const Visit& a, const Visit& b)
        { return a.place != b.place ? a.place < b.place : a.scan < b.scan; });
    keep_.assign(scans.size(), 1);
}

std::size_t MapThinner::mostAPlace() const
{
    std::size_t most = 0;
    for (std::size_t begin = 0, k = 0; k < visits_.size(); ++k)
    {
        if (visits_[k].place != visits_[begin].place) begin = k;
        most = std::max(most, k - begin + 1);
    }
    return most;
}

/// Keeps at most so many scans of each place, and the newest.
MapThinner::Amount MapThinner::keepAPlace(const ScanTable& scans, std::size_t quota)
{
    for (std::size_t begin = 0, end = 0; begin < visits_.size(); begin = end)
    {
        while (end < visits_.size() && visits_[end].place == visits_[begin].place) ++end;
        const std::size_t count = end - begin, kept = std::min(quota, count);
        for (std::size_t k = 0; k < count; ++k)
        {
            const bool is_first_of_its_share = k == 0 || k * kept / count != (k - 1) * kept / count;
            keep_[visits_[begin + k].scan] = kept > 0 && is_first_of_its_share;
        }
    }
    Amount amount;
    for (std::size_t scan = 0; scan < scans.size(); ++scan)
        if (keep_[scan] != 0)
        {
            amount.points += points_of(scans, scan);
            ++amount.scans;
        }
    return amount;
}
}  // namespace rtob
