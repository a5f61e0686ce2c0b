// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/log_reader.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rtob
{
/// What of a log is wanted, and how its ranges are to be understood.
struct LogChoice
{
    std::vector<std::string> lasers;           ///< labels; empty: all
    std::vector<std::string> poses;            ///< of odometry and robot poses; likewise
    std::optional<float> max_range_m;          ///< of every scan
    std::map<std::string, float> no_return_m;  ///< by laser, for scans without a maximum range
};

/// The chosen part of another log; counts the rest as lost.
class ChosenLog : public LogReader
{
 public:
    /// When `stop` says so, next() throws std::runtime_error.
    ChosenLog(std::unique_ptr<LogReader> log, LogChoice choice, const std::function<bool()>& stop);

    [[nodiscard]] std::optional<LogEntry> next() override;
    [[nodiscard]] double progress() const override { return log_->progress(); }
    [[nodiscard]] LogLosses losses() const override;

 private:
    [[nodiscard]] bool wants(const LogEntry& entry);
    [[nodiscard]] LogEntry limited(const LogEntry& entry) const;

    std::unique_ptr<LogReader> log_;
    LogChoice choice_;
    const std::function<bool()>& stop_;
    LogLosses losses_;
};
}  // namespace rtob
