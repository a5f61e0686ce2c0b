// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace rtob
{
/// What the program returns, for every verb.
enum ExitCode : int
{
    kExitOk = 0,
    kExitFailed = 1,  ///< also: ended early by a signal or a damaged log, with results up to there
    kExitUsage = 2,
    kExitLost = 3  ///< the run finished, but the vehicle was lost at its end
};
}  // namespace rtob
