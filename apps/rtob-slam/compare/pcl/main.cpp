// SPDX-License-Identifier: BSD-3-Clause
// Runs the PCL variant of a comparison: rtob-slam compare starts it with the job of one run. A
// program of its own, so that rtob-slam neither needs PCL nor carries its memory.
#include <iostream>

#include "compare/child_process.h"
#include "compare/pcl/pcl_variant.h"
#include "compare/variant_run.h"
#include "exit_code.h"

namespace
{
/// The paper's settings; which lasers and beams are used stays as everybody's.
rtob::SlamOptions options_of(const rtob::VariantJob& job)
{
    auto options = rtob::load_run_config(job.variant_file, {}).slam;
    const auto common = rtob::config_of(job).slam;
    options.scan_filter = common.scan_filter;
    options.seed = common.seed;
    return options;
}
}  // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        std::cerr << "rtob-slam: rtob-compare-pcl is started by rtob-slam compare\n";
        return rtob::kExitUsage;
    }
    rtob::end_with_parent();
    try
    {
        rtob::register_classes();
        rtob::run_variant(
            rtob::read_job(argv[1]), [](const rtob::VariantJob& job)
            { return std::make_unique<rtob::PclVariant>(options_of(job)); });
        return rtob::kExitOk;
    }
    catch (const std::exception& error)
    {
        std::cerr << "rtob-slam: " << error.what() << "\n";
        return rtob::kExitFailed;
    }
}
