// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/stl_serialization.h>
#include <rtob/map/options_io.h>
#include <rtob/map/rtob_map.h>

#include <sstream>
#include <stdexcept>

using namespace rtob;  // IMPLEMENTS_SERIALIZABLE wants the bare class name

IMPLEMENTS_SERIALIZABLE(RtobMap, mrpt::maps::CSimplePointsMap, rtob)

namespace rtob
{
namespace
{
constexpr std::uint8_t kVersion = 0;

/// "key = value" lines: a stored map stays readable when options come or change their order.
std::string options_as_text(const RtobMapOptions& options)
{
    std::ostringstream text;
    RtobMapOptions::fields(
        options, [&](const char* key, const auto& value, const char*)
        { text << key << " = " << option_text(value) << "\n"; });
    return text.str();
}

RtobMapOptions options_from_text(const std::string& text)
{
    RtobMapOptions options;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
        const auto equals = line.find(" = ");
        if (equals == std::string::npos)
            throw std::runtime_error("stored RtobMap: option '" + line + "' is no key = value");
        set_option(options, line.substr(0, equals), line.substr(equals + 3));
    }
    options.validate();
    return options;
}

void write_clock(mrpt::serialization::CArchive& out, const MapClock::State& clock)
{
    out << clock.now_s << clock.last_stamp_s << clock.started << clock.anomalies.steps_back
        << clock.anomalies.repeats << clock.anomalies.jumps << clock.anomalies.invalid;
}

MapClock::State read_clock(mrpt::serialization::CArchive& in)
{
    MapClock::State clock;
    in >> clock.now_s >> clock.last_stamp_s >> clock.started >> clock.anomalies.steps_back >>
        clock.anomalies.repeats >> clock.anomalies.jumps >> clock.anomalies.invalid;
    return clock;
}
}  // namespace

std::uint8_t RtobMap::serializeGetVersion() const
{
    return kVersion;
}

void RtobMap::serializeTo(mrpt::serialization::CArchive& out) const
{
    (void)view();  // refuses points and scans that do not belong together
    // The base as an object of its own: the file does not depend on MRPT's version of it.
    mrpt::maps::CSimplePointsMap base(static_cast<const mrpt::maps::CPointsMap&>(*this));
    base.insertionOptions = insertionOptions;
    base.likelihoodOptions = likelihoodOptions;
    base.renderOptions = renderOptions;
    base.genericMapParams = genericMapParams;
    out << base << options_as_text(options());
    write_clock(out, clock().state());

    out << static_cast<std::uint64_t>(scans().size());
    for (std::size_t k = 0; k < scans().size(); ++k)
    {
        const Pose2 pose = scans().pose(k);
        out << scans().time(k) << pose.x << pose.y << pose.yaw
            << static_cast<std::uint32_t>(scans().firstPoint(k + 1) - scans().firstPoint(k));
    }
}

void RtobMap::serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version)
{
    if (version > kVersion)
        throw std::runtime_error(
            "stored RtobMap has format " + std::to_string(version) + ", this program reads up to " +
            std::to_string(kVersion) + ": read it with a newer version of rtob");
    mrpt::maps::CSimplePointsMap base;
    std::string options_text;
    in >> base >> options_text;
    setOptions(options_from_text(options_text));
    const MapClock::State clock = read_clock(in);
    internal_clear();
    CSimplePointsMap::operator=(base);
    copyBaseOptionsFrom(base);
    readScans(in);
    state_.clock.restore(clock);
    if (scans().pointCount() == size()) return;
    const std::string message = "stored RtobMap is damaged: " + std::to_string(size()) +
                                " points, but its scans have " +
                                std::to_string(scans().pointCount());
    internal_clear();
    throw std::runtime_error(message);
}

void RtobMap::readScans(mrpt::serialization::CArchive& in)
{
    std::uint64_t count = 0;
    in >> count;
    for (std::uint64_t k = 0; k < count; ++k)
    {
        double time_s = 0;
        Pose2 pose;
        std::uint32_t points = 0;
        in >> time_s >> pose.x >> pose.y >> pose.yaw >> points;
        appendScan(time_s, pose, points);
    }
}
}  // namespace rtob
