// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/core/option_checks.h>
#include <rtob/slam/tracking.h>

namespace rtob
{
void TrackingOptions::validate() const
{
    require(lost_after >= 1, "lost_after", lost_after, ">= 1");
    require(confirm_after >= 1, "confirm_after", confirm_after, ">= 1");
    require(min_agreement >= 0 && min_agreement < 1, "min_agreement", min_agreement, "in [0, 1)");
}

TrackingStateMachine::TrackingStateMachine(const TrackingOptions& options) : options_(options)
{
    options_.validate();
}

void TrackingStateMachine::start()
{
    state_ = TrackingState::Tracking;
    weak_in_a_row_ = good_in_a_row_ = 0;
}

void TrackingStateMachine::lose(bool has_candidates)
{
    state_ = has_candidates ? TrackingState::Relocalising : TrackingState::Lost;
    weak_in_a_row_ = good_in_a_row_ = 0;
}

TrackingState TrackingStateMachine::next(FitVerdict verdict)
{
    const bool was_lost = isLost();
    const bool matched =
        verdict == FitVerdict::Good || (verdict == FitVerdict::NewGround && !was_lost);
    weak_in_a_row_ = matched ? 0 : weak_in_a_row_ + 1;
    good_in_a_row_ = matched ? good_in_a_row_ + 1 : 0;
    if (was_lost)
    {
        if (good_in_a_row_ >= options_.confirm_after)
            state_ = TrackingState::Tracking;
        else
            state_ = matched ? TrackingState::Relocalising : TrackingState::Lost;
    }
    else if (matched)
        state_ = TrackingState::Tracking;
    else
        state_ =
            weak_in_a_row_ >= options_.lost_after ? TrackingState::Lost : TrackingState::Degraded;
    return state_;
}
}  // namespace rtob
