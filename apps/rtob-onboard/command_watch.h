// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/drivers/mavlink_messages.h>

#include <mutex>
#include <string>

namespace rtob
{
/// What is to be sent, and what a ground station is to read of it.
struct GuardCommand
{
    mavlink::SetPositionTargetLocalNed target;  ///< standing still unless set
    std::string state;   ///< a reason of the guard, or why there is none: changes are told
    std::string detail;  ///< of the obstacle, where one limits
    bool is_warning = true;
};

/// Between the thread that decides and the one that sends: when decisions stop coming, what is sent
/// is zero. Who sends never waits for who decides.
class CommandWatch
{
 public:
    explicit CommandWatch(double max_stall_s) : max_stall_s_(max_stall_s) {}

    void put(GuardCommand command, double now_s);
    /// The last command, or a stop when it is too old.
    [[nodiscard]] GuardCommand take(double now_s);

    [[nodiscard]] std::uint64_t stalls() const;

 private:
    const double max_stall_s_;
    mutable std::mutex mutex_;
    GuardCommand command_;
    double decided_s_ = -1e9;
    bool is_stalled_ = true;  ///< until the first decision, which is no stall
    std::uint64_t stalls_ = 0;
};
}  // namespace rtob
