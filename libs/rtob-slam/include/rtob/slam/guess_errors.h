// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/core/pose2.h>

namespace rtob
{
/// How far the guess usually is from the match, as this vehicle's odometry has shown so far: a
/// quantile of the errors that forgets slowly, so that a few wild ones do not move it.
class GuessErrors
{
 public:
    /// @param pose_guess_match of a scan that fitted without a search
    void learn(const Pose2& pose_guess_match);

    /// Whether so large an error has not been usual.
    [[nodiscard]] bool isUnusual(const Pose2& pose_guess_match) const;

 private:
    double usual_m_ = 0.5, usual_rad_ = 0.5;  ///< at first nothing is unusual
};
}  // namespace rtob
