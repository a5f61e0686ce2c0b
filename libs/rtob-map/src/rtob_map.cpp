// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/system/datetime.h>
#include <rtob/core/enum_names.h>
#include <rtob/core/large_pages.h>
#include <rtob/map/conversions.h>
#include <rtob/map/rtob_map.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace rtob
{
namespace
{
constexpr std::size_t kPointBlock = 1 << 18;  // 3 MB: some 1000 scans of the paper's laser
constexpr std::size_t kScanBlock = 1 << 12;

const RtobMapOptions& validated(const RtobMapOptions& options)
{
    options.validate();
    return options;
}
}  // namespace

RtobMap::State::State(const RtobMapOptions& all_options)
    : options(validated(all_options)), density(options.density), random(options.seed)
{
}

RtobMap::RtobMap(const RtobMapOptions& options)
    : state_(options), matching_{ReferenceDraw(options.draw), {}}
{
}

RtobMap::RtobMap(const RtobMap& other)
    : CSimplePointsMap(other), state_(other.state_), matching_(other.matching_)
{
    copyBaseOptionsFrom(other);
}

RtobMap& RtobMap::operator=(const RtobMap& other)
{
    if (this == &other) return *this;
    CSimplePointsMap::operator=(other);
    copyBaseOptionsFrom(other);
    state_ = other.state_;
    matching_ = other.matching_;
    return *this;
}

/// MRPT copies the points of a map, not its options.
void RtobMap::copyBaseOptionsFrom(const mrpt::maps::CPointsMap& other)
{
    insertionOptions = other.insertionOptions;
    likelihoodOptions = other.likelihoodOptions;
    renderOptions = other.renderOptions;
    genericMapParams = other.genericMapParams;
}

void RtobMap::setOptions(const RtobMapOptions& options)
{
    options.validate();
    state_.options = options;
    state_.density = TimeDensity(options.density);
    state_.random = Random(options.seed);
    matching_ = {ReferenceDraw(options.draw), {}};
}

void RtobMap::insertScan(
    double time_s, const Pose2& pose_map_vehicle, const PointsView& points_vehicle)
{
    if (points_vehicle.size == 0) return;
    reserveFor(points_vehicle.size);
    appendScan(time_s, pose_map_vehicle, points_vehicle.size);
    const std::size_t first = m_x.size();
    m_x.resize(first + points_vehicle.size);
    m_y.resize(first + points_vehicle.size);
    m_z.resize(first + points_vehicle.size, 0.0f);
    const double c = std::cos(pose_map_vehicle.yaw), s = std::sin(pose_map_vehicle.yaw);
    for (std::size_t i = 0; i < points_vehicle.size; ++i)
    {
        const double x = points_vehicle.x[i], y = points_vehicle.y[i];
        m_x[first + i] = static_cast<float>(pose_map_vehicle.x + c * x - s * y);
        m_y[first + i] = static_cast<float>(pose_map_vehicle.y + s * x + c * y);
    }
    mark_as_modified();
}

void RtobMap::keepOnly(const std::vector<char>& keep)
{
    (void)view();  // refuses points and scans that do not belong together
    std::size_t kept = 0;
    for (std::size_t scan = 0; scan < scans().size(); ++scan)
    {
        if (keep.at(scan) == 0) continue;
        const auto first = static_cast<std::ptrdiff_t>(scans().firstPoint(scan));
        const auto end = static_cast<std::ptrdiff_t>(scans().firstPoint(scan + 1));
        const auto to = static_cast<std::ptrdiff_t>(kept);
        for (auto* column : {&m_x, &m_y, &m_z})
            std::copy(column->begin() + first, column->begin() + end, column->begin() + to);
        kept += static_cast<std::size_t>(end - first);
    }
    for (auto* column : {&m_x, &m_y, &m_z}) column->resize(kept);
    state_.scans.keepOnly(keep);
    state_.visits.restart();
    for (std::size_t scan = 0; scan < scans().size(); ++scan)
        state_.visits.append(scans().x(scan), scans().y(scan));
    matching_.sample.reset();
    mark_as_modified();
}

void RtobMap::moveScans(std::size_t first, const std::vector<Pose2>& poses_map_vehicle)
{
    (void)view();  // refuses points and scans that do not belong together
    if (first + poses_map_vehicle.size() != scans().size())
        throw std::invalid_argument(
            "RtobMap::moveScans: " + std::to_string(poses_map_vehicle.size()) +
            " poses for the scans from " + std::to_string(first) + " to the last of " +
            std::to_string(scans().size()));
    for (std::size_t k = 0; k < poses_map_vehicle.size(); ++k)
    {
        const std::size_t scan = first + k;
        const Pose2& now = poses_map_vehicle[k];
        const Pose2 motion_map = compose(now, inverse(scans().pose(scan)));
        const double c = std::cos(motion_map.yaw), s = std::sin(motion_map.yaw);
        for (std::size_t i = scans().firstPoint(scan); i < scans().firstPoint(scan + 1); ++i)
        {
            const double x = m_x[i], y = m_y[i];
            m_x[i] = static_cast<float>(motion_map.x + c * x - s * y);
            m_y[i] = static_cast<float>(motion_map.y + s * x + c * y);
        }
        state_.scans.move(scan, now);
        state_.visits.move(scan, now.x, now.y);
    }
    matching_.sample.reset();
    mark_as_modified();
}

void RtobMap::reserveOnce(std::size_t scans, std::size_t points)
{
    reserve(points);
    for (const auto* column : {&m_x, &m_y})
        prefer_large_pages(column->data(), column->capacity() * sizeof(float));
    state_.scans_reserved = std::max(scans, state_.scans_reserved);
    state_.scans.reserve(state_.scans_reserved, points);
    state_.visits.reserve(state_.scans_reserved);
}

void RtobMap::reserveFor(std::size_t more_points)
{
    const std::size_t points = size() + more_points;
    if (points <= m_x.capacity() && scans().size() < state_.scans_reserved) return;
    const std::size_t points_wanted =
        points <= m_x.capacity() ? m_x.capacity() : std::max({points, 2 * size(), kPointBlock});
    const bool needs_scans = scans().size() >= state_.scans_reserved;
    reserveOnce(needs_scans ? std::max(2 * scans().size(), kScanBlock) : 0, points_wanted);
}

void RtobMap::appendScan(double time_s, const Pose2& pose_map_vehicle, std::size_t point_count)
{
    state_.scans.append(time_s, pose_map_vehicle, static_cast<std::uint32_t>(point_count));
    state_.visits.append(pose_map_vehicle.x, pose_map_vehicle.y);
    matching_.sample.reset();
}

void RtobMap::draw(const Pose2& pose_map_vehicle, Reference& reference)
{
    draw(pose_map_vehicle, std::nullopt, 0, reference);
}

void RtobMap::draw(
    const Pose2& pose_map_vehicle, const std::optional<Box>& gate, std::size_t scans_begin,
    Reference& reference)
{
    Moment moment = momentAt(pose_map_vehicle);
    moment.scans_begin = scans_begin;
    std::optional<Box> within = gateAround(pose_map_vehicle);
    if (gate) within = within ? within->common(*gate) : *gate;
    matching_.draw.draw(view(), state_.density, moment, within, state_.random, reference);
}

std::optional<Box> RtobMap::gateAround(const Pose2& pose_map_vehicle) const
{
    const double half_width_m = state_.options.density.gate_m;
    if (half_width_m <= 0) return std::nullopt;
    return Box::around(pose_map_vehicle.x, pose_map_vehicle.y, half_width_m);
}

Moment RtobMap::momentAt(const Pose2& pose_map_vehicle) const
{
    return {clock().now(), pose_map_vehicle.x, pose_map_vehicle.y};
}

MapView RtobMap::view() const
{
    if (size() != state_.scans.pointCount())
        throw std::logic_error(
            "RtobMap holds " + std::to_string(size()) + " points, its scans " +
            std::to_string(state_.scans.pointCount()) +
            ": points were added or removed past insertScan() and insertObservation(); insert "
            "observations only, or clear() the map");
    return {points(), state_.scans, state_.visits};
}

std::size_t RtobMap::bytesInUse() const
{
    return size() * 3 * sizeof(float) + state_.scans.bytes() + state_.visits.bytes();
}

void RtobMap::internal_clear()
{
    CSimplePointsMap::internal_clear();
    const RtobMapOptions options = state_.options;
    state_ = State(options);
    matching_.sample.reset();
}

bool RtobMap::internal_insertObservation(
    const mrpt::obs::CObservation& observation,
    const std::optional<const mrpt::poses::CPose3D>& pose_map_vehicle)
{
    const std::size_t first = size();
    // Fusing moves and removes points, which would tear them from their scans.
    insertionOptions.fuseWithExisting = false;
    reserveFor(0);
    if (!CSimplePointsMap::internal_insertObservation(observation, pose_map_vehicle)) return false;
    dropPointsThatAreNoNumbers(first);
    if (size() == first) return false;
    const Pose2 pose =
        pose_map_vehicle ? to_pose2(mrpt::poses::CPose2D(*pose_map_vehicle)) : Pose2{};
    appendScan(tick(stamp_of(observation)), pose, size() - first);
    return true;
}

/// Logs hold beams that are flagged valid and yet NaN or infinite.
void RtobMap::dropPointsThatAreNoNumbers(std::size_t first)
{
    std::size_t kept = first;
    for (std::size_t i = first; i < size(); ++i)
    {
        if (!std::isfinite(m_x[i]) || !std::isfinite(m_y[i]) || !std::isfinite(m_z[i])) continue;
        setPointFast(kept++, m_x[i], m_y[i], m_z[i]);
    }
    if (kept != size()) resize(kept);
}

std::string RtobMap::asString() const
{
    std::ostringstream text;
    text << "RTOB map: " << size() << " points of " << scans().size() << " scans over "
         << (scans().empty() ? 0.0 : scans().time(scans().size() - 1) - scans().time(0))
         << " s, density " << name_of(options().density.density);
    return text.str();
}
}  // namespace rtob
