// SPDX-License-Identifier: BSD-3-Clause
#include "check/check_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rtob
{
namespace
{
using Json = nlohmann::ordered_json;

std::string word_of(Severity severity)
{
    switch (severity)
    {
        case Severity::Pass:
            return "PASS";
        case Severity::Warn:
            return "WARN";
        case Severity::Fail:
            return "FAIL";
    }
    throw std::logic_error("word_of: unknown severity");
}

std::string finding_text(const Finding& finding)
{
    constexpr std::size_t text_column = 25;
    const std::string indent(5, ' ');
    std::string id = finding.id;
    id.resize(std::max(id.size() + 1, text_column), ' ');
    std::string text = word_of(finding.severity) + " " + id;
    if (!finding.laser.empty()) text += finding.laser + ": ";
    text += finding.text + "\n";
    if (!finding.fix.empty()) text += indent + "-> " + finding.fix + "\n";
    return text;
}

std::size_t count_of(const CheckReport& report, Severity severity)
{
    return static_cast<std::size_t>(std::count_if(
        report.findings.begin(), report.findings.end(),
        [&](const Finding& finding) { return finding.severity == severity; }));
}

std::string ini_text(const CheckReport& report)
{
    const std::string ini = report.ini();
    if (ini.empty()) return "\nSuggested .ini: none, the defaults will do.\n";
    return "\nSuggested .ini (rtob-slam run LOG -c FILE.ini):\n\n" + ini;
}
}  // namespace

std::string check_text(const std::string& log, const CheckReport& report)
{
    std::string text;
    for (const auto& finding : report.findings) text += finding_text(finding);
    text += ini_text(report) + "\n" + log + ":";
    for (const auto severity : {Severity::Fail, Severity::Warn, Severity::Pass})
        text += " " + std::to_string(count_of(report, severity)) + " " + word_of(severity) +
                (severity == Severity::Pass ? "\n" : ",");
    return text;
}

std::string check_json(const std::string& log, const CheckReport& report)
{
    Json findings = Json::array();
    for (const auto& finding : report.findings)
    {
        Json values = Json::object();
        for (const auto& [name, value] : finding.values) values[name] = value;
        findings.push_back(
            {{"severity", word_of(finding.severity)},
             {"id", finding.id},
             {"laser", finding.laser},
             {"text", finding.text},
             {"fix", finding.fix},
             {"values", values}});
    }
    const Json json{
        {"log", log},
        {"worst", word_of(report.worst())},
        {"findings", findings},
        {"suggested_ini", report.ini()}};
    // Paths and labels need not be UTF-8; a report must not fail over them.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}
}  // namespace rtob
