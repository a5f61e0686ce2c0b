// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "byte_source.h"

namespace rtob
{
/// The lines of a packed or plain text file, with their numbers.
class LineSource
{
 public:
    explicit LineSource(const std::string& file) : bytes_(file) {}

    /// Without its line end; valid until the next call. Nothing at a clean end. When the data
    /// breaks off, the piece of a line before that is dropped and ByteSourceError thrown.
    [[nodiscard]] std::optional<std::string_view> next();

    [[nodiscard]] std::size_t line_number() const { return line_number_; }  ///< from 1
    /// The last line given out ended with the file, not with a line end: it may be cut.
    [[nodiscard]] bool line_is_open() const { return line_is_open_; }
    [[nodiscard]] double progress() const { return bytes_.progress(); }

 private:
    std::string_view finish(std::string_view line);

    ByteSource bytes_;
    std::string pieces_;
    std::size_t to_consume_ = 0;
    std::size_t line_number_ = 0;
    bool line_is_open_ = false;
};
}  // namespace rtob
