// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/core/reference_draw.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rtob
{
namespace
{
constexpr std::size_t kUnits = 512;     // strata of time in which p(t) is looked at once
constexpr std::size_t kLooksAhead = 4;  // strata whose scans memory is asked for early
constexpr int kMaxRounds = 4;           // a gate may throw points away: try again this often
constexpr double kMinShare = 0.1;       // of the tries that a gate is expected to let through
constexpr std::size_t kSpare = 16;      // more than the gate's share asks for: saves a last round
constexpr std::size_t kMaxTries = 16;   // a point, independent draws
constexpr std::size_t kPrefetchAhead = 32;  // picks; they may lie anywhere in a large map

inline void prefetch_pick(
    const PointsView& points_map, const std::vector<std::uint64_t>& picked, std::size_t pick)
{
    if (pick >= picked.size()) return;
    __builtin_prefetch(points_map.x + picked[pick]);
    __builtin_prefetch(points_map.y + picked[pick]);
}
}  // namespace

void DrawOptions::validate() const
{
    require(points >= 10, "points", points, ">= 10");
}

ReferenceDraw::ReferenceDraw(const DrawOptions& options) : options_(options)
{
    options_.validate();
    const auto n = static_cast<std::size_t>(options_.points);
    support_.stretches.reserve(4 * TimeDensity::kMaxVisits);
    envelope_before_.reserve(4 * TimeDensity::kMaxVisits + 1);
    looks_.reserve(kUnits);
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

    density.findSupport(map.scans, map.visits, now, support_);
    layOutSupport(map.scans);
    if (support_points_ <= (gate ? kMaxRounds * wanted : wanted))
    {
        takeAll(map, density, now);
        if (gate) dropOutside(*gate, map.points_map);
        if (picked_.size() <= wanted) return gather(map.points_map, reference);
    }
    const bool stratified = options_.mode == DrawMode::Stratified;
    if (stratified) makeUnits(map, density, now, random);
    double tries_per_point = 1;
    for (int round = 0; round < kMaxRounds && reference.indices.size() < wanted; ++round)
    {
        const std::size_t missing = wanted - reference.indices.size();
        const auto tries =
            static_cast<std::size_t>(std::ceil(static_cast<double>(missing) * tries_per_point));
        picked_.clear();
        const std::size_t count = std::min(kMaxRounds * wanted, tries + (round > 0 ? kSpare : 0));
        if (stratified)
            pickStratified(count, random);
        else
            pickIndependent(map, density, now, count, random);
        if (picked_.empty()) return;
        const auto tried = static_cast<double>(picked_.size());
        if (gate) dropOutside(*gate, map.points_map);
        tries_per_point = tried / std::max(kMinShare * tried, static_cast<double>(picked_.size()));
        keepEvenly(missing, random);
        gather(map.points_map, reference);
    }
}

/// Lays the stretches end to end on one axis, each as long as its points x its bound.
void ReferenceDraw::layOutSupport(const ScanTable& scans)
{
    envelope_before_.assign(1, 0.0);
    support_points_ = 0;
    for (const Stretch& s : support_.stretches)
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
    for (const Stretch& s : support_.stretches)
        for (std::size_t scan = s.scans.first; scan < s.scans.end; ++scan)
        {
            if (density.weight(map.scans, now, support_, scan) <= 0) continue;
            for (auto i = map.scans.firstPoint(scan); i < map.scans.firstPoint(scan + 1); ++i)
                picked_.push_back(i);
        }
}

void ReferenceDraw::dropOutside(const Box& gate, const PointsView& points_map)
{
    std::size_t kept = 0;
    for (std::size_t k = 0; k < picked_.size(); ++k)
    {
        prefetch_pick(points_map, picked_, k + kPrefetchAhead);
        const std::uint64_t i = picked_[k];
        if (gate.contains(points_map.x[i], points_map.y[i])) picked_[kept++] = i;
    }
    picked_.resize(kept);
}

/// Thins what is picked to `count`, each with the same chance: a cut at the end would forget the
/// newest, because strata come in order of time.
void ReferenceDraw::keepEvenly(std::size_t count, Random& random)
{
    if (picked_.size() <= count) return;
    const double step = static_cast<double>(picked_.size()) / static_cast<double>(count);
    const double start = step * random.uniform();
    for (std::size_t k = 0; k < count; ++k)
        picked_[k] = picked_[std::min(
            picked_.size() - 1, static_cast<std::size_t>(start + step * static_cast<double>(k)))];
    picked_.resize(count);
}

/// The point at a place of the envelope, which lies in stretch s.
std::uint64_t ReferenceDraw::pointAt(const ScanTable& scans, std::size_t s, double place) const
{
    const Stretch& stretch = support_.stretches[s];
    const double offset = std::max(0.0, (place - envelope_before_[s]) / stretch.bound);
    return std::min(
        scans.firstPoint(stretch.scans.end) - 1,
        scans.firstPoint(stretch.scans.first) + static_cast<std::uint64_t>(offset));
}

void ReferenceDraw::pickIndependent(
    const MapView& map, const TimeDensity& density, const Moment& now, std::size_t count,
    Random& random)
{
    const double total = envelope_before_.back();
    const std::size_t max_tries = kMaxTries * static_cast<std::size_t>(options_.points);
    for (std::size_t tries = 0; tries < max_tries && picked_.size() < count; ++tries)
    {
        const double place = random.uniform() * total;
        const auto after =
            std::upper_bound(envelope_before_.begin() + 1, envelope_before_.end() - 1, place);
        const auto s = static_cast<std::size_t>(after - envelope_before_.begin()) - 1;
        const std::uint64_t point = pointAt(map.scans, s, place);
        const double weight = density.weight(map.scans, now, support_, map.scans.scanOf(point));
        if (random.uniform() * support_.stretches[s].bound < weight) picked_.push_back(point);
    }
}

/// Cuts the envelope into kUnits equal strata, looks at p(t) at one random place of each, and keeps
/// that part of the stratum that lies in the same scan. A scan is looked at as often as it holds
/// points, so P(point) stays p(its time), while p(t) is computed a fixed number of times.
void ReferenceDraw::makeUnits(
    const MapView& map, const TimeDensity& density, const Moment& now, Random& random)
{
    units_.clear();
    units_weight_ = 0;
    if (density.isFlat()) return makeFlatUnits(map.scans);
    const double stratum = envelope_before_.back() / static_cast<double>(kUnits);
    chooseLooks(map.scans, stratum, random);
    // Strata side by side often look at the same scan.
    std::size_t weighed_scan = std::numeric_limits<std::size_t>::max();
    double weight = 0;
    for (std::size_t unit = 0; unit < kUnits; ++unit)
    {
        if (unit + kLooksAhead < kUnits) map.scans.expectAround(looks_[unit + kLooksAhead].scan);
        const Look& look = looks_[unit];
        const Stretch& stretch = support_.stretches[look.stretch];
        const auto to_points = [&](double where)
        {
            return static_cast<double>(map.scans.firstPoint(stretch.scans.first)) +
                   (where - envelope_before_[look.stretch]) / stretch.bound;
        };
        const double begin = stratum * static_cast<double>(unit);
        units_.push_back(
            {std::max(to_points(begin), static_cast<double>(map.scans.firstPoint(look.scan))),
             std::min(
                 to_points(begin + stratum),
                 static_cast<double>(map.scans.firstPoint(look.scan + 1))),
             units_weight_});
        if (look.scan != weighed_scan)
        {
            weight = density.weight(map.scans, now, support_, look.scan);
            weighed_scan = look.scan;
        }
        units_weight_ += weight / stretch.bound;
    }
}

/// In two rounds, so that memory, far apart in a large map, is asked for all places at once.
void ReferenceDraw::chooseLooks(const ScanTable& scans, double stratum, Random& random)
{
    looks_.clear();
    std::size_t s = 0;
    for (std::size_t unit = 0; unit < kUnits; ++unit)
    {
        const double place = stratum * (static_cast<double>(unit) + random.uniform());
        while (s + 1 < support_.stretches.size() && envelope_before_[s + 1] <= place) ++s;
        const std::uint64_t point = pointAt(scans, s, place);
        scans.expectScanOf(point);
        looks_.push_back({s, point, 0});
    }
    for (Look& look : looks_) look.scan = scans.scanOf(look.point);
}

/// One unit a stretch: nothing need be looked at where p(t) is the same everywhere.
void ReferenceDraw::makeFlatUnits(const ScanTable& scans)
{
    for (const Stretch& s : support_.stretches)
    {
        const auto first = static_cast<double>(scans.firstPoint(s.scans.first));
        const auto end = static_cast<double>(scans.firstPoint(s.scans.end));
        units_.push_back({first, end, units_weight_});
        units_weight_ += end - first;
    }
}

/// Systematic draws: points at equal steps of the units' weight, from one random start.
void ReferenceDraw::pickStratified(std::size_t count, Random& random)
{
    if (units_weight_ <= 0) return;
    const double step = units_weight_ / static_cast<double>(count);
    const double start = step * random.uniform();
    for (std::size_t u = 0; u < units_.size(); ++u)
    {
        const Unit& unit = units_[u];
        const bool is_last = u + 1 == units_.size();
        const double weight_end = is_last ? units_weight_ : units_[u + 1].weight_before;
        if (weight_end <= unit.weight_before) continue;
        const double points_per_weight =
            (unit.end - unit.begin) / (weight_end - unit.weight_before);
        const auto last_point = static_cast<std::int64_t>(std::ceil(unit.end)) - 1;
        const double end = is_last ? std::numeric_limits<double>::infinity() : weight_end;
        for (double position = start + step * static_cast<double>(picked_.size());
             position < end && picked_.size() < count;
             position = start + step * static_cast<double>(picked_.size()))
        {
            const double point = unit.begin + (position - unit.weight_before) * points_per_weight;
            const auto i = std::min(last_point, static_cast<std::int64_t>(point));
            picked_.push_back(static_cast<std::uint64_t>(i));
        }
    }
}

/// Adds what is picked to the reference.
void ReferenceDraw::gather(const PointsView& points_map, Reference& reference) const
{
    const std::size_t before = reference.indices.size(), size = before + picked_.size();
    reference.indices.resize(size);
    reference.points.x.resize(size);
    reference.points.y.resize(size);
    for (std::size_t k = 0; k < picked_.size(); ++k)
    {
        prefetch_pick(points_map, picked_, k + kPrefetchAhead);
        const std::uint64_t i = picked_[k];
        reference.indices[before + k] = i;
        reference.points.x[before + k] = static_cast<float>(points_map.x[i] - reference.origin_x);
        reference.points.y[before + k] = static_cast<float>(points_map.y[i] - reference.origin_y);
    }
}
}  // namespace rtob
