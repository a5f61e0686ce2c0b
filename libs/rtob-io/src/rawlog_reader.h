// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/serialization/CArchive.h>
#include <rtob/io/log_reader.h>

#include <deque>
#include <memory>
#include <string>

namespace rtob
{
/// MRPT rawlogs: observations one by one, or actions and sensory frames in any order. A frame's
/// observations come one by one, its action's 2D movement before them. Objects of other kinds
/// (comments, settings) are passed over.
class RawlogReader : public LogReader
{
 public:
    explicit RawlogReader(const std::string& file);
    ~RawlogReader() override;

    [[nodiscard]] std::optional<LogEntry> next() override;
    [[nodiscard]] double progress() const override;
    [[nodiscard]] LogLosses losses() const override { return losses_; }

 private:
    class Stream;

    [[nodiscard]] mrpt::serialization::CSerializable::Ptr read_object();
    void queue_entries_of(const mrpt::serialization::CSerializable::Ptr& object);
    [[nodiscard]] LogError entry_error(const std::string& problem, const std::string& fix) const;

    std::string file_;
    std::unique_ptr<Stream> stream_;
    std::deque<LogEntry> waiting_;
    std::size_t objects_read_ = 0;
    LogLosses losses_;
};
}  // namespace rtob
