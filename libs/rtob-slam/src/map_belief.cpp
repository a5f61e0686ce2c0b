// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/slam/map_belief.h>

#include <algorithm>

namespace rtob
{
namespace
{
constexpr double kNear_m = 4;
// Whose mean is taken, evenly over time, however many there are.
constexpr std::size_t kMostScans = 64;
constexpr std::size_t kScanBlock = 1 << 12;  // memory grows seldom, as the map's does

/// Calls visit(row, column, k) for the six numbers of a symmetric matrix.
template <class Visit>
void each_number(const Visit& visit)
{
    std::size_t k = 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column <= row; ++column) visit(row, column, k++);
}
}  // namespace

MapBelief::MapBelief()
{
    visits_.reserve(kMostVisits);
}

void MapBelief::inserted(const Eigen::Matrix3d& covariance)
{
    if (of_scan_.size() == of_scan_.capacity())
        of_scan_.reserve(std::max(2 * of_scan_.size(), kScanBlock));
    Packed& packed = of_scan_.emplace_back();
    each_number([&](int row, int column, std::size_t k)
                { packed[k] = static_cast<float>(covariance(row, column)); });
}

void MapBelief::keepOnly(const std::vector<char>& keep)
{
    std::size_t kept = 0;
    for (std::size_t scan = 0; scan < of_scan_.size(); ++scan)
        if (keep[scan] != 0) of_scan_[kept++] = of_scan_[scan];
    of_scan_.resize(kept);
}

Eigen::Matrix3d MapBelief::near(const MapView& map, const Pose2& pose_map, std::size_t end)
{
    map.visits.query(Box::around(pose_map.x, pose_map.y, kNear_m), map.scans, kMostVisits, visits_);
    std::size_t scans = 0;
    for (ScanRange& visit : visits_)
    {
        visit.end = std::min(visit.end, end);
        scans += visit.end > visit.first ? visit.end - visit.first : 0;
    }
    const std::size_t stride = scans / kMostScans + 1;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    std::size_t summed = 0;
    for (const ScanRange& visit : visits_)
        for (std::size_t scan = visit.first; scan < visit.end; scan += stride, ++summed)
            each_number([&, &packed = of_scan_[scan]](int row, int column, std::size_t k)
                        { sum(row, column) += static_cast<double>(packed[k]); });
    if (summed == 0) return sum;
    sum /= static_cast<double>(summed);
    return sum.selfadjointView<Eigen::Lower>();
}
}  // namespace rtob
