// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_reader.h"

#include <mrpt/io/CStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <cstring>

#include "byte_source.h"

namespace rtob
{
/// MRPT reads objects from this. It remembers why the bytes ran out: MRPT's archive turns every
/// exception into a text of its own.
class RawlogReader::Stream : public mrpt::io::CStream
{
 public:
    explicit Stream(const std::string& file) : bytes_(file) {}

    [[nodiscard]] bool at_clean_end() { return bytes_.peek().empty(); }
    [[nodiscard]] double progress() const { return bytes_.progress(); }
    [[nodiscard]] const std::optional<ByteSourceError>& failure() const { return failure_; }

    size_t Read(void* out, size_t count) override
    {
        try
        {
            read_all(static_cast<char*>(out), count);
        }
        catch (const ByteSourceError& error)
        {
            failure_ = error;
            throw;
        }
        return count;
    }
    size_t Write(const void*, size_t) override { THROW_EXCEPTION("a log is only read"); }
    uint64_t Seek(int64_t, TSeekOrigin) override { THROW_EXCEPTION("a log is read in order"); }
    uint64_t getTotalBytesCount() const override { return 0; }
    uint64_t getPosition() const override { return position_; }

 private:
    void read_all(char* out, size_t count)
    {
        position_ += count;
        while (count > 0)
        {
            const auto chunk = bytes_.peek();
            if (chunk.empty())
                throw ByteSourceError(
                    "the log is truncated in the middle of this entry",
                    "Copy the log again, or use what comes before (rawlog-edit --cut)");
            const auto part = std::min(count, chunk.size());
            std::memcpy(out, chunk.data(), part);
            bytes_.consume(part);
            out += part;
            count -= part;
        }
    }

    ByteSource bytes_;
    uint64_t position_ = 0;
    std::optional<ByteSourceError> failure_;
};

namespace
{
/// MRPT's texts carry source files and call stacks; the class of an unknown object is what helps.
std::string unknown_class_in(const std::string& mrpt_text)
{
    const std::string before = "Stored object has class '";
    const auto begin = mrpt_text.find(before);
    if (begin == std::string::npos) return {};
    const auto end = mrpt_text.find('\'', begin + before.size());
    return mrpt_text.substr(begin + before.size(), end - begin - before.size());
}
}  // namespace

RawlogReader::RawlogReader(const std::string& file)
    : file_(file), stream_(std::make_unique<Stream>(file))
{
}

RawlogReader::~RawlogReader() = default;

double RawlogReader::progress() const
{
    return stream_->progress();
}

std::optional<LogEntry> RawlogReader::next()
{
    while (waiting_.empty())
    {
        const auto object = read_object();
        if (!object) return std::nullopt;
        queue_entries_of(object);
    }
    LogEntry entry = std::move(waiting_.front());
    waiting_.pop_front();
    return entry;
}

mrpt::serialization::CSerializable::Ptr RawlogReader::read_object()
{
    ++objects_read_;
    try
    {
        if (stream_->at_clean_end()) return nullptr;
        return mrpt::serialization::archiveFrom(*stream_).ReadObject();
    }
    catch (const std::exception& error)
    {
        if (const auto* no_bytes = dynamic_cast<const ByteSourceError*>(&error))
            throw entry_error(no_bytes->what(), no_bytes->fix());
        if (const auto& failure = stream_->failure())
            throw entry_error(failure->what(), failure->fix());
        const auto unknown_class = unknown_class_in(error.what());
        if (!unknown_class.empty())
            throw entry_error(
                "unknown class '" + unknown_class + "'",
                "If a plug-in defines it, load that; otherwise the log is damaged here");
        throw entry_error(
            "this is not a whole MRPT object: the log is damaged here",
            "Copy the log again, or use what comes before (rawlog-edit --cut)");
    }
}

void RawlogReader::queue_entries_of(const mrpt::serialization::CSerializable::Ptr& object)
{
    using namespace mrpt::obs;
    if (const auto frame = std::dynamic_pointer_cast<CSensoryFrame>(object))
    {
        for (const auto& observation : *frame) waiting_.push_back({observation, nullptr});
    }
    else if (const auto actions = std::dynamic_pointer_cast<CActionCollection>(object))
    {
        if (auto motion = actions->getBestMovementEstimation())
            waiting_.push_back({nullptr, std::move(motion)});
        else if (actions->size() > 0)
            ++losses_["actions without a movement in the plane"];
    }
    else if (const auto observation = std::dynamic_pointer_cast<CObservation>(object))
    {
        if (std::dynamic_pointer_cast<CObservationComment>(object))
            ++losses_["comments"];
        else
            waiting_.push_back({observation, nullptr});
    }
    else
        ++losses_[std::string("objects of class ") + object->GetRuntimeClass()->className];
}

LogError RawlogReader::entry_error(const std::string& problem, const std::string& fix) const
{
    return {file_, "entry " + std::to_string(objects_read_), problem, fix};
}
}  // namespace rtob
