// SPDX-License-Identifier: BSD-3-Clause
#include "tune/tune_plan.h"

#include <rtob/map/options_io.h>

#include <algorithm>

namespace rtob
{
namespace
{
constexpr double usual_forgetting_s = 60;  // forgetting needs a time
}

std::vector<Sweep> tuning_sweeps()
{
    return {
        {"Draw", "points", {"300", "600", "1200", "1800", "2700", "3600", "5400"}, ""},
        {"Icp", "iterations", {"4", "8", "16", "24", "32", "50"}, ""},
        {"Icp", "max_pair_distance_m", {"0.2", "0.3", "0.45", "0.6", "0.9", "1.2"}, ""},
        {"Density", "density", {"uniform", "window", "forgetting", "revisit"}, ""},
        {"Density", "window_s", {"10", "30", "60", "120"}, "window"},
        {"Density", "forgetting_s", {"10", "30", "60", "120"}, "forgetting"},
        {"Density", "sigma_s", {"0.3", "1", "3", "10"}, "revisit"}};
}

RunConfig config_with(const RunConfig& config, const Sweep& sweep, const std::string& value)
{
    RunConfig changed = config;
    RunConfig::sections(
        changed,
        [&](const char* section, auto& options)
        {
            if (sweep.section != section) return;
            set_option(options, sweep.key, value);
        });
    auto& icp = changed.slam.icp;
    icp.final_pair_distance_m = std::min(icp.final_pair_distance_m, icp.max_pair_distance_m);
    icp.line_radius_m = std::min(icp.line_radius_m, icp.max_pair_distance_m);
    auto& density = changed.slam.density;
    if (!sweep.density.empty()) density.density = parse_enum<Density>(sweep.density);
    if (density.density == Density::Forgetting && density.forgetting_s == 0)
        density.forgetting_s = usual_forgetting_s;
    return changed;
}

std::string value_in(const RunConfig& config, const Sweep& sweep)
{
    std::string found;
    RunConfig::sections(
        config,
        [&](const char* section, const auto& options)
        {
            if (sweep.section != section) return;
            std::decay_t<decltype(options)>::fields(
                options,
                [&](const char* key, const auto& value, const char*)
                {
                    if (sweep.key == key) found = option_text(value);
                });
        });
    return found;
}
}  // namespace rtob
