// SPDX-License-Identifier: BSD-3-Clause
#include "compare/machine.h"

#include <mrpt/system/os.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace rtob
{
namespace
{
/// The value of the first line "name : value" of a file of /proc.
std::string value_in(const char* file, const std::string& name)
{
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
    {
        const auto colon = line.find(": ");
        if (line.rfind(name, 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

std::string text_of(const MachineLoad& load)
{
    std::array<char, 64> text{};
    std::snprintf(
        text.data(), text.size(), "%.1f programs on %u processors", load.programs, load.processors);
    return text.data();
}
}  // namespace

std::optional<MachineLoad> machine_load()
{
    double programs = 0;
    if (getloadavg(&programs, 1) != 1) return std::nullopt;
    return MachineLoad{programs, std::max(1U, std::thread::hardware_concurrency())};
}

/// Runs come one at a time: nothing is in their way while the others leave a processor free.
std::string remark_on(const MachineLoad& load)
{
    if (load.programs < load.processors) return {};
    return "Other programs kept the computer busy when this began (" + text_of(load) +
           "). They slow all variants: compare the times below with each other, not with those of "
           "another report.";
}

std::vector<std::pair<std::string, std::string>> machine_facts()
{
    const auto load = machine_load();
    return {
        {"processor", value_in("/proc/cpuinfo", "model name")},
        {"load at the start", load ? text_of(*load) : "unknown"},
        {"RTOB-SLAM", RTOB_VERSION},
        {"MRPT", mrpt::system::MRPT_getVersion()},
        {"compiler", "gcc or clang " __VERSION__},
#ifdef NDEBUG
        {"build", "optimised"},
#else
        {"build", "with assertions: the times of RTOB-SLAM are not those of a release"},
#endif
    };
}
}  // namespace rtob
