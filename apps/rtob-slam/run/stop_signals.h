// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <csignal>

namespace rtob
{
/// While one of these lives, the first SIGINT or SIGTERM asks the run to end; one that comes more
/// than a second later kills the program as usual. At most one at a time.
class StopSignals
{
 public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    [[nodiscard]] static bool requested();

 private:
    struct sigaction old_int_, old_term_;
};
}  // namespace rtob
