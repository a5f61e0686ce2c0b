// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/log_reader.h>

#include <string>
#include <string_view>

#include "line_source.h"
#include "text_fields.h"

namespace rtob
{
/// Gives the lines of a text file, plain or packed, to `takes_more` until it returns false; empty
/// lines and those that start with '#' are passed over. What goes wrong becomes a LogError with the
/// line; a FieldError one with the given fix.
template <class TakesMore>
void for_each_data_line(const std::string& file, const char* field_fix, TakesMore&& takes_more)
{
    std::size_t line_number = 0;
    const auto place = [&line_number]
    { return line_number == 0 ? std::string() : "line " + std::to_string(line_number); };
    try
    {
        LineSource lines(file);
        for (++line_number; const auto line = lines.next(); ++line_number)
        {
            const auto begin = line->find_first_not_of(" \t");
            if (begin == std::string_view::npos || (*line)[begin] == '#') continue;
            if (!takes_more(*line)) return;
        }
    }
    catch (const ByteSourceError& error)
    {
        throw LogError(file, place(), error.what(), error.fix());
    }
    catch (const FieldError& error)
    {
        throw LogError(file, place(), error.what(), field_fix);
    }
}
}  // namespace rtob
