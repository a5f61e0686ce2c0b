// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/no_return.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "convert/chosen_log.h"
#include "convert/convert_target.h"

namespace rtob
{
struct ConvertJob
{
    std::string log, output;
    ConvertTarget target = ConvertTarget::Rawlog;
    LogChoice choice;
    bool poses_are_odometry = false;  ///< the poses of a TUM file are, not robot poses
    bool may_overwrite = false;
    bool keep_part = false;  ///< of a damaged log: what comes before the damage
};

struct Conversion
{
    std::uint64_t scans = 0, odometry = 0, robot_poses = 0, others = 0;  ///< that were read
    std::map<std::string, NoReturn> no_returns;  ///< by laser, as they were found
    LogLosses losses;
    std::string damage;  ///< the reader's message, where the log ended early
};

/// Reads the log twice: once to know what it holds, once to write it. The output appears whole or
/// not at all. Throws UsageError for what no flag could mean, std::runtime_error for the rest, also
/// when `stop` says to end.
[[nodiscard]] Conversion convert_log(const ConvertJob& job, const std::function<bool()>& stop);

/// What the conversion did, found out and could not carry over, for a person to read.
[[nodiscard]] std::string conversion_text(const ConvertJob& job, const Conversion& conversion);
}  // namespace rtob
