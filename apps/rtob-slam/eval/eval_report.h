// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "eval/evaluation.h"

namespace rtob
{
/// "consecutive steps of 2.5 m along the estimate"
[[nodiscard]] std::string step_text(const RelativeErrorOptions& options);

/// The figures as a table for people, several lines.
[[nodiscard]] std::string report_text(const Evaluation& evaluation);

/// The same figures as JSON, with a line end. Units are in the keys.
[[nodiscard]] std::string report_json(const Evaluation& evaluation);
}  // namespace rtob
