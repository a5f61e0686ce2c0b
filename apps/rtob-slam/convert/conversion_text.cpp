// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "convert/convert_job.h"

namespace rtob
{
namespace
{
std::string counted(std::uint64_t count, const std::string& one, const std::string& many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string written_text(const Conversion& conversion)
{
    std::string text = counted(conversion.scans, "scan", "scans");
    text += ", " + counted(conversion.odometry, "odometry reading", "odometry readings");
    if (conversion.robot_poses > 0)
        text += ", " + counted(conversion.robot_poses, "robot pose", "robot poses");
    if (conversion.others > 0)
        text += ", " + counted(conversion.others, "other observation", "other observations");
    return text;
}

std::string no_return_text(const std::string& label, const NoReturn& no_return)
{
    char range[32];
    std::snprintf(range, sizeof(range), "%.2f", static_cast<double>(no_return.from_m));
    return label + ": " + range + " m and more means no return (" +
           counted(no_return.beams, "beam", "beams") + "); --max-range sets another limit\n";
}
}  // namespace

std::string conversion_text(const ConvertJob& job, const Conversion& conversion)
{
    std::string text = job.output + ": from " + written_text(conversion) + "\n";
    if (!job.choice.max_range_m)
        for (const auto& [label, no_return] : conversion.no_returns)
            text += no_return_text(label, no_return);
    if (conversion.losses.empty()) return text;
    text += "not carried over, or changed:\n";
    for (const auto& [what, times] : conversion.losses)
    {
        const std::string count = std::to_string(times);
        text +=
            std::string(count.size() < 9 ? 9 - count.size() : 0, ' ') + count + "  " + what + "\n";
    }
    return text;
}
}  // namespace rtob
