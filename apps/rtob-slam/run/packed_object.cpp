// SPDX-License-Identifier: BSD-3-Clause
#include "run/packed_object.h"

#include <mrpt/io/CStream.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/io/atomic_file.h>

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <stdexcept>

namespace rtob
{
namespace
{
/// MRPT writes objects into this.
class PackedStream : public mrpt::io::CStream
{
 public:
    explicit PackedStream(std::ostream& out)
    {
        // The fastest level: a map is mostly noise, and a better one gains little. Boost writes no
        // time into the header.
        buffer_.push(boost::iostreams::gzip_compressor(boost::iostreams::gzip::best_speed));
        buffer_.push(out);
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
}  // namespace

void write_packed_object(const std::string& file, const mrpt::serialization::CSerializable& object)
{
    AtomicFile out(file);
    PackedStream stream(out.stream());
    mrpt::serialization::archiveFrom(stream) << object;
    stream.close();
    out.commit();
}
}  // namespace rtob
