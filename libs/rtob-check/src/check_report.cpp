// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/check/check_report.h>

#include <algorithm>
#include <map>

namespace rtob
{
Severity CheckReport::worst() const
{
    Severity worst = Severity::Pass;
    for (const auto& finding : findings) worst = std::max(worst, finding.severity);
    return worst;
}

std::string CheckReport::ini() const
{
    // A section may stand only once, and a key once in it: the first reason wins.
    std::map<std::string, std::map<std::string, const Suggestion*>> sections;
    for (const auto& suggestion : suggestions)
        sections[suggestion.section].emplace(suggestion.key, &suggestion);
    std::string text;
    for (const auto& [section, keys] : sections)
    {
        text += (text.empty() ? "[" : "\n[") + section + "]\n";
        for (const auto& [key, suggestion] : keys)
            text += "# " + suggestion->reason + "\n" + key + " = " + suggestion->value + "\n";
    }
    return text;
}

const Finding* CheckReport::find(const std::string& id) const
{
    const auto found = std::find_if(
        findings.begin(), findings.end(), [&](const Finding& finding) { return finding.id == id; });
    return found == findings.end() ? nullptr : &*found;
}
}  // namespace rtob
