// SPDX-License-Identifier: BSD-3-Clause
#include "log_kind.h"

#include <algorithm>

namespace rtob
{
namespace
{
/// An MRPT object starts with the length of its class's name, the top bit set, and that name.
bool starts_as_mrpt_object(std::string_view beginning)
{
    const auto mark = static_cast<unsigned char>(beginning.front());
    const std::string_view name = beginning.substr(1, mark & 0x7FU);
    const auto is_name_part = [](char c)
    {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               c == '_' || c == ':';
    };
    return (mark & 0x80U) != 0 && std::all_of(name.begin(), name.end(), is_name_part);
}
}  // namespace

LogKind log_kind_of(std::string_view beginning)
{
    if (starts_as_mrpt_object(beginning)) return LogKind::Rawlog;
    const bool printable = std::all_of(
        beginning.begin(), beginning.end(),
        [](char c)
        { return static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\n' || c == '\r'; });
    return printable ? LogKind::Text : LogKind::Unknown;
}
}  // namespace rtob
