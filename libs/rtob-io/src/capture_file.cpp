// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <mrpt/io/CStream.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/io/capture_file.h>
#include <unistd.h>

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace rtob
{
/// MRPT writes objects into this.
class CaptureFile::Buffer : public mrpt::io::CStream
{
 public:
    [[nodiscard]] bool isEmpty() const { return bytes_.empty(); }
    [[nodiscard]] std::string takePacked()
    {
        std::string packed;
        boost::iostreams::filtering_ostream out;
        out.push(boost::iostreams::gzip_compressor(boost::iostreams::gzip::best_speed));
        out.push(boost::iostreams::back_inserter(packed));
        out.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
        boost::iostreams::close(out);
        bytes_.clear();
        return packed;
    }

    size_t Read(void*, size_t) override { throw std::logic_error("a buffer for writing"); }
    size_t Write(const void* bytes, size_t count) override
    {
        bytes_.append(static_cast<const char*>(bytes), count);
        return count;
    }
    uint64_t Seek(int64_t, TSeekOrigin) override { throw std::logic_error("written in order"); }
    uint64_t getTotalBytesCount() const override { return bytes_.size(); }
    uint64_t getPosition() const override { return bytes_.size(); }

 private:
    std::string bytes_;
};

CaptureFile::CaptureFile(std::string file)
    : file_(std::move(file)), buffer_(std::make_unique<Buffer>())
{
    descriptor_ = open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
    if (descriptor_ < 0)
        throw std::runtime_error("capture " + file_ + " cannot be made: " + std::strerror(errno));
}

CaptureFile::~CaptureFile()
{
    close(descriptor_);
}

void CaptureFile::write(const mrpt::serialization::CSerializable& object)
{
    mrpt::serialization::archiveFrom(*buffer_) << object;
}

void CaptureFile::flush()
{
    if (buffer_->isEmpty()) return;
    const std::string packed = buffer_->takePacked();
    std::size_t written = 0;
    while (written < packed.size())
    {
        const auto count = ::write(descriptor_, packed.data() + written, packed.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0)
        {
            const std::string reason = std::strerror(errno);
            // Half a member would make the readers stumble.
            if (ftruncate(descriptor_, static_cast<off_t>(bytes_)) != 0) bytes_ += written;
            throw std::runtime_error("capture " + file_ + " cannot be written: " + reason);
        }
        written += static_cast<std::size_t>(count);
    }
    bytes_ += written;
}

void CaptureFile::sync() const
{
    if (fdatasync(descriptor_) != 0 && errno != EINVAL)
        throw std::runtime_error(
            "capture " + file_ + " cannot be brought to the disk: " + std::strerror(errno));
}
}  // namespace rtob
