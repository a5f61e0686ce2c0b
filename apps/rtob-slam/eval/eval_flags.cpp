// SPDX-License-Identifier: BSD-3-Clause
#include "eval/eval_flags.h"

#include <rtob/core/enum_names.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "usage_error.h"

namespace rtob
{
namespace
{
/// A finite number of at least 0.
double number_of(const char* flag, std::string_view text)
{
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number) ||
        number < 0)
        throw UsageError(
            std::string(flag) + ": '" + std::string(text) + "' is not a number of at least 0");
    return number;
}

/// "10" is frames, "2.5m" metres.
StepOptions step_of(std::string_view text)
{
    StepOptions step;
    if (!text.empty() && text.back() == 'm')
    {
        step.unit = DeltaUnit::Metres;
        text.remove_suffix(1);
    }
    step.delta = number_of("--delta", text);
    const bool is_whole = step.delta == std::floor(step.delta);
    if (step.delta == 0 || (step.unit == DeltaUnit::Frames && !is_whole))
        throw UsageError(
            "--delta: '" + std::string(text) +
            "' must be a whole number of frames, or metres as in 2.5m; above 0");
    return step;
}
}  // namespace

std::string EvalFlags::trajectoryFlag() const
{
    if (!align.empty()) return "--align";
    if (!max_difference.empty()) return "--max-diff";
    if (!deltas.empty()) return "--delta";
    if (!tolerance.empty()) return "--delta-tolerance";
    if (all_steps) return "--all-steps";
    if (steps_of_reference) return "--steps-of-reference";
    return {};
}

ScoreOptions score_options(const EvalFlags& flags)
{
    ScoreOptions options;
    try
    {
        if (!flags.align.empty()) options.alignment = parse_enum<Alignment>(flags.align);
    }
    catch (const std::invalid_argument& error)
    {
        throw UsageError(std::string("--align: ") + error.what());
    }
    if (!flags.max_difference.empty())
        options.max_difference_s = number_of("--max-diff", flags.max_difference);

    RelativeErrorOptions relative;
    relative.steps_of_reference = flags.steps_of_reference;
    options.relative.clear();
    for (const auto& delta : flags.deltas.empty() ? std::vector<std::string>{"1"} : flags.deltas)
    {
        relative.steps = step_of(delta);
        if (flags.all_steps) relative.steps.choice = StepChoice::All;
        if (!flags.tolerance.empty())
            relative.steps.tolerance = number_of("--delta-tolerance", flags.tolerance);
        options.relative.push_back(relative);
    }
    return options;
}
}  // namespace rtob
