// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace rtob
{
enum class Severity
{
    Pass,
    Warn,  ///< to be known: costs accuracy, or traps other programs
    Fail   ///< a run with the defaults would fail or be wrong
};

/// One thing that was looked at.
struct Finding
{
    Severity severity = Severity::Pass;
    std::string id;                                      ///< stable, for programs: "stamps.order"
    std::string text;                                    ///< what was found, with its figures
    std::string fix;                                     ///< what to do; empty after Pass
    std::vector<std::pair<std::string, double>> values;  ///< the figures, units in their names
    std::string laser = {};  ///< label of the laser it speaks of; empty: the log as a whole
};

/// A line for the .ini of `rtob-slam run`.
struct Suggestion
{
    std::string section, key, value;
    std::string reason;
};

struct CheckReport
{
    std::vector<Finding> findings;
    std::vector<Suggestion> suggestions;

    [[nodiscard]] Severity worst() const;
    /// The suggested .ini: sections with a comment above each key; empty where defaults will do.
    [[nodiscard]] std::string ini() const;
    /// Null where there is no such finding.
    [[nodiscard]] const Finding* find(const std::string& id) const;
};
}  // namespace rtob
