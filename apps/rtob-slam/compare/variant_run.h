// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/eval/comparison.h>

#include <functional>
#include <memory>

#include "compare/variant.h"
#include "compare/variant_job.h"

namespace rtob
{
using MakeVariant = std::function<std::unique_ptr<Variant>(const VariantJob&)>;

/// Lets a program run over the log, and writes into the job's folder: trajectory.tum (a pose for
/// each scan, at its stamp), timing.csv, result.json, and the pictures map.png (its own map) and
/// scans.png (all scans, put where it said the vehicle was). Throws what the program throws.
void run_variant(const VariantJob& job, const MakeVariant& make);

/// Reads back what run_variant() wrote. Throws std::runtime_error naming the file.
void read_variant_run(const std::string& folder, ComparedRun& run);
}  // namespace rtob
