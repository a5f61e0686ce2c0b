// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/scan_table.h>

#include <cstddef>
#include <optional>

namespace rtob
{
/// Finds scans again, by the time at which they were written, in a map that may have forgotten some
/// of them since. Asked in the order in which they were written: several may share a time, as those
/// of two lasers, or of a log that repeats its stamps.
class ScanCursor
{
 public:
    explicit ScanCursor(const ScanTable& scans) : scans_(scans) {}

    /// @return its place in the table; nothing where the map has it no more. Of scans that share a
    /// time, of which the map has forgotten one, another may be taken for it.
    [[nodiscard]] std::optional<std::size_t> find(double map_time_s)
    {
        while (next_ < scans_.size() && scans_.time(next_) < map_time_s) ++next_;
        if (next_ == scans_.size() || scans_.time(next_) != map_time_s) return std::nullopt;
        return next_++;
    }

 private:
    const ScanTable& scans_;
    std::size_t next_ = 0;
};
}  // namespace rtob
