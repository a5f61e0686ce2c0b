// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <rtob/io/tum.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "drive_log.h"
#include "log_files.h"
#include "program.h"

/// `rtob-slam run` as a process, on logs that the test makes. RTOB_PROGRAM names the program.
namespace rtob::test
{
/// A folder with a log; run() puts its results beside it.
class RunFixture : public testing::Test
{
 protected:
    std::string write_log(const std::string& name, const LogObjects& objects) const
    {
        return folder_.write(name, rawlog_bytes(objects));
    }
    /// A whole drive of 40 scans.
    std::string drive_log() const { return write_log("drive.rawlog", drive_objects(40)); }

    [[nodiscard]] std::string results(const std::string& name = "results") const
    {
        return folder_.file(name);
    }

    ProgramResult run(const std::string& log, const std::vector<std::string>& more = {}) const
    {
        return run_into(results(), log, more);
    }
    ProgramResult run_into(
        const std::string& results, const std::string& log,
        const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> arguments{"run", log, "-o", results};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(RTOB_PROGRAM, arguments);
    }

    [[nodiscard]] nlohmann::json summary(const std::string& name = "results") const
    {
        return nlohmann::json::parse(file_content(results(name) + "/summary.json"));
    }
    [[nodiscard]] std::vector<StampedPose2> trajectory(const std::string& name = "results") const
    {
        return read_tum(results(name) + "/trajectory.tum");
    }

    TemporaryFolder folder_;
};
}  // namespace rtob::test
