// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/log_reader.h>

#include <algorithm>

#include "byte_source.h"
#include "carmen_reader.h"
#include "rawlog_reader.h"

namespace rtob
{
namespace
{
enum class LogKind
{
    Rawlog,
    Text,
    Unknown
};

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

LogKind kind_of(std::string_view beginning)
{
    if (starts_as_mrpt_object(beginning)) return LogKind::Rawlog;
    const bool printable = std::all_of(
        beginning.begin(), beginning.end(),
        [](char c)
        { return static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\n' || c == '\r'; });
    return printable ? LogKind::Text : LogKind::Unknown;
}
}  // namespace

std::unique_ptr<LogReader> open_log(const std::string& file)
{
    constexpr std::size_t looked_at_bytes = 256;
    try
    {
        ByteSource bytes(file);
        const auto beginning = bytes.peek().substr(0, looked_at_bytes);
        if (beginning.empty())
            throw ByteSourceError("the packed file holds nothing", "Record or copy the log again");
        switch (kind_of(beginning))
        {
            case LogKind::Rawlog:
                return std::make_unique<RawlogReader>(file);
            case LogKind::Text:
                return std::make_unique<CarmenReader>(file);
            case LogKind::Unknown:
                break;
        }
        throw ByteSourceError(
            "this is neither an MRPT rawlog nor a CARMEN text log",
            "Name a .rawlog, .log or .clf file, plain or packed by gzip or bzip2");
    }
    catch (const ByteSourceError& error)
    {
        throw LogError(file, "", error.what(), error.fix());
    }
}
}  // namespace rtob
