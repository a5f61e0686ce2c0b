// SPDX-License-Identifier: BSD-3-Clause
#include "run/output_folder.h"

#include <array>
#include <stdexcept>
#include <system_error>

namespace rtob
{
namespace fs = std::filesystem;

namespace
{
/// Every file that a run may write: what --overwrite removes before a new one.
constexpr std::array<const char*, 13> result_names{
    "trajectory.tum",
    "trajectory_final.tum",
    "poses.csv",
    "timing.csv",
    "map.pgm",
    "map.yaml",
    "map.ply",
    "map.rtob",
    "map.simplemap",
    "map.png",
    "summary.txt",
    "summary.json",
    "config.effective.ini"};

bool is_ending(const fs::path& extension)
{
    for (const char* ending : {".gz", ".bz2", ".rawlog", ".clf", ".log", ".norm"})
        if (extension == ending) return true;
    return false;
}
}  // namespace

fs::path default_output_folder(const std::string& log)
{
    fs::path name = fs::path(log).filename();
    while (is_ending(name.extension())) name = name.stem();
    return fs::path("out") / (name.empty() ? "run" : name);
}

OutputFolder::OutputFolder(fs::path folder, bool may_overwrite) : folder_(std::move(folder))
{
    std::error_code error;
    if (!fs::exists(folder_, error) && !error) return;
    if (!fs::is_directory(folder_, error))
        throw std::runtime_error(
            "output folder " + folder_.string() + ": this is not a folder that can be opened" +
            (error ? ": " + error.message() : "") + ". Name another one with -o.");
    const bool is_empty = fs::is_empty(folder_, error);
    if (error)
        throw std::runtime_error("output folder " + folder_.string() + ": " + error.message());
    if (is_empty || may_overwrite) return;
    throw std::runtime_error(
        "output folder " + folder_.string() +
        " is not empty. Name another one with -o, or add --overwrite.");
}

void OutputFolder::create() const
{
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error)
        throw std::runtime_error(
            "output folder " + folder_.string() + " cannot be made: " + error.message() +
            ". Name another one with -o.");
    for (const char* name : result_names) fs::remove(folder_ / name, error);
}
}  // namespace rtob
