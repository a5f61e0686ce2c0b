// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/atomic_file.h>

#include <memory>
#include <ostream>
#include <string>

namespace rtob
{
/// A text file, packed as its name says (.gz, .bz2); appears whole or not at all. Throws
/// std::runtime_error naming the file.
class TextFile
{
 public:
    explicit TextFile(const std::string& file);
    ~TextFile();

    [[nodiscard]] std::ostream& stream() { return *text_; }
    /// Throws when what was written so far cannot be, as on a full disk.
    void check() const { out_.check(); }
    void commit();

 private:
    AtomicFile out_;
    std::unique_ptr<std::ostream> text_;
};
}  // namespace rtob
