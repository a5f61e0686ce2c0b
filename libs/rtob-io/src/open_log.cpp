// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/log_reader.h>

#include "byte_source.h"
#include "carmen_reader.h"
#include "log_kind.h"
#include "rawlog_reader.h"

namespace rtob
{
std::unique_ptr<LogReader> open_log(const std::string& file)
{
    constexpr std::size_t looked_at_bytes = 256;
    try
    {
        ByteSource bytes(file);
        const auto beginning = bytes.peek().substr(0, looked_at_bytes);
        if (beginning.empty())
            throw ByteSourceError("the packed file holds nothing", "Record or copy the log again");
        switch (log_kind_of(beginning))
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
