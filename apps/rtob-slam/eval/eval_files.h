// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "eval/evaluation.h"

namespace rtob
{
/// Writes eval.txt, eval.json, eval_errors.png (errors over time) and eval_path.png (the trajectory
/// coloured by its error) into a folder, which is made; other files in it stay. Throws
/// std::runtime_error.
void write_eval_files(
    const std::string& folder, const Evaluation& evaluation, const std::string& title);
}  // namespace rtob
