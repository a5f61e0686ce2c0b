// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/log_reader.h>

namespace rtob
{
/// Writes a log an entry at a time, in the order given. The file appears whole, with commit(), or
/// not at all. Each call throws std::runtime_error, naming the file, when writing fails.
class LogWriter
{
 public:
    LogWriter() = default;
    LogWriter(const LogWriter&) = delete;
    LogWriter& operator=(const LogWriter&) = delete;
    virtual ~LogWriter() = default;

    virtual void write(const LogEntry& entry) = 0;
    virtual void commit() = 0;

    [[nodiscard]] const LogLosses& losses() const { return losses_; }

 protected:
    /// Counts what the format cannot hold.
    void lose(const std::string& what, std::uint64_t times = 1)
    {
        if (times > 0) losses_[what] += times;
    }

 private:
    LogLosses losses_;
};
}  // namespace rtob
