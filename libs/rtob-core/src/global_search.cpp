// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/global_search.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace rtob
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kMostPoints = 90;    // of the scan
constexpr double kPointGap_m = 0.15;       // between two of them, so that near walls do not rule
constexpr double kHeadingStep_rad = 0.02;  // 0.2 m at 10 m
constexpr std::size_t kUsualNodes = 1 << 15;
constexpr int kTop = MapRaster::kLevels - 1;
constexpr int kLeaf = 1;  // two cells: ICP's reach is larger
// A place that scores less than this share of the best one is no rival.
constexpr double kRivalShare = 0.75;
// Nearer places are the same.
constexpr double kSame_m = 0.5, kSame_rad = 0.26;
}  // namespace

void GlobalSearch::begin(
    const MapRaster& raster, const PointsView& points_vehicle, double min_score)
{
    thin(points_vehicle);
    turnPoints(raster);
    nodes_.clear();
    nodes_.reserve(kUsualNodes);
    candidates_.clear();
    candidates_.reserve(kMostCandidates + 1);
    next_heading_ = 0;
    next_node_ = looks_ = 0;
    const double most = MapRaster::kHit * static_cast<double>(thinned_.size());
    least_ = mark_ = std::max(0, static_cast<int>(std::ceil(min_score * most)) - 1);
    if (raster.empty() || thinned_.size() == 0) next_heading_ = headings_;
}

double GlobalSearch::mostLeftOut() const
{
    return candidates_.size() < kMostCandidates ? 0.0 : candidates_.back().score;
}

void GlobalSearch::thin(const PointsView& points_vehicle)
{
    thinned_.clear();
    for (std::size_t i = 0; i < points_vehicle.size; ++i)
    {
        const float x = points_vehicle.x[i], y = points_vehicle.y[i];
        if (thinned_.size() == 0 ||
            std::hypot(x - thinned_.x.back(), y - thinned_.y.back()) >= kPointGap_m)
            thinned_.add(x, y);
    }
    if (thinned_.size() <= kMostPoints) return;
    const double step = static_cast<double>(thinned_.size()) / static_cast<double>(kMostPoints);
    for (std::size_t k = 0; k < kMostPoints; ++k)
    {
        const auto from = static_cast<std::size_t>(step * static_cast<double>(k));
        thinned_.x[k] = thinned_.x[from];
        thinned_.y[k] = thinned_.y[from];
    }
    thinned_.x.resize(kMostPoints);
    thinned_.y.resize(kMostPoints);
}

void GlobalSearch::turnPoints(const MapRaster& raster)
{
    headings_ = static_cast<int>(std::ceil(2 * kPi / kHeadingStep_rad));
    offsets_.clear();
    offsets_.reserve(kMostPoints * static_cast<std::size_t>(headings_));
    for (int yaw = 0; yaw < headings_; ++yaw)
    {
        const double angle = 2 * kPi * yaw / headings_, c = std::cos(angle), s = std::sin(angle);
        const auto cells = [&](double length_m)
        {
            return static_cast<std::int16_t>(
                std::clamp(std::lround(length_m / raster.cell_m()), -32000L, 32000L));
        };
        for (std::size_t i = 0; i < thinned_.size(); ++i)
        {
            const double x = thinned_.x[i], y = thinned_.y[i];
            offsets_.push_back({cells(c * x - s * y), cells(s * x + c * y)});
        }
    }
}

bool GlobalSearch::advance(const MapRaster& raster, std::size_t looks)
{
    looks_ = 0;
    for (; next_heading_ < headings_; ++next_heading_)
    {
        if (looks_ >= looks) return false;
        boundHeading(raster, next_heading_);
        if (next_heading_ + 1 == headings_)
            std::sort(
                nodes_.begin(), nodes_.end(),
                [](const Node& a, const Node& b) { return a.score > b.score; });
    }
    for (; next_node_ < nodes_.size() && nodes_[next_node_].score > mark_; ++next_node_)
    {
        if (looks_ >= looks) return false;
        branch(raster, kTop, nodes_[next_node_]);
    }
    return true;
}

void GlobalSearch::boundHeading(const MapRaster& raster, int yaw)
{
    for (int y = 0; y < raster.height(); y += 1 << kTop)
        for (int x = 0; x < raster.width(); x += 1 << kTop)
        {
            if (!raster.isSeen(kTop, x, y)) continue;
            Node node{x, y, static_cast<std::int16_t>(yaw), 0};
            node.score = static_cast<std::int16_t>(scoreOf(raster, kTop, node, least_));
            if (node.score > least_) nodes_.push_back(node);
        }
}

void GlobalSearch::branch(const MapRaster& raster, int level, const Node& node)
{
    if (node.score <= mark_) return;
    if (level == kLeaf) return keep(raster, node);
    const int step = 1 << (level - 1);
    std::array<Node, 4> children{};
    std::size_t n = 0;
    for (int dy = 0; dy <= step; dy += step)
        for (int dx = 0; dx <= step; dx += step)
        {
            Node child = node;
            child.x += dx;
            child.y += dy;
            if (!raster.isSeen(level - 1, child.x, child.y)) continue;
            child.score = static_cast<std::int16_t>(scoreOf(raster, level - 1, child, mark_));
            // Kept in order, best first, so that the first branch sets a high mark.
            std::size_t place = n++;
            for (; place > 0 && children[place - 1].score < child.score; --place)
                children[place] = children[place - 1];
            children[place] = child;
        }
    for (std::size_t i = 0; i < n; ++i) branch(raster, level - 1, children[i]);
}

/// @param mark once the score cannot exceed it any more, whatever it can still reach is returned.
int GlobalSearch::scoreOf(const MapRaster& raster, int level, const Node& node, int mark)
{
    constexpr std::size_t kBetweenLooks = 16;
    const std::size_t count = thinned_.size();
    const Offset* const offsets = offsets_.data() + static_cast<std::size_t>(node.yaw) * count;
    int score = 0;
    for (std::size_t begin = 0; begin < count; begin += kBetweenLooks)
    {
        const int at_most = score + MapRaster::kHit * static_cast<int>(count - begin);
        if (at_most <= mark) return at_most;
        const std::size_t end = std::min(begin + kBetweenLooks, count);
        for (std::size_t i = begin; i < end; ++i)
            score += raster.mark(level, node.x + offsets[i].x, node.y + offsets[i].y);
        looks_ += end - begin;
    }
    return score;
}

void GlobalSearch::keep(const MapRaster& raster, const Node& leaf)
{
    const double most = MapRaster::kHit * static_cast<double>(thinned_.size());
    const PlaceCandidate found{
        {raster.middleX(leaf.x), raster.middleY(leaf.y),
         wrap_angle(2 * kPi * leaf.yaw / headings_)},
        leaf.score / most};
    const auto is_the_same = [&](const PlaceCandidate& other)
    { return is_near(other.pose_map_vehicle, found.pose_map_vehicle, kSame_m, kSame_rad); };
    for (const PlaceCandidate& other : candidates_)
        if (other.score >= found.score && is_the_same(other)) return;
    // Those that the new one outdoes give way, and the rest stays in order.
    candidates_.erase(
        std::remove_if(candidates_.begin(), candidates_.end(), is_the_same), candidates_.end());
    const auto place = std::find_if(
        candidates_.begin(), candidates_.end(),
        [&](const PlaceCandidate& other) { return other.score < found.score; });
    candidates_.insert(place, found);
    if (candidates_.size() > kMostCandidates) candidates_.pop_back();
    const double worst = candidates_.size() == kMostCandidates ? candidates_.back().score : 0.0;
    mark_ = std::max(
        least_,
        static_cast<int>(std::max(worst, kRivalShare * candidates_.front().score) * most) - 1);
}
}  // namespace rtob
