// SPDX-License-Identifier: BSD-3-Clause
#include "compare/variant_list.h"

#include <mrpt/system/filesystem.h>
#include <rtob/core/nearest_name.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "compare/child_process.h"
#include "compare/mrpt_variant.h"
#include "compare/rtob_variant.h"
#include "usage_error.h"

namespace rtob
{
namespace
{
namespace fs = std::filesystem;

/// In the tree of the build and in the installed one alike.
fs::path beside_program(const std::string& name)
{
    return fs::path(own_program()).parent_path() / name;
}

std::string own_config(const std::string& name)
{
    return (beside_program("../share/rtob/config") / name).lexically_normal();
}

/// Of Debian's package mrpt-common.
std::string stock_config(const std::string& name)
{
    return mrpt::system::getShareMRPTDir() + "config_files/icp-slam/" + name;
}

std::string pcl_program()
{
    return beside_program("rtob-compare-pcl");
}

VariantSpec rtob_variant(const std::string& density)
{
    return {
        "rtob-" + density, VariantKind::Rtob, density, "",
        "RTOB-SLAM with the density '" + density +
            "': each scan is matched against a fixed number of points drawn from the whole map."};
}

std::vector<VariantSpec> mrpt_variants()
{
    return {
        {"mrpt-stock", VariantKind::Mrpt, "", stock_config("icp-slam_demo_classic.ini"),
         "MRPT ICP-SLAM exactly as Debian ships it: matches every fifth beam, seldom adds to its "
         "map."},
        {"mrpt-dense", VariantKind::Mrpt, "", own_config("mrpt-icp-slam-dense.ini"),
         "MRPT ICP-SLAM with the best settings that we found: every beam, matched every 5 cm, "
         "added "
         "every 30 cm."},
        {"mrpt-lm", VariantKind::Mrpt, "", stock_config("icp-slam_demo_LM.ini"),
         "MRPT ICP-SLAM with Levenberg-Marquardt, as Debian ships it."},
        {"mrpt-grid", VariantKind::Mrpt, "", stock_config("icp-slam_demo_classic_gridmatch.ini"),
         "MRPT ICP-SLAM that matches against an occupancy grid, as Debian ships it."}};
}

std::vector<VariantSpec> all_variants(const VariantChoice& choice)
{
    std::vector<VariantSpec> all;
    for (const auto& density : choice.densities) all.push_back(rtob_variant(density));
    for (const auto& mrpt : mrpt_variants()) all.push_back(mrpt);
    for (const auto& file : choice.mrpt_files)
        all.push_back(
            {"mrpt-" + fs::path(file).stem().string(), VariantKind::Mrpt, "", file,
             "MRPT ICP-SLAM with settings of the user's own."});
    if (fs::exists(pcl_program()))
        all.push_back(
            {"pcl", VariantKind::Pcl, "", own_config("paper.ini"),
             "The recipe of the RTOB-SLAM paper, its scans aligned by the Point Cloud Library."});
    all.push_back(
        {"odometry", VariantKind::Odometry, "", "", "No SLAM: the log's odometry by itself."});
    return all;
}
}  // namespace

std::vector<VariantSpec> chosen_variants(const VariantChoice& choice)
{
    const auto all = all_variants(choice);
    if (choice.names.empty()) return all;
    std::vector<std::string> known;
    for (const auto& variant : all) known.push_back(variant.name);
    for (const auto& name : choice.names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw UsageError(
                "--variant: there is no '" + name + "'" + suggestion(name, known) +
                "; there are: " + joined(known));
    std::vector<VariantSpec> chosen;
    for (const auto& variant : all)
        if (std::find(choice.names.begin(), choice.names.end(), variant.name) != choice.names.end())
            chosen.push_back(variant);
    return chosen;
}

std::unique_ptr<Variant> make_variant(const VariantJob& job)
{
    switch (job.kind)
    {
        case VariantKind::Rtob:
            return std::make_unique<RtobVariant>(config_of(job).slam);
        case VariantKind::Odometry:
            return std::make_unique<OdometryVariant>();
        case VariantKind::Mrpt:
            return std::make_unique<MrptVariant>(job.variant_file);
        case VariantKind::Pcl:
            throw std::logic_error("the PCL variant is a program of its own");
    }
    throw std::logic_error("make_variant: unknown kind");
}

std::vector<std::string> runner_of(VariantKind kind)
{
    if (kind == VariantKind::Pcl) return {pcl_program()};
    return {own_program(), "compare-run"};
}
}  // namespace rtob
