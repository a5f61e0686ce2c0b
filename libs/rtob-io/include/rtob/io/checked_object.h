// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/serialization/CSerializable.h>

#include <cstddef>
#include <cstdint>
#include <string>

/// One MRPT object in a gzip file whose header says what it is, in which format, and the checksum
/// of its bytes. MRPT's programs read it as they read any object: to them the header is a comment.
namespace rtob
{
/// What a file holds.
struct ObjectFormat
{
    std::string kind;  ///< in words, e.g. "rtob map"
    unsigned version = 1;
    std::string origin;  ///< whence such a file comes, as messages say it
};

/// Appears whole or not at all. Throws std::runtime_error naming the file.
void write_checked_object(
    const std::string& file, const ObjectFormat& format,
    const mrpt::serialization::CSerializable& object);

/// Throws std::runtime_error that names the file, what is wrong and what to do, for a file that is
/// missing, of another kind, newer, cut short or damaged. Nothing of such a file is interpreted.
[[nodiscard]] mrpt::serialization::CSerializable::Ptr read_checked_object(
    const std::string& file, const ObjectFormat& format);

/// CRC-32 as gzip and zip have it; takes more bytes at each call.
class Checksum
{
 public:
    void add(const void* bytes, std::size_t count);
    [[nodiscard]] std::uint32_t value() const;

 private:
    std::uint32_t remainder_ = ~std::uint32_t{0};
};

/// Eight hexadecimal digits.
[[nodiscard]] std::string checksum_text(std::uint32_t checksum);
}  // namespace rtob
