// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/io/log_reader.h>

#include <mrpt/io/CMemoryStream.h>
#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "temporary_file.h"

namespace rtob::test
{
template <class Compressor>
std::string packed_by(Compressor compressor, const std::string& bytes)
{
    std::istringstream in(bytes);
    boost::iostreams::filtering_istreambuf stream;
    stream.push(compressor);
    stream.push(in);
    std::ostringstream out;
    boost::iostreams::copy(stream, out);
    return out.str();
}
inline std::string gzip(const std::string& bytes)
{
    return packed_by(boost::iostreams::gzip_compressor(), bytes);
}
inline std::string bzip2(const std::string& bytes)
{
    return packed_by(boost::iostreams::bzip2_compressor(), bytes);
}

/// The bytes of an unpacked rawlog with these objects.
inline std::string rawlog_bytes(const std::vector<mrpt::serialization::CSerializable::Ptr>& objects)
{
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    for (const auto& object : objects) archive << *object;
    return {
        static_cast<const char*>(stream.getRawBufferData()),
        static_cast<std::size_t>(stream.getTotalBytesCount())};
}

/// All that a log gives, and the message of the error that ended it; empty after a clean end.
struct ReadLog
{
    std::vector<LogEntry> entries;
    std::string error;

    template <class Observation>
    std::vector<typename Observation::Ptr> all() const
    {
        std::vector<typename Observation::Ptr> found;
        for (const auto& entry : entries)
            if (auto match = std::dynamic_pointer_cast<Observation>(entry.observation))
                found.push_back(match);
        return found;
    }
    auto scans() const { return all<mrpt::obs::CObservation2DRangeScan>(); }
    auto odometry() const { return all<mrpt::obs::CObservationOdometry>(); }
};

inline ReadLog read_log(const std::string& file)
{
    ReadLog log;
    try
    {
        const auto reader = open_log(file);
        while (auto entry = reader->next()) log.entries.push_back(std::move(*entry));
    }
    catch (const LogError& error)
    {
        log.error = error.what();
    }
    return log;
}

inline ReadLog read_text_log(const std::string& text)
{
    const TemporaryFile file(".log", text);
    return read_log(file.path());
}

inline double beam_angle_vehicle(const mrpt::obs::CObservation2DRangeScan& scan, std::size_t beam)
{
    return scan.sensorPose.yaw() + scan.getScanAngle(beam);
}

/// The stamp in units of 100 ns since 1970.
inline std::int64_t unix_100ns(const mrpt::obs::CObservation& observation)
{
    constexpr std::int64_t since_1601 = 116'444'736'000'000'000;
    return observation.timestamp.time_since_epoch().count() - since_1601;
}
}  // namespace rtob::test
