// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/serialization/CSerializable.h>
#include <rtob/io/capture_file.h>

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "observation_queue.h"
#include "onboard_options.h"

namespace rtob
{
/// Writes objects into rawlogs, in a thread of its own: who has something to log never waits for a
/// disk. Nor does the writing: another thread waits until the disk has it, which may take seconds
/// on a busy one. capture_000.rawlog is followed by capture_001.rawlog when it gets large.
class Capture
{
 public:
    struct State
    {
        std::uint64_t objects = 0, bytes = 0, files = 0;
        std::uint64_t left_out = 0;  ///< the disk was too slow, or the capture has failed
        std::string problem;         ///< why it has failed; empty while it has not
    };

    /// Throws std::runtime_error where the first file cannot be made.
    Capture(const CaptureOptions& options, std::string folder);
    /// Writes what is left.
    ~Capture();
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;

    void add(mrpt::serialization::CSerializable::Ptr object);
    /// With its mark before it, where it was dropped.
    void add(const QueuedObservation& item);
    /// Writes what is left and ends; nothing is taken any more.
    void finish();

    [[nodiscard]] State state() const;

 private:
    using Objects = std::vector<mrpt::serialization::CSerializable::Ptr>;

    void write();
    void sync();
    void fail(const std::string& problem);
    void writeObjects(const Objects& objects);
    [[nodiscard]] std::string nextName() const;

    CaptureOptions options_;
    std::string folder_;
    mutable std::mutex mutex_;           ///< guards what follows
    std::shared_ptr<CaptureFile> file_;  ///< written to by the writing thread alone
    std::condition_variable changed_;
    Objects waiting_;
    State state_;
    std::uint64_t bytes_of_full_files_ = 0;
    bool is_to_sync_ = false, ends_ = false;
    std::thread writing_, syncing_;
};
}  // namespace rtob
