// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "comparison_table.h"

namespace rtob
{
namespace
{
struct Ranked
{
    std::string name;
    double figure = 0;
};

/// "a (0.1 m), b (0.2 m), c (3 m)": the smallest first.
std::string ranking(std::vector<Ranked> ranked, const std::string& unit)
{
    std::stable_sort(
        ranked.begin(), ranked.end(),
        [](const auto& a, const auto& b) { return a.figure < b.figure; });
    std::string text;
    for (const auto& [name, figure] : ranked)
        text += (text.empty() ? "" : ", ") + name + " (" + readable(figure) + "\u00a0" + unit + ")";
    return text;
}

/// "rtob-revisit 0.2 to 0.2 ms, ..."
std::string growth(const Comparison& comparison)
{
    std::string text;
    for (const auto& variant : comparison.variants)
    {
        const VariantFigures figures = figures_of(variant);
        if (figures.results == 0 || variant.is_reference) continue;
        text += (text.empty() ? "" : ", ") + variant.name + " " +
                readable(figures.first_tenth_ms.median) + "\u00a0→\u00a0" +
                readable(figures.last_tenth_ms.median) + "\u00a0ms";
    }
    return text;
}

/// Of poses at the same scan.
double largest_distance_m(const std::vector<StampedPose2>& a, const std::vector<StampedPose2>& b)
{
    double largest_m = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest_m =
            std::max(largest_m, std::hypot(a[i].pose.x - b[i].pose.x, a[i].pose.y - b[i].pose.y));
    return largest_m;
}

/// Without a truth: how far the others' paths come from the first one's. Empty where there are no
/// two paths.
std::string agreement(const Comparison& comparison)
{
    std::string first_name;
    const ComparedRun* first = nullptr;
    std::vector<Ranked> others;
    for (const auto& variant : comparison.variants)
    {
        const ComparedRun* run = figures_of(variant).worst;
        if (run == nullptr) continue;
        if (first != nullptr)
            others.push_back(
                {variant.name, largest_distance_m(run->trajectory, first->trajectory)});
        else
        {
            first = run;
            first_name = variant.name;
        }
    }
    if (others.empty()) return {};
    return "How far each path comes from that of " + first_name +
           " at most, nearest first: " + ranking(others, "m") +
           ". Where most agree, a path that is metres off has lost its way; the pictures show "
           "which.";
}
}  // namespace

std::vector<std::string> comparison_findings(const Comparison& comparison)
{
    std::vector<Ranked> errors, costs;
    std::string failed;
    for (const auto& variant : comparison.variants)
    {
        const VariantFigures figures = figures_of(variant);
        if (figures.failures > 0) failed += (failed.empty() ? "" : ", ") + variant.name;
        if (figures.results == 0) continue;
        if (figures.worst->accuracy)
            errors.push_back({variant.name, figures.worst->accuracy->distance_m.mean});
        if (!variant.is_reference) costs.push_back({variant.name, figures.cpu_s.median});
    }
    std::vector<std::string> findings;
    if (!errors.empty())
        findings.push_back("Most accurate first, by the worst run: " + ranking(errors, "m") + ".");
    if (comparison.truth_kind == TruthKind::None)
        if (auto text = agreement(comparison); !text.empty()) findings.push_back(std::move(text));
    if (!costs.empty())
    {
        findings.push_back(
            "Least processor time for the whole log first: " + ranking(costs, "s") + ".");
        findings.push_back(
            "How the mean time of a scan changed from the first tenth of the log to the last (a "
            "time "
            "that grows with the map will some day be too long): " +
            growth(comparison) + ".");
    }
    if (!failed.empty()) findings.push_back("Failed: " + failed + "; the table says why.");
    return findings;
}

std::string comparison_title(const Comparison& comparison)
{
    return "SLAM programs compared on " + comparison.log.substr(comparison.log.rfind('/') + 1);
}

std::string comparison_summary(const Comparison& comparison)
{
    std::size_t runs = 0;
    for (const auto& variant : comparison.variants) runs += variant.runs.size();
    return "SLAM works out, from what a laser sees, where a vehicle is, and draws a map on the "
           "way. Here a vehicle drove for " +
           readable(comparison.duration_s) + " s and recorded " +
           readable(static_cast<double>(comparison.scans)) +
           " laser scans. Each program below had to say where the vehicle was at each scan, from "
           "the "
           "same scans" +
           (comparison.has_odometry ? " and the same odometry (what the wheels report)" : "") +
           ", one after the other on one computer, " + std::to_string(runs) +
           " runs in all, each in a process of its own.";
}

std::string figures_sentence(const Comparison& comparison)
{
    std::string sentence =
        "Each figure is the median of a variant's runs, with the lowest and the highest where "
        "these differ. Times are processor time.";
    if (comparison.truth_kind != TruthKind::None)
        sentence += " The error in the first column is that of the worst run.";
    return sentence;
}

std::string truth_sentence(const Comparison& comparison)
{
    switch (comparison.truth_kind)
    {
        case TruthKind::None:
            return "No truth was given for this log, so nobody knows which path is right. Look at "
                   "the pictures: where a variant put scans wrongly, its walls are doubled or "
                   "blurred.";
        case TruthKind::Relations:
            return "The truth is a list of relations in " + comparison.truth +
                   ": people checked by hand where the vehicle was at one time, seen from another. "
                   "The error is how far a variant's path disagrees with each of them.";
        case TruthKind::Trajectory:
            return "The truth is the trajectory in " + comparison.truth +
                   ". Each variant's path is laid onto it as well as a shift and a turn can; the "
                   "error is the distance that remains at each pose.";
    }
    return {};
}
}  // namespace rtob
