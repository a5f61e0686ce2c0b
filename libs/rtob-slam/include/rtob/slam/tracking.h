// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/slam/fit_gate.h>

#include <array>
#include <string_view>
#include <utility>

namespace rtob
{
/// What the pose is worth.
enum class TrackingState
{
    Init,         ///< no usable scan yet
    Tracking,     ///< matched
    Degraded,     ///< the match is weak: nothing is written
    Lost,         ///< weak for too long: nothing is written
    Relocalising  ///< a place in the map was found and is being confirmed
};

constexpr auto enum_names(TrackingState)
{
    return std::array<std::pair<TrackingState, std::string_view>, 5>{
        {{TrackingState::Init, "INIT"},
         {TrackingState::Tracking, "TRACKING"},
         {TrackingState::Degraded, "DEGRADED"},
         {TrackingState::Lost, "LOST"},
         {TrackingState::Relocalising, "RELOCALISING"}}};
}

struct TrackingOptions
{
    int lost_after = 4;
    int confirm_after = 3;
    double min_agreement = 0.9;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("lost_after", s.lost_after, "weak scans in a row until LOST; >= 1");
        visit(
            "confirm_after", s.confirm_after,
            "good scans in a row until found again, where [Relocalise] is not enabled; >= 1");
        visit(
            "min_agreement", s.min_agreement,
            "share of a scan that does not fit where it was expected that must agree with the last "
            "one, as far as they see the same; else what is written is taken back if [Relocalise] "
            "finds a better place; 0: not looked at; [0, 1)");
    }
    void validate() const;
};

/// INIT -> TRACKING <-> DEGRADED -> LOST <-> RELOCALISING -> TRACKING.
class TrackingStateMachine
{
 public:
    explicit TrackingStateMachine(const TrackingOptions& options = {});

    /// The state after a scan with this verdict.
    TrackingState next(FitVerdict verdict);
    /// The first usable scan has started the map, or the place was found.
    void start();
    /// The place is not known, or there are places that wait to be confirmed.
    void lose(bool has_candidates = false);

    [[nodiscard]] TrackingState state() const { return state_; }
    [[nodiscard]] bool isLost() const
    {
        return state_ == TrackingState::Lost || state_ == TrackingState::Relocalising;
    }

 private:
    TrackingOptions options_;
    TrackingState state_ = TrackingState::Init;
    int weak_in_a_row_ = 0, good_in_a_row_ = 0;
};
}  // namespace rtob
