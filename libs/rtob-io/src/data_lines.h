// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/log_reader.h>

#include <optional>
#include <string>
#include <string_view>

#include "line_source.h"
#include "text_fields.h"

namespace rtob
{
/// The lines of a text file, plain or packed, that hold data: empty ones and those that start with
/// '#' are passed over. What goes wrong becomes a LogError with the line; a FieldError one with the
/// given fix.
class DataLines
{
 public:
    DataLines(const std::string& file, const char* field_fix) : file_(file), field_fix_(field_fix)
    {
        guarded([&] { lines_.emplace(file); });
    }

    /// What `parse` makes of the next line; nothing at the end.
    template <class Parse>
    [[nodiscard]] auto next(Parse&& parse)
        -> std::optional<decltype(parse(std::declval<std::string_view>()))>
    {
        std::optional<decltype(parse(std::declval<std::string_view>()))> parsed;
        guarded(
            [&]
            {
                if (const auto line = nextLine()) parsed = parse(*line);
            });
        return parsed;
    }

    [[nodiscard]] double progress() const { return lines_->progress(); }

 private:
    [[nodiscard]] std::optional<std::string_view> nextLine()
    {
        while (const auto line = lines_->next())
        {
            const auto begin = line->find_first_not_of(" \t");
            if (begin != std::string_view::npos && (*line)[begin] != '#') return line;
        }
        return std::nullopt;
    }

    template <class Step>
    void guarded(Step&& step)
    try
    {
        step();
    }
    catch (const ByteSourceError& error)
    {
        throw LogError(file_, place(), error.what(), error.fix());
    }
    catch (const FieldError& error)
    {
        throw LogError(file_, place(), error.what(), field_fix_);
    }

    [[nodiscard]] std::string place() const
    {
        return lines_ ? "line " + std::to_string(lines_->line_number()) : std::string();
    }

    std::string file_;
    const char* field_fix_;
    std::optional<LineSource> lines_;
};

/// Gives the lines to `takes_more` until it returns false.
template <class TakesMore>
void for_each_data_line(const std::string& file, const char* field_fix, TakesMore&& takes_more)
{
    DataLines lines(file, field_fix);
    while (const auto wants_more = lines.next(takes_more))
        if (!*wants_more) return;
}
}  // namespace rtob
