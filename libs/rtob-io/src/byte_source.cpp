// SPDX-License-Identifier: BSD-3-Clause
#include "byte_source.h"

#include <algorithm>
#include <boost/iostreams/concepts.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

namespace rtob
{
namespace
{
namespace io = boost::iostreams;

constexpr std::size_t buffer_bytes = 1 << 16;

struct FileCloser
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};

struct PackedFile
{
    std::unique_ptr<std::FILE, FileCloser> handle;
    std::uint64_t size = 0;
    std::uint64_t position = 0;
};

/// The packed bytes as a Boost source that counts what it gave out (Boost's own counter is 32 bit).
class PackedFileDevice : public io::source
{
 public:
    explicit PackedFileDevice(PackedFile& file) : file_(&file) {}

    std::streamsize read(char* out, std::streamsize count)
    {
        const auto got = std::fread(out, 1, static_cast<std::size_t>(count), file_->handle.get());
        if (got == 0 && std::ferror(file_->handle.get()) != 0)
            throw ByteSourceError(
                std::string("reading failed: ") + std::strerror(errno),
                "Check the disk and copy the file again");
        file_->position += got;
        return got == 0 ? -1 : static_cast<std::streamsize>(got);
    }

 private:
    PackedFile* file_;
};

PackedFile open_packed(const std::string& file)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        throw ByteSourceError("this is a folder", "Name a log file inside it");
    PackedFile packed;
    packed.handle.reset(std::fopen(file.c_str(), "rb"));
    if (!packed.handle)
        throw ByteSourceError(
            std::string("cannot be opened: ") + std::strerror(errno),
            "Check the name and the permissions");
    const auto size = std::filesystem::file_size(file, ignored);
    packed.size = ignored ? 0 : size;
    return packed;
}

std::string first_bytes(PackedFile& packed)
{
    char magic[3] = {};
    const auto got = std::fread(magic, 1, sizeof(magic), packed.handle.get());
    if (got == 0) throw ByteSourceError("the file is empty", "Record or copy the log again");
    std::rewind(packed.handle.get());
    return std::string(magic, got);
}
}  // namespace

struct ByteSource::Unpacker
{
    explicit Unpacker(const std::string& file) : name(file) { open(usual_buffer_bytes); }

    void open(std::streamsize unpacked_at_once)
    {
        stream.emplace();  // reset() would go on reading from the old one's buffer
        packed = open_packed(name);
        const std::string magic = first_bytes(packed);
        if (magic.substr(0, 2) == "\x1f\x8b")
            stream->push(io::gzip_decompressor(), unpacked_at_once);
        else if (magic == "BZh")
            stream->push(io::bzip2_decompressor(), unpacked_at_once);
        stream->push(PackedFileDevice(packed));
    }

    /// 0 at the end of the data.
    std::size_t read_some(char* out, std::size_t most)
    {
        try
        {
            return read_unpacked(out, most);
        }
        catch (const ByteSourceError&)
        {
            throw;
        }
        catch (const std::exception&)  // Boost's texts say no more than "iostream error"
        {
            if (is_salvaging)
                throw ByteSourceError(
                    "the packed data is cut short or damaged",
                    "Copy the file again, or unpack what is readable (gzip -dc, bzip2recover)");
        }
        salvage();
        return read_some(out, most);
    }

    std::size_t read_unpacked(char* out, std::size_t most)
    {
        using Traits = std::char_traits<char>;
        if (Traits::eq_int_type(stream->sgetc(), Traits::eof())) return 0;
        const auto count = std::min<std::streamsize>(
            std::max<std::streamsize>(stream->in_avail(), 1), static_cast<std::streamsize>(most));
        const auto got = stream->sgetn(out, count);
        given += got;
        return static_cast<std::size_t>(got);
    }

    /// What is unpacked together with a broken place is lost: so once more from the start, byte by
    /// byte.
    void salvage()
    {
        is_salvaging = true;
        open(1);
        for (std::streamsize i = 0; i < given; ++i) stream->sbumpc();
    }

    static constexpr std::streamsize usual_buffer_bytes = -1;  // Boost's own choice
    std::string name;
    PackedFile packed;
    std::optional<io::filtering_istreambuf> stream;
    std::streamsize given = 0;  ///< unpacked bytes so far
    bool is_salvaging = false;
};

ByteSource::ByteSource(const std::string& file)
    : unpacker_(std::make_unique<Unpacker>(file)), buffer_(buffer_bytes, '\0')
{
}

ByteSource::~ByteSource() = default;

std::string_view ByteSource::peek()
{
    if (begin_ == end_)
    {
        begin_ = end_ = 0;
        end_ = unpacker_->read_some(buffer_.data(), buffer_.size());
    }
    return {buffer_.data() + begin_, end_ - begin_};
}

double ByteSource::progress() const
{
    const auto& packed = unpacker_->packed;
    if (packed.size == 0) return 0;
    return std::min(1.0, static_cast<double>(packed.position) / static_cast<double>(packed.size));
}
}  // namespace rtob
