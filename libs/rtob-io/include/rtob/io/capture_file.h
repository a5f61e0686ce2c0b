// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mrpt/serialization/CSerializable.h>

#include <cstdint>
#include <memory>
#include <string>

namespace rtob
{
/// An MRPT rawlog that is whole at any moment: what was flushed stays readable whatever happens to
/// the program or to its power. Each flush() appends a gzip file of its own; MRPT reads such a
/// chain as one, and so are captures put together: cat a.rawlog b.rawlog > both.rawlog.
class CaptureFile
{
 public:
    /// Throws std::runtime_error where the file is there already or cannot be made.
    explicit CaptureFile(std::string file);
    ~CaptureFile();
    CaptureFile(const CaptureFile&) = delete;
    CaptureFile& operator=(const CaptureFile&) = delete;

    /// Keeps the object for the next flush.
    void write(const mrpt::serialization::CSerializable& object);
    /// Hands what was written to the system: it survives this program. Throws std::runtime_error
    /// where that fails, as on a full disk: the file then ends with the flush before.
    void flush();
    /// Waits until what was flushed is on the disk: it survives the power. Any thread may call it,
    /// beside flush(). Throws std::runtime_error.
    void sync() const;

    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    [[nodiscard]] const std::string& name() const { return file_; }

 private:
    class Buffer;

    std::string file_;
    std::unique_ptr<Buffer> buffer_;
    int descriptor_ = -1;
    std::uint64_t bytes_ = 0;  ///< flushed
};
}  // namespace rtob
