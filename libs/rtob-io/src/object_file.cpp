// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CStream.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/io/object_file.h>

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <stdexcept>

#include "lenient_sink.h"

namespace rtob
{
/// MRPT writes objects into this.
class ObjectFile::Stream : public mrpt::io::CStream
{
 public:
    explicit Stream(std::ostream& out)
    {
        // The fastest level: logs and maps are mostly noise, and a better one gains little. Boost
        // writes no time into the header.
        buffer_.push(boost::iostreams::gzip_compressor(boost::iostreams::gzip::best_speed));
        buffer_.push(LenientSink(out));
    }

    void close() { boost::iostreams::close(buffer_); }

    size_t Read(void*, size_t) override { throw std::logic_error("a stream for writing"); }
    size_t Write(const void* bytes, size_t count) override
    {
        position_ += count;
        return static_cast<size_t>(
            buffer_.sputn(static_cast<const char*>(bytes), static_cast<std::streamsize>(count)));
    }
    uint64_t Seek(int64_t, TSeekOrigin) override { throw std::logic_error("written in order"); }
    uint64_t getTotalBytesCount() const override { return position_; }
    uint64_t getPosition() const override { return position_; }

 private:
    boost::iostreams::filtering_ostreambuf buffer_;
    uint64_t position_ = 0;
};

ObjectFile::ObjectFile(const std::string& file)
    : out_(file), stream_(std::make_unique<Stream>(out_.stream()))
{
}

ObjectFile::~ObjectFile() = default;

void ObjectFile::write(const mrpt::serialization::CSerializable& object)
{
    mrpt::serialization::archiveFrom(*stream_) << object;
    out_.check();
}

void ObjectFile::commit()
{
    stream_->close();
    out_.commit();
}
}  // namespace rtob
