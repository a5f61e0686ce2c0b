// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/avoid/guard_options.h>
#include <rtob/avoid/vehicle_limits.h>
#include <rtob/slam/slam_options.h>

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace rtob
{
struct RunOptions
{
    std::uint64_t seed = 1;
    bool use_odometry = true;
    double map_resolution_m = 0.05;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("seed", s.seed, "same log, same options, same seed: the same bytes");
        visit("use_odometry", s.use_odometry, "take the log's odometry where it has some");
        visit(
            "map_resolution_m", s.map_resolution_m,
            "side of a cell of map.pgm; doubled where the picture would get too large; >= 0.005");
    }
    void validate() const;
};

/// All that an .ini of `rtob-slam run` may hold.
struct RunConfig
{
    RunOptions run;
    SlamOptions slam;
    VehicleLimits vehicle;  ///< of the guard
    GuardOptions guard;

    template <class Self, class Visit>
    static void sections(Self& s, Visit&& visit)
    {
        visit("Run", s.run);
        SlamOptions::sections(s.slam, visit);
        visit("VehicleLimits", s.vehicle);
        visit("Guard", s.guard);
    }
};

/// One value from the command line.
struct OptionFlag
{
    std::string typed;  ///< as messages name it, e.g. "--seed"
    std::string section, key, value;
};

/// "Section.key=value". Throws UsageError for another form.
[[nodiscard]] OptionFlag parse_set_flag(const std::string& text);
[[nodiscard]] std::vector<OptionFlag> parse_set_flags(const std::vector<std::string>& texts);

/// Defaults, then the file's values (an empty name: no file), then the flags'. Throws
/// std::runtime_error that names the file, section and key, or UsageError that names the flag.
[[nodiscard]] RunConfig load_run_config(
    const std::string& file, const std::vector<OptionFlag>& flags);

/// As an .ini that, read back, gives the same configuration.
void save_run_config(std::ostream& out, const RunConfig& config);
}  // namespace rtob
