// SPDX-License-Identifier: BSD-3-Clause
// `rtob-slam check` as a process: exit codes, JSON, the way from its .ini to a run.
#include <check_drive.h>
#include <gmock/gmock.h>
#include <program.h>

#include <nlohmann/json.hpp>

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

ProgramResult check(const std::vector<std::string>& arguments)
{
    std::vector<std::string> all{"check"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_program(RTOB_PROGRAM, all);
}

TEST(Check, ACleanLogGivesZero)
{
    const TemporaryFile log(".rawlog", rawlog_bytes(objects_of({})));
    const auto result = check({log.path()});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr(log.path() + ": 0 FAIL, 0 WARN, "));
}

TEST(Check, AFailGivesOneAndItsIniMendsTheRun)
{
    CheckDrive drive;
    drive.spoil_scan = [](auto& scan, int)
    {
        for (std::size_t i = 30; i < 180; ++i)
        {
            scan.setScanRange(i, i < 90 ? 0.3F : 25.0F);
            scan.setScanRangeValidity(i, true);
        }
    };
    const TemporaryFolder folder;
    const auto log = folder.write("drive.rawlog", rawlog_bytes(objects_of(drive)));
    const auto result = check({log, "--json"});
    EXPECT_EQ(result.exit_code, 1);
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["worst"], "FAIL");
    const auto ini = folder.write("mended.ini", json["suggested_ini"].get<std::string>());
    const auto run =
        run_program(RTOB_PROGRAM, {"run", log, "-c", ini, "-o", folder.file("results")});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto summary =
        nlohmann::json::parse(file_content(folder.file("results") + "/summary.json"));
    // The 60 beams and one on either side, where those see anything.
    EXPECT_GE(summary["beams"]["masked"], house_lap_scans * 60);
    EXPECT_LE(summary["beams"]["masked"], house_lap_scans * 62);
    EXPECT_GE(summary["beams"]["too_far"], house_lap_scans * 89);
}

TEST(Check, BadInputIsRefusedAsInRun)
{
    const TemporaryFolder folder;
    const auto missing = check({folder.file("none.rawlog")});
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_THAT(missing.err, HasSubstr("No such file"));
    const auto foreign = check({folder.write("image.png", "\x01\x02\x03")});
    EXPECT_EQ(foreign.exit_code, 1);
    EXPECT_THAT(foreign.err, HasSubstr("neither an MRPT rawlog nor a CARMEN text log"));
    EXPECT_EQ(check({}).exit_code, 2);
    EXPECT_EQ(check({"a", "--jsonn"}).exit_code, 2);
}

/// The faults that the published logs are known to have.
class CheckRealLog : public testing::Test
{
 protected:
    void SetUp() override
    {
        const char* folder = std::getenv("RTOB_DATASETS");
        if (folder == nullptr) GTEST_SKIP() << "RTOB_DATASETS is not set";
        folder_ = std::string(folder) + "/";
    }
    void read(const std::string& log) { report_ = check_log(folder_ + log); }
    double value(const std::string& id, const std::string& name) const
    {
        return figure(report_, id, name);
    }
    void expect(Severity severity, const std::string& id) const
    {
        const auto* finding = report_.find(id);
        ASSERT_TRUE(finding) << id;
        EXPECT_EQ(finding->severity, severity) << finding->text;
    }

    std::string folder_;
    CheckReport report_;
};

TEST_F(CheckRealLog, Intel)
{
    read("intel/intel.clf.bz2");
    expect(Severity::Warn, "stamps.order");
    expect(Severity::Pass, "stamps.origin");
    EXPECT_EQ(value("stamps.order", "steps_back"), 631);
    EXPECT_NEAR(value("stamps.order", "worst_back_s"), 0.9, 0.05);
    EXPECT_NEAR(value("stamps.rate", "rate_hz"), 5.1, 0.05);
    expect(Severity::Warn, "ranges.no_return");
    EXPECT_NEAR(value("ranges.no_return", "usual_m"), 81.83, 0.006);
    EXPECT_EQ(value("ranges.no_return", "count"), 68313);  // counted in the log's text
    EXPECT_NEAR(value("odometry.source", "odometry_path_m"), 508, 1);
    expect(Severity::Pass, "odometry.reverse");
    EXPECT_NE(report_.worst(), Severity::Fail);
}

TEST_F(CheckRealLog, Fr079)
{
    read("fr079/fr079.clf.bz2");
    expect(Severity::Pass, "stamps.order");
    expect(Severity::Pass, "stamps.origin");
    EXPECT_NEAR(value("laser.mount", "x_m"), -0.04, 1e-6);
    EXPECT_NEAR(value("ranges.no_return", "usual_m"), 81.91, 0.006);
    EXPECT_EQ(value("ranges.no_return", "count"), 36881);
    expect(Severity::Warn, "odometry.reverse");
    EXPECT_GT(value("odometry.reverse", "odometry_says_forward"), 80);
    EXPECT_GT(value("odometry.reverse", "wrong_m"), 7);
    EXPECT_EQ(value("odometry.reverse", "odometry_agrees"), 0);
    EXPECT_LT(std::abs(value("odometry.lag", "laser_after_odometry_scans")), 0.8);
}

TEST_F(CheckRealLog, Killian)
{
    read("mit-killian/mit-killian.reconstructed.clf.gz");
    expect(Severity::Warn, "stamps.origin");  // rebuilt on a grid
    EXPECT_NEAR(value("stamps.origin", "commonest_interval_s"), 0.439192, 1e-6);
    expect(Severity::Warn, "ranges.no_return");
    EXPECT_NEAR(value("ranges.no_return", "high_m"), 51.2, 0.1);
    expect(Severity::Warn, "odometry.lag");
    EXPECT_NEAR(value("odometry.lag", "laser_after_odometry_scans"), 1.5, 0.3);
    expect(Severity::Warn, "odometry.heading");
    EXPECT_THAT(report_.find("odometry.heading")->text, HasSubstr("wildly"));
    expect(Severity::Pass, "odometry.reverse");
}

TEST_F(CheckRealLog, TheMuseumsPosesAreNoWheels)
{
    read("fhw_museum/fhw-corrected.log.gz");
    EXPECT_NEAR(value("ranges.no_return", "low_m"), 51.05, 0.006);
    EXPECT_NEAR(value("ranges.no_return", "high_m"), 51.1, 0.006);
    EXPECT_LT(value("stamps.rate", "rate_hz"), 0.5);
    expect(Severity::Warn, "motion.spacing");
    EXPECT_NEAR(value("motion.spacing", "spacing_m"), 1, 0.2);
    expect(Severity::Warn, "odometry.origin");
}

TEST_F(CheckRealLog, Slambot)
{
    read("slambot_rplidar/data_6AUG14_16m.norm.clf.gz");
    EXPECT_EQ(value("ranges.zero", "zero"), 403766);
    expect(Severity::Warn, "odometry.rotation_scale");
    EXPECT_NEAR(value("odometry.rotation_scale", "scale"), 1.08, 0.03);
    expect(Severity::Pass, "odometry.origin");
    expect(Severity::Pass, "stamps.origin");  // whole milliseconds
}

TEST_F(CheckRealLog, MinesUrg)
{
    for (const char* run : {"exp1", "exp2", "exp3", "exp4"})
    {
        read(std::string("mines_urg/") + run + ".norm.clf.gz");
        EXPECT_GT(value("ranges.zero", "zero") / value("laser.beams", "scans") / 682, 0.4);
        expect(Severity::Warn, "ranges.codes");
        EXPECT_LT(value("odometry.rotation_scale", "scale"), 0.96) << run;
        expect(Severity::Warn, "odometry.lag");
    }
}

TEST_F(CheckRealLog, CcnyHasNoOdometry)
{
    read("ccny_handheld/demo.norm.clf.gz");
    expect(Severity::Warn, "odometry.source");
    EXPECT_EQ(value("odometry.source", "scans_with_odometry"), 0);
    EXPECT_EQ(value("ranges.zero", "zero"), 13342);
}
}  // namespace
}  // namespace rtob::test
