// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "recovery/driven_log.h"

namespace rtob
{
/// What is done to the vehicle.
enum class Mishap
{
    Carried,  ///< the log jumps to scans taken elsewhere
    Covered   ///< something hangs before the laser for a while, 0.3 m off
};

struct KidnapTrials
{
    std::uint64_t count = 50, seed = 1;
    Mishap mishap = Mishap::Carried;
    double least_m = 5;     ///< how far it is carried
    double left_out_s = 2;  ///< of the map, around the scans of the trial
    int scans_before = 5, scans_covered = 20, scans_after = 40;
};

/// How one of them went. Counts of scans begin with the first after the mishap; 0: never.
struct KidnapTrial
{
    std::size_t from = 0, to = 0;  ///< scans of the driven log
    int lost_after = 0;            ///< scans until LOST
    int found_after = 0;           ///< scans until TRACKING again, after the cover is gone
    bool is_false_accept = false;  ///< TRACKING again, and not where it is
    int tracking_wrong = 0;        ///< scans TRACKING at a wrong place
    /// While LOST it was as before the mishap, by checksum: what was written until then is taken
    /// back. Of a mishap that is never noticed, whether anything was written.
    bool map_unchanged = true;

    /// Not far enough away to get lost: the first scan was matched where it was taken.
    [[nodiscard]] bool was_followed() const { return lost_after == 0 && tracking_wrong == 0; }
};

/// Lets a vehicle track in the map without the scans of the trial, and carries it away or covers
/// its laser. It has no odometry.
[[nodiscard]] std::vector<KidnapTrial> kidnap_trials(
    const DrivenLog& driven, const SlamOptions& options, const KidnapTrials& trials);
}  // namespace rtob
