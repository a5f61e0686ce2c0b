// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "compare/variant.h"
#include "compare/variant_job.h"

namespace rtob
{
/// What decides which programs are compared.
struct VariantChoice
{
    std::vector<std::string> densities;   ///< a RTOB variant for each
    std::vector<std::string> mrpt_files;  ///< further .ini files of icp-slam
    std::vector<std::string> names;       ///< of those to run; empty: all
};

/// In the order of the report: RTOB, MRPT, PCL where it is built, odometry. Throws UsageError for a
/// name that none has.
[[nodiscard]] std::vector<VariantSpec> chosen_variants(const VariantChoice& choice);

/// The program behind a job: all kinds but PCL's, which is a program of its own.
[[nodiscard]] std::unique_ptr<Variant> make_variant(const VariantJob& job);

/// What runs a job of this kind, and its first arguments.
[[nodiscard]] std::vector<std::string> runner_of(VariantKind kind);
}  // namespace rtob
