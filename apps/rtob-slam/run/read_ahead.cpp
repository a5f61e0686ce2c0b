// SPDX-License-Identifier: BSD-3-Clause
#include "run/read_ahead.h"

#include <utility>

namespace rtob
{
namespace
{
// A few seconds of scans: enough for the unevenness of packed blocks, little memory.
constexpr std::size_t max_entries_ahead = 256;
}  // namespace

ReadAhead::ReadAhead(std::unique_ptr<LogReader> reader)
    : reader_(std::move(reader)), thread_([this] { readAll(); })
{
}

ReadAhead::~ReadAhead()
{
    {
        const std::lock_guard lock(mutex_);
        is_wanted_ = false;
    }
    changed_.notify_all();
    thread_.join();
}

void ReadAhead::readAll()
{
    std::exception_ptr error;
    try
    {
        while (auto entry = reader_->next())
        {
            progress_ = reader_->progress();
            if (!put(std::move(*entry))) break;
        }
    }
    catch (...)
    {
        error = std::current_exception();  // next() throws it, after all entries before it
    }
    {
        const std::lock_guard lock(mutex_);
        error_ = error;
        losses_ = reader_->losses();
        at_end_ = true;
    }
    changed_.notify_all();
}

bool ReadAhead::put(LogEntry&& entry)
{
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return entries_.size() < max_entries_ahead || !is_wanted_; });
        if (!is_wanted_) return false;
        entries_.push_back(std::move(entry));
    }
    changed_.notify_all();
    return true;
}

std::optional<LogEntry> ReadAhead::next()
{
    std::optional<LogEntry> entry;
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !entries_.empty() || at_end_; });
        if (entries_.empty())
        {
            if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
            return std::nullopt;
        }
        entry = std::move(entries_.front());
        entries_.pop_front();
    }
    changed_.notify_all();
    return entry;
}

LogLosses ReadAhead::losses() const
{
    const std::lock_guard lock(mutex_);
    return losses_;
}
}  // namespace rtob
