// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>
#include <rtob/core/spread.h>
#include <rtob/eval/relations.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Several programs on one log: what was measured, and the figures that a report shows.
namespace rtob
{
/// An error of a trajectory and when in the log it occurred.
struct ErrorAt
{
    double time_s = 0;
    double distance_m = 0;
};

/// How well a trajectory agrees with the truth.
struct Accuracy
{
    MeanStd distance_m, turn_deg;
    std::vector<ErrorAt> errors;  ///< one for each relation, or each pose of the truth
};

/// What the truth consists of.
enum class TruthKind
{
    None,
    Relations,  ///< hand-checked relative poses
    Trajectory  ///< a pose for each of many times
};

/// One run of one program over the log.
struct ComparedRun
{
    std::uint64_t seed = 1;
    int round = 1;        ///< 1, 2, ...: a round runs each variant once
    std::string folder;   ///< of the run's own files, seen from the report's
    std::string failure;  ///< why there is no result; empty: there is one

    std::vector<StampedPose2> trajectory;  ///< of each scan, seen from the first
    std::vector<float> scan_cpu_ms;        ///< of each scan: processor time
    std::vector<float> scan_wall_ms;       ///< of each scan: as a clock on the wall sees it
    double peak_memory_mb = 0;             ///< of the process, until the last scan
    std::uint64_t map_size = 0;
    std::string map_unit;                     ///< "points", "cells"
    std::optional<std::uint64_t> lost_scans;  ///< as the program itself says; none: it cannot say
    std::optional<Accuracy> accuracy;

    [[nodiscard]] bool failed() const { return !failure.empty(); }
};

/// One program with one setting.
struct ComparedVariant
{
    std::string name;
    std::string description;  ///< a sentence for people who do not know it
    std::string settings;     ///< the file with its options; empty: it has none
    bool uses_seed = false;
    bool is_reference = false;  ///< no SLAM: there to compare with
    std::vector<ComparedRun> runs;
};

struct Comparison
{
    std::string log, truth;  ///< as the user named them
    TruthKind truth_kind = TruthKind::None;
    std::size_t scans = 0;
    double duration_s = 0;
    bool has_odometry = false;
    std::string command;                                       ///< that repeats the comparison
    std::vector<std::pair<std::string, std::string>> machine;  ///< name and value of what it ran on
    std::vector<std::string> remarks;                          ///< what a reader should know
    std::vector<ComparedVariant> variants;
};

/// What the runs of a variant come to.
struct VariantFigures
{
    std::size_t results = 0, failures = 0;
    std::string failure;                 ///< of the first run that failed
    const ComparedRun* worst = nullptr;  ///< of largest error, the first where none is known
    Spread distance_m, turn_deg;         ///< of the runs' means; where the truth is known
    Spread scan_p50_ms, scan_p95_ms, scan_p99_ms, scan_max_ms;  ///< processor time
    Spread first_tenth_ms, last_tenth_ms;  ///< mean over these scans of the log
    Spread cpu_s;                          ///< of all scans
    Spread wall_p99_ms;
    Spread peak_memory_mb, map_size;
    std::optional<std::uint64_t> lost_scans;  ///< most in a run
};

/// Points into the variant's runs.
[[nodiscard]] VariantFigures figures_of(const ComparedVariant& variant);
}  // namespace rtob
