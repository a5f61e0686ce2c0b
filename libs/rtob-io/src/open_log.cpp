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

LogKind kind_of(std::string_view beginning)
{
    // An MRPT object starts with its class name's length, the top bit set; all names begin so.
    const auto is_object_mark = [](char c) { return (static_cast<unsigned char>(c) & 0x80) != 0; };
    if (beginning.size() > 1 && is_object_mark(beginning[0]) && beginning[1] >= 'A' &&
        beginning[1] <= 'z')
        return LogKind::Rawlog;
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
