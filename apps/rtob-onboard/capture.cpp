// SPDX-License-Identifier: BSD-3-Clause
#include "capture.h"

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
    file_ = std::make_unique<CaptureFile>(nextName());
    state_.files = 1;
    thread_ = std::thread([this] { write(); });
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
    ends_early_.notify_all();
    if (thread_.joinable()) thread_.join();
}

Capture::State Capture::state() const
{
    const std::lock_guard lock(mutex_);
    return state_;
}

void Capture::write()
{
    const std::chrono::duration<double> period(options_.flush_s);
    for (bool ends = false; !ends;)
    {
        Objects objects;
        {
            std::unique_lock lock(mutex_);
            ends = ends_early_.wait_for(lock, period, [this] { return ends_; });
            objects.swap(waiting_);
        }
        try
        {
            writeObjects(objects);
        }
        catch (const std::exception& error)
        {
            const std::lock_guard lock(mutex_);
            state_.left_out += objects.size() + waiting_.size();
            waiting_.clear();
            state_.problem = error.what();
            return;
        }
    }
}

void Capture::writeObjects(const Objects& objects)
{
    for (const auto& object : objects) file_->write(*object);
    file_->flush();
    const std::lock_guard lock(mutex_);
    state_.objects += objects.size();
    state_.bytes = bytes_of_full_files_ + file_->bytes();
    if (static_cast<double>(file_->bytes()) < 1e6 * options_.rotate_mb) return;
    bytes_of_full_files_ = state_.bytes;
    file_ = std::make_unique<CaptureFile>(nextName());
    ++state_.files;
}
}  // namespace rtob
