// SPDX-License-Identifier: BSD-3-Clause
#include "check/check_text.h"

#include <check_drive.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "run/run_options.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

CheckReport example()
{
    CheckReport report;
    report.findings = {
        {Severity::Pass, "a.fine", "all is well", "", {}},
        {Severity::Warn, "b.odd", "odd \xFF thing", "do this", {{"length_m", 1.5}}, "REAR"},
        {Severity::Fail, "c.bad", "bad thing", "do that", {}}};
    report.suggestions = {
        {"ScanFilter", "max_range_m", "29.10", "below the sentinel"},
        {"Run", "use_odometry", "false", "it stands still"},
        {"ScanFilter", "max_range_m", "30", "another laser"}};
    return report;
}

TEST(CheckText, HasALineForEachFindingAndItsFix)
{
    const auto text = check_text("my.log", example());
    EXPECT_THAT(text, HasSubstr("PASS a.fine                   all is well\n"));
    EXPECT_THAT(text, HasSubstr("REAR: odd"));
    EXPECT_THAT(text, HasSubstr("     -> do that\n"));
    EXPECT_THAT(text, HasSubstr("\n# it stands still\nuse_odometry = false\n"));
    EXPECT_THAT(text, HasSubstr("my.log: 1 FAIL, 1 WARN, 1 PASS\n"));
}

TEST(CheckText, JsonHoldsTheSame)
{
    const auto json = nlohmann::json::parse(check_json("my.log", example()));
    EXPECT_EQ(json["worst"], "FAIL");
    ASSERT_EQ(json["findings"].size(), 3u);
    EXPECT_EQ(json["findings"][1]["laser"], "REAR");
    EXPECT_EQ(json["findings"][1]["values"]["length_m"], 1.5);
    EXPECT_EQ(json["suggested_ini"], example().ini());
}

TEST(CheckText, AKeyStandsOnceInTheIni)
{
    const auto ini = example().ini();
    EXPECT_EQ(ini.find("max_range_m"), ini.rfind("max_range_m"));
    EXPECT_EQ(CheckReport().ini(), "");
    EXPECT_THAT(check_text("my.log", {}), HasSubstr("the defaults will do"));
}

/// Logs that bring forth every suggestion there is.
std::vector<CheckDrive> drives_with_suggestions()
{
    std::vector<CheckDrive> drives(5);
    drives[0].odometry = [](const Pose2&) { return Pose2{}; };
    drives[1].spoil_scan = [](auto& scan, int) { scan.rightToLeft = false; };
    drives[2].spoil_scan = [](auto& scan, int)
    {
        for (std::size_t i = 0; i < scan.getScanSize(); i += 10)
        {
            scan.setScanRange(i, 30);
            scan.setScanRangeValidity(i, true);
        }
    };
    drives[3].spoil_scan = [](auto& scan, int)
    {
        for (std::size_t i = 40; i <= 60; ++i) scan.setScanRange(i, 0.35F);
    };
    drives[4].odometry = [](const Pose2& step) { return Pose2{-step.y, step.x, step.yaw}; };
    return drives;
}

TEST(CheckText, EverySuggestionIsTakenByRun)
{
    std::set<std::string> keys;
    for (const auto& drive : drives_with_suggestions())
    {
        const auto report = check_drive(drive);
        for (const auto& suggestion : report.suggestions)
            keys.insert(suggestion.section + "." + suggestion.key);
        const TemporaryFile ini(".ini", report.ini());
        EXPECT_NO_THROW(static_cast<void>(load_run_config(ini.path(), {}))) << report.ini();
    }
    EXPECT_THAT(
        keys, testing::UnorderedElementsAre(
                  "Run.use_odometry", "ScanFilter.max_range_m", "ScanFilter.mask_deg",
                  "Sensor.override_mount", "Sensor.mount_x_m", "Sensor.mount_y_m",
                  "Sensor.mount_yaw_deg", "Sensor.upside_down", "Density.laser_range_m"));
}

TEST(CheckText, TheSuggestedValuesArrive)
{
    const auto report = check_drive(drives_with_suggestions()[3]);
    const TemporaryFile ini(".ini", report.ini());
    EXPECT_EQ(load_run_config(ini.path(), {}).slam.scan_filter.mask_deg, "-141.2..-118.8");
}
}  // namespace
}  // namespace rtob::test
