// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "run/guard_feed.h"
#include "run/output_folder.h"
#include "run/run_options.h"
#include "run/scan_files.h"

namespace rtob
{
/// What a pilot is taken to wish while a log is replayed.
struct GuardWish
{
    bool as_driven = true;  ///< the vehicle's own motion in the log
    Eigen::Vector2d velocity_vehicle = Eigen::Vector2d::Zero();  ///< else this, all the time; m/s
};

/// "driven", or metres a second ahead and left, e.g. "0.5,0". Throws UsageError.
[[nodiscard]] GuardWish parse_guard_wish(const std::string& text);

struct GuardCounts
{
    std::array<std::uint64_t, enum_names(GuardReason{}).size()> reasons{};
    std::uint64_t decisions = 0;
    double wished_m = 0, commanded_m = 0;  ///< sums of speed times time
    double slowest_decision_ms = 0;        ///< of the processor, with the scan before it
};

/// Asks the guard after each scan of a run what it would have commanded: guard.csv. The log goes on
/// as it was driven, so each line stands for itself.
class GuardReplay
{
 public:
    GuardReplay(const RunConfig& config, const GuardWish& wish);
    ~GuardReplay();

    /// Opens the file, in a folder that is there.
    void open(const OutputFolder& folder);
    void add(const mrpt::obs::CObservation2DRangeScan& scan, const ScanReport& report);
    void commit();

    [[nodiscard]] const GuardCounts& counts() const { return counts_; }

 private:
    void write(double stamp_s, const Eigen::Vector2d& wish, const GuardDecision& decision);
    void count(double stamp_s, const Eigen::Vector2d& wish, const GuardDecision& decision);

    GuardWish wish_;
    GuardFeed feed_;
    VelocityGuard guard_;
    GuardCounts counts_;
    double last_s_ = 0;
    std::unique_ptr<AtomicFile> file_;
};
}  // namespace rtob
