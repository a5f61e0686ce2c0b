// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "eval/evaluation.h"

namespace rtob
{
/// Writes eval.txt, eval.json and pictures into a folder, which is made; other files in it stay. Of
/// a trajectory: eval_errors.png (errors over time) and eval_path.png (coloured by its error); of a
/// map: eval_maps.png (both over each other). Throws std::runtime_error.
void write_eval_files(
    const std::string& folder, const Evaluation& evaluation, const std::string& title);
}  // namespace rtob
