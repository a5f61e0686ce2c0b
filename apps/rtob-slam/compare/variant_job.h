// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "run/offline_run.h"
#include "run/run_options.h"

namespace rtob
{
enum class VariantKind
{
    Rtob,
    Odometry,
    Mrpt,
    Pcl
};

constexpr auto enum_names(VariantKind)
{
    return std::array<std::pair<VariantKind, std::string_view>, 4>{
        {{VariantKind::Rtob, "rtob"},
         {VariantKind::Odometry, "odometry"},
         {VariantKind::Mrpt, "mrpt"},
         {VariantKind::Pcl, "pcl"}}};
}

/// A program with a setting, as it may be asked for.
struct VariantSpec
{
    std::string name;
    VariantKind kind = VariantKind::Rtob;
    std::string density;      ///< RTOB's; empty: that of the configuration
    std::string config_file;  ///< of MRPT or of the paper's recipe
    std::string description;  ///< for the report

    [[nodiscard]] bool usesSeed() const
    {
        return kind == VariantKind::Rtob || kind == VariantKind::Pcl;
    }
    [[nodiscard]] bool needsOdometry() const { return kind == VariantKind::Odometry; }
};

/// One run in a process of its own: all that it is told, kept as job.json in its folder.
struct VariantJob
{
    std::string log, folder;
    std::string config_file;        ///< of RTOB: which lasers and beams everybody uses, too
    std::vector<std::string> sets;  ///< Section.key=value, over the file
    RunLimits limits;
    VariantKind kind = VariantKind::Rtob;
    std::string density, variant_file;  ///< as in VariantSpec
    std::uint64_t seed = 1;
    double time_limit_s = 0;  ///< as a clock on the wall sees it; 0: none
    std::string title;        ///< of its pictures
};

/// Throws std::runtime_error naming the file.
void write_job(const std::string& file, const VariantJob& job);
[[nodiscard]] VariantJob read_job(const std::string& file);

/// The configuration of RTOB behind a job, its density and seed in it.
[[nodiscard]] RunConfig config_of(const VariantJob& job);
}  // namespace rtob
