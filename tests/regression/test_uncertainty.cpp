// SPDX-License-Identifier: BSD-3-Clause
// Whether the program knows how far off it may be, where the truth is known.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <sstream>

#include "rtob_slam_run.h"

namespace rtob::test
{
namespace
{
/// poses.csv by the names of its columns; the word of a state counts as 0.
std::vector<std::map<std::string, double>> read_table(const std::string& file)
{
    std::istringstream lines(file_content(file));
    const auto cells_of = [](const std::string& line)
    {
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        return cells;
    };
    std::string line;
    std::getline(lines, line);
    const auto names = cells_of(line);
    std::vector<std::map<std::string, double>> rows;
    while (std::getline(lines, line))
    {
        const auto cells = cells_of(line);
        auto& row = rows.emplace_back();
        for (std::size_t i = 0; i < cells.size(); ++i)
            row[names.at(i)] = std::strtod(cells[i].c_str(), nullptr);
    }
    return rows;
}

class Uncertainty : public RunFixture
{
 protected:
    /// Flies a corridor of 60 m by laser alone and compares with the truth.
    void flyCorridor(const std::string& seed)
    {
        const std::string log = folder_.file("corridor.rawlog");
        const auto flown = run_program(
            RTOB_PROGRAM, {"simulate", RTOB_SOURCE_DIR "/share/worlds/long-corridor.yaml", "-o",
                           log, "--seed", seed, "--laser-only", "--overwrite"});
        ASSERT_EQ(flown.exit_code, 0) << flown.err;
        const auto result = run(log, {"--overwrite"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        rows_ = read_table(results() + "/poses.csv");
        truth_ = read_tum(folder_.file("corridor.truth.tum"));
        ASSERT_EQ(rows_.size(), truth_.size());
    }
    /// Of the pose in map, the truth seen from where the map begins.
    [[nodiscard]] Pose2 error(std::size_t scan) const
    {
        const Pose2 truth = between(truth_.front().pose, truth_[scan].pose);
        const auto& row = rows_[scan];
        return {
            row.at("x_m") - truth.x, row.at("y_m") - truth.y,
            wrap_angle(row.at("yaw_rad") - truth.yaw)};
    }
    std::vector<std::map<std::string, double>> rows_;
    std::vector<StampedPose2> truth_;
};
}  // namespace

TEST_F(Uncertainty, TwoSigmaCoverTheErrorsOfACorridorOf60m)
{
    for (const char* seed : {"1", "2", "3"})
    {
        flyCorridor(seed);
        if (HasFatalFailure()) return;
        double covered_x = 0, covered_y = 0, covered_yaw = 0;
        for (std::size_t scan = 0; scan < rows_.size(); ++scan)
        {
            const auto& row = rows_[scan];
            const Pose2 off = error(scan);
            const auto covers = [&](double by, const char* variance)
            { return std::abs(by) <= 2 * std::sqrt(row.at(variance)); };
            // The map begins with the first scan, which itself has the laser's noise.
            covered_x += std::abs(off.x) < 0.01 || covers(off.x, "map_cov_x_x_m2");
            covered_y += std::abs(off.y) < 0.01 || covers(off.y, "map_cov_y_y_m2");
            covered_yaw += std::abs(off.yaw) < 0.003 || covers(off.yaw, "map_cov_yaw_yaw_rad2");
        }
        const auto scans = static_cast<double>(rows_.size());
        EXPECT_GE(covered_x / scans, 0.95) << "seed " << seed;
        EXPECT_GE(covered_y / scans, 0.95) << "seed " << seed;
        EXPECT_GE(covered_yaw / scans, 0.95) << "seed " << seed;
    }
}

TEST_F(Uncertainty, NamesTheDirectionThatACorridorLeavesOpen)
{
    flyCorridor("1");
    if (HasFatalFailure()) return;
    int open = 0, ten_times = 0, bare = 0;
    for (const auto& row : rows_)
    {
        if (row.at("x_m") < 18 || row.at("x_m") > 36) continue;  // out of sight of the niches
        ++bare;
        open += row.at("weak_share") < 0.01 && std::abs(row.at("weak_rad")) < 0.1;
        ten_times += row.at("cov_x_x_m2") > 100 * row.at("cov_y_y_m2");
    }
    ASSERT_GT(bare, 150);
    EXPECT_GE(open, 0.95 * bare);
    EXPECT_GE(ten_times, 0.95 * bare);
    EXPECT_GT(summary()["scans"]["held_by_guess"], bare / 2);
}
}  // namespace rtob::test
