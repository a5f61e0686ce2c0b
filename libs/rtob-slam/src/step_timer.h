// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>

namespace rtob
{
/// Adds the time until it goes out of scope.
class StepTimer
{
 public:
    explicit StepTimer(double& sum_s) : sum_s_(sum_s), begin_(Clock::now()) {}
    ~StepTimer() { sum_s_ += std::chrono::duration<double>(Clock::now() - begin_).count(); }
    StepTimer(const StepTimer&) = delete;
    StepTimer& operator=(const StepTimer&) = delete;

 private:
    using Clock = std::chrono::steady_clock;
    double& sum_s_;
    Clock::time_point begin_;
};
}  // namespace rtob
