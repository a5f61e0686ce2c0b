// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rtob
{
/// The bytes could not be had; the reader on top adds the place and makes it a LogError.
class ByteSourceError : public std::runtime_error
{
 public:
    ByteSourceError(const std::string& problem, std::string fix)
        : std::runtime_error(problem), fix_(std::move(fix))
    {
    }
    [[nodiscard]] const std::string& fix() const { return fix_; }

 private:
    std::string fix_;
};

/// The bytes of a file, unpacked when its first bytes say gzip or bzip2.
class ByteSource
{
 public:
    /// Throws ByteSourceError when the file cannot be opened or is empty.
    explicit ByteSource(const std::string& file);
    ~ByteSource();
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;

    /// Unread bytes, at least one unless the data ended cleanly. Valid until the next call.
    [[nodiscard]] std::string_view peek();
    void consume(std::size_t bytes) { begin_ += bytes; }

    /// Share of the (packed) file that was read, 0 to 1.
    [[nodiscard]] double progress() const;

 private:
    struct Unpacker;
    std::unique_ptr<Unpacker> unpacker_;
    std::string buffer_;
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
};
}  // namespace rtob
