// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/core/reference_draw.h>
#include <algorithm>
#include <cmath>

namespace rtob
{
namespace
{
constexpr std::size_t kUnits = 512;    // strata of time in which p(t) is looked at once
constexpr int kMaxRounds = 4;          // a gate may throw points away: try again this often
constexpr std::size_t kMaxTries = 16;  // proposals a point, independent draws
}  // namespace

void DrawOptions::validate() const
{
    require(points >= 10, "points", points, ">= 10");
}

ReferenceDraw::ReferenceDraw(const DrawOptions& options) : options_(options)
{
    options_.validate();
    const auto n = static_cast<std::size_t>(options_.points);
    stretches_.reserve(4 * TimeDensity::kMaxVisits);
    envelope_before_.reserve(4 * TimeDensity::kMaxVisits + 1);
    units_.reserve(kUnits);
    picked_.reserve(kMaxRounds * n);
}

void ReferenceDraw::draw(
    const MapView& map, const TimeDensity& density, const Moment& now,
    const std::optional<Box>& gate, Random& random, Reference& reference)
{
    const auto wanted = static_cast<std::size_t>(options_.points);
    reference.points.clear();
    reference.points.reserve(wanted);
    reference.indices.clear();
    reference.indices.reserve(wanted);
    reference.origin_x = now.x;
    reference.origin_y = now.y;

    density.support(map.scans, map.visits, now, stretches_);
    lookUpStretches(map.scans);
    if (support_points_ <= (gate ? kMaxRounds * wanted : wanted))
    {
        takeAll(map, density, now);
        if (gate) dropOutside(*gate, map.points_map);
        if (picked_.size() <= wanted) return gather(map.points_map, gate, reference);
    }
    const bool stratified = options_.mode == DrawMode::Stratified;
    if (stratified) makeUnits(map, density, now, random);
    double share_kept = 1;
    for (int round = 0; round < kMaxRounds && reference.indices.size() < wanted; ++round)
    {
        const std::size_t before = reference.indices.size();
        const double missing = static_cast<double>(wanted - before) / share_kept;
        const auto count = static_cast<std::size_t>(
            std::min(std::ceil(missing), static_cast<double>(kMaxRounds * wanted)));
        picked_.clear();
        if (stratified)
            pickStratified(count, random);
        else
            pickIndependent(map, density, now, count, random);
        if (picked_.empty()) break;
        gather(map.points_map, gate, reference);
        share_kept = std::max(
            0.1, static_cast<double>(reference.indices.size() - before) /
                     static_cast<double>(picked_.size()));
    }
}

/// Lays the stretches end to end on one axis, each as long as its points x its bound.
void ReferenceDraw::lookUpStretches(const ScanTable& scans)
{
    envelope_before_.assign(1, 0.0);
    support_points_ = 0;
    for (const Stretch& s : stretches_)
    {
        const std::uint64_t points =
            scans.firstPoint(s.scans.end) - scans.firstPoint(s.scans.first);
        support_points_ += points;
        envelope_before_.push_back(envelope_before_.back() + static_cast<double>(points) * s.bound);
    }
}

void ReferenceDraw::takeAll(const MapView& map, const TimeDensity& density, const Moment& now)
{
    picked_.clear();
    for (const Stretch& s : stretches_)
        for (std::size_t scan = s.scans.first; scan < s.scans.end; ++scan)
        {
            if (density.weight(map.scans, now, scan) <= 0) continue;
            for (auto i = map.scans.firstPoint(scan); i < map.scans.firstPoint(scan + 1); ++i)
                picked_.push_back(i);
        }
}

void ReferenceDraw::dropOutside(const Box& gate, const PointsView& points_map)
{
    const auto outside = [&](std::uint64_t i)
    { return !gate.contains(points_map.x[i], points_map.y[i]); };
    picked_.erase(std::remove_if(picked_.begin(), picked_.end(), outside), picked_.end());
}

void ReferenceDraw::pickIndependent(
    const MapView& map, const TimeDensity& density, const Moment& now, std::size_t count,
    Random& random)
{
    const double total = envelope_before_.back();
    for (std::size_t tries = 0; tries < kMaxTries * count && picked_.size() < count; ++tries)
    {
        const double position = random.uniform() * total;
        const auto after =
            std::upper_bound(envelope_before_.begin() + 1, envelope_before_.end() - 1, position);
        const auto s = static_cast<std::size_t>(after - envelope_before_.begin()) - 1;
        const auto first = map.scans.firstPoint(stretches_[s].scans.first);
        const auto end = map.scans.firstPoint(stretches_[s].scans.end);
        const std::uint64_t point = std::min(
            end - 1, first + static_cast<std::uint64_t>(
                                 (position - envelope_before_[s]) / stretches_[s].bound));
        const double weight = density.weight(map.scans, now, map.scans.scanOf(point));
        if (random.uniform() * stretches_[s].bound < weight) picked_.push_back(point);
    }
}

/// Cuts the envelope into kUnits equal strata, looks at p(t) at one random point of each, and keeps
/// those points of the stratum that share its scan. A scan is looked at as often as it holds
/// points, so P(point) stays p(its time), while p(t) is computed a fixed number of times.
void ReferenceDraw::makeUnits(
    const MapView& map, const TimeDensity& density, const Moment& now, Random& random)
{
    units_.clear();
    units_weight_ = 0;
    const double stratum = envelope_before_.back() / static_cast<double>(kUnits);
    std::size_t s = 0;
    for (std::size_t unit = 0; unit < kUnits; ++unit)
    {
        const double begin = stratum * static_cast<double>(unit);
        const double position = begin + stratum * random.uniform();
        while (s + 1 < stretches_.size() && envelope_before_[s + 1] <= position) ++s;

        const auto point_at = [&](double where)
        {
            const auto first = map.scans.firstPoint(stretches_[s].scans.first);
            const auto end = map.scans.firstPoint(stretches_[s].scans.end);
            const double offset = (where - envelope_before_[s]) / stretches_[s].bound;
            return offset <= 0 ? first : std::min(end, first + static_cast<std::uint64_t>(offset));
        };
        const std::uint64_t last_point = map.scans.firstPoint(stretches_[s].scans.end) - 1;
        const std::uint64_t point = std::min(last_point, point_at(position));
        const std::size_t scan = map.scans.scanOf(point);
        const std::uint64_t first = std::max(map.scans.firstPoint(scan), point_at(begin));
        const std::uint64_t end =
            std::min(map.scans.firstPoint(scan + 1), point_at(begin + stratum));
        units_.push_back({std::min(first, point), std::max(end, point + 1), units_weight_});
        units_weight_ += density.weight(map.scans, now, scan) / stretches_[s].bound;
    }
}

/// Systematic draws: points at equal steps of the units' weight, from one random start.
void ReferenceDraw::pickStratified(std::size_t count, Random& random)
{
    if (units_weight_ <= 0) return;
    const double step = units_weight_ / static_cast<double>(count);
    const double start = step * random.uniform();
    std::size_t u = 0;
    for (std::size_t k = 0; k < count; ++k)
    {
        const double position = start + step * static_cast<double>(k);
        while (u + 1 < units_.size() && units_[u + 1].weight_before <= position) ++u;
        const Unit& unit = units_[u];
        const double weight =
            (u + 1 < units_.size() ? units_[u + 1].weight_before : units_weight_) -
            unit.weight_before;
        const double share = weight > 0 ? (position - unit.weight_before) / weight : 0.0;
        const auto length = unit.end_point - unit.first_point;
        picked_.push_back(
            unit.first_point +
            std::min(length - 1, static_cast<std::uint64_t>(share * static_cast<double>(length))));
    }
}

void ReferenceDraw::gather(
    const PointsView& points_map, const std::optional<Box>& gate, Reference& reference) const
{
    for (const std::uint64_t i : picked_)
    {
        __builtin_prefetch(points_map.x + i);
        __builtin_prefetch(points_map.y + i);
    }
    const auto wanted = static_cast<std::size_t>(options_.points);
    for (const std::uint64_t i : picked_)
    {
        if (reference.indices.size() == wanted) return;
        const double x = points_map.x[i], y = points_map.y[i];
        if (gate && !gate->contains(x, y)) continue;
        reference.indices.push_back(i);
        reference.points.add(
            static_cast<float>(x - reference.origin_x), static_cast<float>(y - reference.origin_y));
    }
}
}  // namespace rtob
