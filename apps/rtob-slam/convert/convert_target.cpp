// SPDX-License-Identifier: BSD-3-Clause
#include "convert/convert_target.h"

#include <filesystem>

#include "usage_error.h"

namespace rtob
{
namespace
{
constexpr const char* what_is_possible =
    "Name it *.rawlog (MRPT), *.log or *.clf (CARMEN) or *.tum (poses), the texts also with .gz or "
    ".bz2 at the end; or say --to rawlog, --to carmen or --to tum";

bool is_packing(const std::filesystem::path& ending)
{
    return ending == ".gz" || ending == ".bz2";
}

ConvertTarget named_target(const std::string& to)
{
    if (to == "rawlog") return ConvertTarget::Rawlog;
    if (to == "carmen") return ConvertTarget::Carmen;
    if (to == "tum") return ConvertTarget::Tum;
    throw UsageError("--to: '" + to + "' is none of rawlog, carmen and tum");
}
}  // namespace

ConvertTarget convert_target(const std::string& output, const std::string& to)
{
    if (!to.empty()) return named_target(to);
    const std::filesystem::path path(output);
    auto ending = path.extension();
    if (ending == ".rawlog") return ConvertTarget::Rawlog;
    if (is_packing(ending)) ending = path.stem().extension();
    if (ending == ".log" || ending == ".clf") return ConvertTarget::Carmen;
    if (ending == ".tum") return ConvertTarget::Tum;
    throw UsageError("OUTPUT '" + output + "' does not say what to write. " + what_is_possible);
}
}  // namespace rtob
