// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <rtob/io/atomic_file.h>
#include <rtob/io/checked_object.h>

#include <boost/crc.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "lenient_sink.h"

namespace rtob
{
namespace
{
namespace io = boost::iostreams;

constexpr const char* kHeaderPattern = ", format %u, crc32 %8x, %llu bytes";
constexpr std::size_t kGzipFixed_bytes = 10;  // before the comment, where only that follows
constexpr unsigned char kGzipCommentOnly = 0x10;

struct Header
{
    unsigned version = 0;
    std::uint32_t checksum = 0;
    unsigned long long bytes = 0;
};

std::uint32_t checksum_of(const void* bytes, std::size_t count)
{
    Checksum checksum;
    checksum.add(bytes, count);
    return checksum.value();
}

std::string header_text(const std::string& kind, const Header& header)
{
    char text[100];
    std::snprintf(text, sizeof text, kHeaderPattern, header.version, header.checksum, header.bytes);
    return kind + text;
}

[[noreturn]] void refuse(
    const std::string& file, const std::string& problem, const std::string& fix)
{
    throw std::runtime_error(file + ": " + problem + ". " + fix + ".");
}

[[noreturn]] void refuse_damaged(const std::string& file, const ObjectFormat& format)
{
    refuse(
        file, "this " + format.kind + " is cut short or damaged",
        "Copy it again from where it is whole, or make it anew: it is " + format.origin);
}

[[noreturn]] void refuse_unreadable(const std::string& file, int error)
{
    refuse(
        file, "cannot be read: " + std::generic_category().message(error),
        "Check the name and the permissions");
}

std::string packed_bytes(const std::string& file)
{
    // A folder can be opened, and its first byte throws without naming it.
    if (std::filesystem::is_directory(file)) refuse_unreadable(file, EISDIR);
    std::ifstream in(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in.is_open() || in.bad()) refuse_unreadable(file, errno);
    return bytes;
}

/// The gzip file's comment; empty where there is none.
std::string comment_of(const std::string& packed)
{
    const bool has_comment = packed.size() > kGzipFixed_bytes &&
                             packed.compare(0, 3, "\x1f\x8b\x08") == 0 &&
                             static_cast<unsigned char>(packed[3]) == kGzipCommentOnly;
    if (!has_comment) return {};
    const auto end = packed.find('\0', kGzipFixed_bytes);
    return end == std::string::npos ? std::string()
                                    : packed.substr(kGzipFixed_bytes, end - kGzipFixed_bytes);
}

Header header_of(const std::string& packed, const std::string& file, const ObjectFormat& format)
{
    const std::string comment = comment_of(packed);
    if (comment.rfind(format.kind + ",", 0) != 0)
        refuse(file, "is no " + format.kind, "Name " + format.origin);
    Header header;
    const int fields = std::sscanf(
        comment.c_str() + format.kind.size(), kHeaderPattern, &header.version, &header.checksum,
        &header.bytes);
    if (fields >= 1 && header.version > format.version)
        refuse(
            file,
            "is in format " + std::to_string(header.version) + ", this program reads up to " +
                std::to_string(format.version),
            "Read it with the newer version of rtob that wrote it");
    if (header_text(format.kind, header) != comment) refuse_damaged(file, format);
    return header;
}

std::string unpacked(const std::string& packed, const std::string& file, const ObjectFormat& format)
{
    try
    {
        io::filtering_istreambuf stream;
        stream.push(io::gzip_decompressor());
        stream.push(io::array_source(packed.data(), packed.size()));
        return {std::istreambuf_iterator<char>(&stream), {}};
    }
    catch (const std::exception&)  // Boost's texts say no more than "gzip error"
    {
        refuse_damaged(file, format);
    }
}
}  // namespace

void Checksum::add(const void* bytes, std::size_t count)
{
    boost::crc_32_type crc(remainder_);
    crc.process_bytes(bytes, count);
    remainder_ = crc.get_interim_remainder();
}

std::uint32_t Checksum::value() const
{
    return boost::crc_32_type(remainder_).checksum();
}

std::string checksum_text(std::uint32_t checksum)
{
    char text[9];
    std::snprintf(text, sizeof text, "%08x", checksum);
    return text;
}

void write_checked_object(
    const std::string& file, const ObjectFormat& format,
    const mrpt::serialization::CSerializable& object)
{
    mrpt::io::CMemoryStream bytes;
    bytes.setAllocBlockSize(1 << 20);
    mrpt::serialization::archiveFrom(bytes) << object;
    const auto* const data = static_cast<const char*>(bytes.getRawBufferData());
    const auto count = static_cast<std::size_t>(bytes.getTotalBytesCount());

    AtomicFile out(file);
    io::gzip_params parameters(io::gzip::best_speed);  // a map is mostly noise
    parameters.comment =
        header_text(format.kind, {format.version, checksum_of(data, count), count});
    io::filtering_ostreambuf packer;
    packer.push(io::gzip_compressor(parameters));
    packer.push(LenientSink(out.stream()));
    packer.sputn(data, static_cast<std::streamsize>(count));
    io::close(packer);
    out.commit();
}

mrpt::serialization::CSerializable::Ptr read_checked_object(
    const std::string& file, const ObjectFormat& format)
{
    const std::string packed = packed_bytes(file);
    const Header header = header_of(packed, file, format);
    const std::string bytes = unpacked(packed, file, format);
    if (bytes.size() != header.bytes || checksum_of(bytes.data(), bytes.size()) != header.checksum)
        refuse_damaged(file, format);
    mrpt::io::CMemoryStream stream;
    stream.assignMemoryNotOwn(bytes.data(), bytes.size());
    try
    {
        return mrpt::serialization::archiveFrom(stream).ReadObject();
    }
    catch (const std::exception& error)  // whole, yet of another version of MRPT or of rtob
    {
        refuse(
            file, std::string("cannot be taken in: ") + error.what(),
            "Read it with the version of rtob that wrote it");
    }
}
}  // namespace rtob
