// SPDX-License-Identifier: BSD-3-Clause
#include "compare/machine.h"

#include <mrpt/system/os.h>

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

std::string load_text()
{
    std::array<double, 1> load{};
    if (getloadavg(load.data(), 1) != 1) return "unknown";
    std::array<char, 64> text{};
    std::snprintf(
        text.data(), text.size(), "%.1f of %u processors busy", load[0],
        std::thread::hardware_concurrency());
    return text.data();
}
}  // namespace

std::vector<std::pair<std::string, std::string>> machine_facts()
{
    return {
        {"processor", value_in("/proc/cpuinfo", "model name")},
        {"load at the start", load_text()},
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
