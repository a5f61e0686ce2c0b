// SPDX-License-Identifier: BSD-3-Clause
#include "line_source.h"

namespace rtob
{
namespace
{
constexpr std::size_t longest_line = 16 << 20;  // a line of 100 000 beams takes less
}

std::optional<std::string_view> LineSource::next()
{
    bytes_.consume(to_consume_);
    to_consume_ = 0;
    pieces_.clear();
    ++line_number_;
    for (;;)
    {
        const std::string_view chunk = bytes_.peek();
        if (chunk.empty())
        {
            line_is_open_ = true;
            if (pieces_.empty()) return std::nullopt;
            return finish(pieces_);
        }
        const auto line_end = chunk.find('\n');
        if (line_end == std::string_view::npos)
        {
            pieces_.append(chunk);
            bytes_.consume(chunk.size());
            if (pieces_.size() > longest_line)
                throw ByteSourceError(
                    "a line of more than " + std::to_string(longest_line) + " bytes",
                    "This is no text log: check the file");
            continue;
        }
        to_consume_ = line_end + 1;
        if (pieces_.empty()) return finish(chunk.substr(0, line_end));
        pieces_.append(chunk.substr(0, line_end));
        return finish(pieces_);
    }
}

std::string_view LineSource::finish(std::string_view line)
{
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}
}  // namespace rtob
