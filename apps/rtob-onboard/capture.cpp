// SPDX-License-Identifier: BSD-3-Clause
#include "capture.h"

#include <mrpt/system/thread_name.h>
#include <rtob/io/scan_timing.h>

#include <array>
#include <cstdio>

namespace rtob
{
namespace
{
/// Some minutes of a laser: enough for a slow disk, little memory.
constexpr std::size_t kMostWaiting = 20000;
}  // namespace

Capture::Capture(const CaptureOptions& options, std::string folder)
    : options_(options), folder_(std::move(folder))
{
    if (!options_.enabled) return;
    file_ = std::make_shared<CaptureFile>(nextName());
    state_.files = 1;
    writing_ = std::thread([this] { write(); });
    syncing_ = std::thread([this] { sync(); });
}

Capture::~Capture()
{
    finish();
}

std::string Capture::nextName() const
{
    std::array<char, 32> name{};
    std::snprintf(
        name.data(), name.size(), "capture_%03u.rawlog", static_cast<unsigned>(state_.files));
    return folder_ + "/" + name.data();
}

void Capture::add(mrpt::serialization::CSerializable::Ptr object)
{
    if (!options_.enabled) return;
    const std::lock_guard lock(mutex_);
    if (ends_ || !state_.problem.empty() || waiting_.size() >= kMostWaiting)
        ++state_.left_out;
    else
        waiting_.push_back(std::move(object));
}

void Capture::add(const QueuedObservation& item)
{
    if (item.is_dropped) add(dropped_record(*item.observation));
    add(item.observation);
}

void Capture::finish()
{
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    if (!writing_.joinable()) return;
    writing_.join();
    syncing_.join();
    try
    {
        file_->sync();
    }
    catch (const std::exception& error)
    {
        fail(error.what());
    }
}

Capture::State Capture::state() const
{
    const std::lock_guard lock(mutex_);
    return state_;
}

void Capture::write()
{
    mrpt::system::thread_name("capture");
    const std::chrono::duration<double> period(options_.flush_s);
    for (bool ends = false; !ends;)
    {
        Objects objects;
        {
            std::unique_lock lock(mutex_);
            ends = changed_.wait_for(lock, period, [this] { return ends_; });
            objects.swap(waiting_);
        }
        try
        {
            writeObjects(objects);
        }
        catch (const std::exception& error)
        {
            fail(error.what());
            const std::lock_guard lock(mutex_);
            state_.left_out += objects.size() + waiting_.size();
            waiting_.clear();
            return;
        }
    }
}

/// Follows each flush at once: what a loss of power takes is a flush period, and the disk's own
/// time.
void Capture::sync()
{
    mrpt::system::thread_name("capture_sync");
    for (bool ends = false; !ends;)
    {
        std::shared_ptr<CaptureFile> file;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return ends_ || is_to_sync_; });
            ends = ends_;
            is_to_sync_ = false;
            file = file_;
        }
        try
        {
            file->sync();
        }
        catch (const std::exception& error)
        {
            fail(error.what());
            return;
        }
    }
}

/// The first problem is the one to tell.
void Capture::fail(const std::string& problem)
{
    const std::lock_guard lock(mutex_);
    if (state_.problem.empty()) state_.problem = problem;
}

void Capture::writeObjects(const Objects& objects)
{
    for (const auto& object : objects) file_->write(*object);
    file_->flush();
    const bool is_full = static_cast<double>(file_->bytes()) >= 1e6 * options_.rotate_mb;
    if (is_full) file_->sync();
    const std::lock_guard lock(mutex_);
    state_.objects += objects.size();
    state_.bytes = bytes_of_full_files_ + file_->bytes();
    is_to_sync_ = true;
    changed_.notify_all();
    if (!is_full) return;
    bytes_of_full_files_ = state_.bytes;
    file_ = std::make_shared<CaptureFile>(nextName());
    ++state_.files;
}
}  // namespace rtob
