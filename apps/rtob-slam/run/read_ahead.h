// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/log_reader.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace rtob
{
/// Reads a log in a thread of its own, some entries ahead, so that unpacking it costs the consumer
/// nothing where there is a second core. Gives out what the reader would, in the same order, its
/// error too.
class ReadAhead : public LogReader
{
 public:
    explicit ReadAhead(std::unique_ptr<LogReader> reader);
    ~ReadAhead() override;

    [[nodiscard]] std::optional<LogEntry> next() override;
    [[nodiscard]] double progress() const override { return progress_; }
    /// Once next() has come to the end.
    [[nodiscard]] LogLosses losses() const override;

 private:
    void readAll();
    /// Waits for room. @return false when nothing more is wanted.
    bool put(LogEntry&& entry);

    std::unique_ptr<LogReader> reader_;
    std::atomic<double> progress_ = 0;

    mutable std::mutex mutex_;  ///< of all below
    std::condition_variable changed_;
    std::deque<LogEntry> entries_;
    LogLosses losses_;
    std::exception_ptr error_;
    bool at_end_ = false;
    bool is_wanted_ = true;

    std::thread thread_;  ///< last: it uses all above
};
}  // namespace rtob
