// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace rtob
{
/// A log that cannot be read, or not to its end: what() names the file, the place and what to do.
class LogError : public std::runtime_error
{
 public:
    LogError(
        const std::string& file, const std::string& place, const std::string& problem,
        const std::string& fix);

    [[nodiscard]] const std::string& file() const { return file_; }
    /// "line 12", "entry 7"; empty where the file as a whole is meant
    [[nodiscard]] const std::string& place() const { return place_; }

 private:
    std::string file_;
    std::string place_;
};

/// One step of a log; exactly one of the two is set.
struct LogEntry
{
    mrpt::obs::CObservation::Ptr observation;
    mrpt::obs::CActionRobotMovement2D::Ptr motion;  ///< odometry since the entry's last motion
};

/// What a reader did not give out or a writer could not hold, in words, and how often.
using LogLosses = std::map<std::string, std::uint64_t>;

/// Reads a log in file order, an entry at a time: a log may be larger than memory.
class LogReader
{
 public:
    LogReader() = default;
    LogReader(const LogReader&) = delete;
    LogReader& operator=(const LogReader&) = delete;
    virtual ~LogReader() = default;

    /// The next entry, or nothing at a clean end. Throws LogError where the log is damaged or cut:
    /// after every entry before that place was given out. The reader is spent then.
    [[nodiscard]] virtual std::optional<LogEntry> next() = 0;

    /// How much of the file was read, 0 to 1.
    [[nodiscard]] virtual double progress() const = 0;

    /// What of the log was passed over so far.
    [[nodiscard]] virtual LogLosses losses() const { return {}; }
};

/// Opens an MRPT rawlog (either format) or a CARMEN text log, plain or packed by gzip or bzip2; the
/// content decides, not the name. Throws LogError for a missing, empty or foreign file.
[[nodiscard]] std::unique_ptr<LogReader> open_log(const std::string& file);
}  // namespace rtob
