// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/slam/scan_report.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rtob
{
/// What became of a scan, the first that applies.
enum class ScanFate
{
    Started,       ///< it started the map
    Matched,       ///< fits the map
    NewGround,     ///< fits as far as it overlaps the map
    WeakMatch,     ///< rejected: the prediction holds
    NoPair,        ///< rejected: too few points, or nothing of the map near them
    NoUsableBeam,  ///< rejected: the filter left nothing
};

constexpr auto enum_names(ScanFate)
{
    return std::array<std::pair<ScanFate, std::string_view>, 6>{
        {{ScanFate::Started, "started"},
         {ScanFate::Matched, "matched"},
         {ScanFate::NewGround, "new_ground"},
         {ScanFate::WeakMatch, "weak_match"},
         {ScanFate::NoPair, "no_pair"},
         {ScanFate::NoUsableBeam, "no_usable_beam"}}};
}

/// Whether the vehicle does not know where it is.
[[nodiscard]] bool is_lost(TrackingState state);

[[nodiscard]] ScanFate fate_of(const ScanReport& report);

/// Sums over the scans of a run.
class RunCounters
{
 public:
    void add(const ScanReport& report);

    [[nodiscard]] std::uint64_t scans() const { return scan_ms_.size(); }
    [[nodiscard]] std::uint64_t with(ScanFate fate) const
    {
        return fates_[static_cast<std::size_t>(fate)];
    }
    [[nodiscard]] std::uint64_t in(TrackingState state) const
    {
        return states_[static_cast<std::size_t>(state)];
    }
    [[nodiscard]] std::uint64_t rejected() const;
    /// Scans while the vehicle did not know where it was.
    [[nodiscard]] std::uint64_t lost() const;
    /// How often tracking was given up.
    [[nodiscard]] std::uint64_t timesLost() const { return times_lost_; }
    [[nodiscard]] std::uint64_t inserted() const { return inserted_; }
    [[nodiscard]] std::uint64_t anchored() const { return anchored_; }
    [[nodiscard]] std::uint64_t searched() const { return searched_; }
    /// Scans that left a direction open, as along a corridor.
    [[nodiscard]] std::uint64_t heldByGuess() const { return held_by_guess_; }
    [[nodiscard]] const BeamCounts& beams() const { return beams_; }
    [[nodiscard]] double pathLength() const { return path_m_; }
    /// How long the log took by the map's clock, which knows no jumps [s].
    [[nodiscard]] double logTime() const { return log_time_s_; }
    /// Of each scan, in order.
    [[nodiscard]] const std::vector<float>& scanTimes() const { return scan_ms_; }

 private:
    std::array<std::uint64_t, enum_names(ScanFate{}).size()> fates_{};
    std::array<std::uint64_t, enum_names(TrackingState{}).size()> states_{};
    std::uint64_t times_lost_ = 0, inserted_ = 0, anchored_ = 0, searched_ = 0, held_by_guess_ = 0;
    BeamCounts beams_;
    double path_m_ = 0, log_time_s_ = 0;
    std::vector<float> scan_ms_;
    std::optional<Pose2> pose_map_last_;
    bool was_lost_ = false;
};
}  // namespace rtob
