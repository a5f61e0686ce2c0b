// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fstream>
#include <string>

namespace rtob
{
/// A file that appears whole or not at all: written beside its place, renamed by commit(). Without
/// commit() nothing is left behind. Throws std::runtime_error naming the file.
class AtomicFile
{
 public:
    explicit AtomicFile(std::string file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    [[nodiscard]] std::ostream& stream() { return stream_; }
    /// Throws when what was written so far cannot be, as on a full disk.
    void check() const;
    void commit();

 private:
    std::string file_;
    std::string part_file_;
    std::ofstream stream_;
};

/// A whole file of this text.
void write_text(const std::string& file, const std::string& text);
}  // namespace rtob
