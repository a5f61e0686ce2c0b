// SPDX-License-Identifier: BSD-3-Clause
#include "recovery/recovery_text.h"

#include <rtob/core/spread.h>
#include <rtob/slam/relocaliser.h>

#include <algorithm>
#include <cstdio>

namespace rtob
{
namespace
{
constexpr int kLostInTime = 5;  // scans

template <class... Values>
std::string line(const char* format, Values... values)
{
    char text[300];
    std::snprintf(text, sizeof text, format, values...);
    return std::string(text) + "\n";
}

template <class Trial, class Number>
std::string spread(
    const char* name, const char* unit, const std::vector<Trial>& done, const Number& number)
{
    std::vector<float> values;
    for (const Trial& trial : done)
        if (const double value = number(trial); value >= 0)
            values.push_back(static_cast<float>(value));
    if (values.empty()) return line("  %-34s none", name);
    return line(
        "  %-34s %.1f / %.1f / %.1f %s", name, percentile(values, 0.5), percentile(values, 0.95),
        percentile(values, 1.0), unit);
}

template <class Trial, class Test>
int count_of(const std::vector<Trial>& done, const Test& test)
{
    return static_cast<int>(std::count_if(done.begin(), done.end(), test));
}
}  // namespace

std::string relocalise_text(
    const std::vector<RelocaliseTrial>& done, const RelocaliseTrials& trials)
{
    const auto with = [&](Outcome outcome)
    { return count_of(done, [&](const auto& trial) { return trial.outcome == outcome; }); };
    const auto found = [](const RelocaliseTrial& trial, double value)
    { return trial.outcome == Outcome::Nowhere ? -1.0 : value; };
    const auto share = [&](int count)
    { return done.empty() ? 0.0 : 100.0 * count / static_cast<double>(done.size()); };
    std::string text = line(
        "relocalise: %zu random scans, up to %d scans each, map without them and %.0f s around",
        done.size(), trials.most_scans, trials.left_out_s);
    text += line(
        "  right within %.1f m and %.0f deg    %d (%.1f %%)", trials.right_m, trials.right_deg,
        with(Outcome::Right), share(with(Outcome::Right)));
    text += line(
        "  false accepts                      %d (%.1f %%)", with(Outcome::Wrong),
        share(with(Outcome::Wrong)));
    text += line("  not found                          %d", with(Outcome::Nowhere));
    const double enough = RelocaliseOptions().min_explained_share;
    text += line(
        "  not right, and hardly mapped       %d (less than %.1f of a scan)",
        count_of(
            done, [&](const auto& trial)
            { return trial.outcome != Outcome::Right && trial.explained_at_truth < enough; }),
        enough);
    text += spread(
        "scans needed p50/p95/max", "", done,
        [&](const auto& trial) { return found(trial, trial.scans); });
    text += spread(
        "time of all p50/p95/max", "ms", done,
        [&](const auto& trial) { return found(trial, trial.total_ms); });
    text += spread(
        "time of the worst scan p50/p95/max", "ms", done,
        [](const auto& trial) { return trial.worst_ms; });
    text += spread(
        "to draw the map p50/p95/max", "ms", done, [](const auto& trial) { return trial.map_ms; });
    for (const RelocaliseTrial& trial : done)
        if (trial.outcome != Outcome::Right)
            text += line(
                "  scan %zu: %s after %d scans, %.2f m and %.1f deg off; where it was, the map "
                "explains "
                "%.2f of it at least",
                trial.scan, trial.outcome == Outcome::Wrong ? "wrong" : "not found", trial.scans,
                trial.error_m, trial.error_deg, trial.explained_at_truth);
    return text;
}

std::string kidnap_text(const std::vector<KidnapTrial>& done, const KidnapTrials& trials)
{
    const bool is_carried = trials.mishap == Mishap::Carried;
    std::string text =
        is_carried ? line("carried away: %zu times, at least %.0f m", done.size(), trials.least_m)
                   : line("covered: %zu times, for %d scans", done.size(), trials.scans_covered);
    const auto is_in_time = [](const KidnapTrial& trial)
    { return trial.lost_after > 0 && trial.lost_after <= kLostInTime; };
    text +=
        line("  LOST within %d scans                %d", kLostInTime, count_of(done, is_in_time));
    text += line(
        "  TRACKING on, at the right place    %d",
        count_of(done, [](const auto& trial) { return trial.was_followed(); }));
    text += spread(
        "scans to LOST p50/p95/max", "", done,
        [](const auto& trial) { return trial.lost_after > 0 ? trial.lost_after : -1.0; });
    text += line(
        "  TRACKING again within %d scans     %d", trials.scans_after,
        count_of(done, [](const auto& trial) { return trial.found_after > 0; }));
    text += spread(
        "scans to TRACKING p50/p95/max", "", done,
        [](const auto& trial) { return trial.found_after > 0 ? trial.found_after : -1.0; });
    text += line(
        "  false accepts                      %d",
        count_of(done, [](const auto& trial) { return trial.is_false_accept; }));
    text += line(
        "  map changed in between             %d",
        count_of(done, [](const auto& trial) { return !trial.map_unchanged; }));
    for (const KidnapTrial& trial : done)
        if (!trial.was_followed() && (!is_in_time(trial) || trial.found_after == 0 ||
                                      trial.is_false_accept || !trial.map_unchanged))
            text += line(
                "  scan %zu to %zu: LOST after %d, TRACKING after %d%s, %d scans at a wrong "
                "place%s",
                trial.from, trial.to, trial.lost_after, trial.found_after,
                trial.is_false_accept ? " (wrong)" : "", trial.tracking_wrong,
                trial.map_unchanged ? "" : ", map changed");
    return text;
}
}  // namespace rtob
