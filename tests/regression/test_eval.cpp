// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "log_files.h"
#include "program.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using Json = nlohmann::json;

/// Three metres along +x of the estimate's map, with a kink at the end; in the reference's map it
/// is +y, and the last step is straight.
constexpr const char* estimate_tum =
    "# a trajectory\n"
    "10.0 0 0 0 0 0 0 1\n10.5 1 0 0 0 0 0 1\n11.0 2 0 0 0 0 0 1\n11.5 3 0.5 0 0 0 0 1\n";
constexpr const char* reference_planar =
    "10.0 5 5 1.570796326794897\n10.5 5 6 1.570796326794897\n11.001 5 7 1.570796326794897\n"
    "11.5 5 8 1.570796326794897\n20 9 9 0\n";

class Eval : public testing::Test
{
 protected:
    ProgramResult eval(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), "eval");
        return run_program(RTOB_PROGRAM, arguments);
    }

    void expectFailure(
        const std::vector<std::string>& arguments, const std::string& message, int code = 1) const
    {
        const auto result = eval(arguments);
        EXPECT_EQ(result.exit_code, code) << message;
        EXPECT_THAT(result.err, HasSubstr(message));
        EXPECT_EQ(result.out, "");
    }

    const TemporaryFolder folder_;
    const std::string estimate_ = folder_.write("est.tum", estimate_tum);
    const std::string reference_ = folder_.write("ref.GT.txt", reference_planar);
};

TEST_F(Eval, PrintsAteAndRpeAgainstATrajectory)
{
    const auto text = eval({estimate_, reference_, "--align", "origin", "--delta", "1m"});
    EXPECT_EQ(text.exit_code, 0) << text.err;
    EXPECT_THAT(
        text.out,
        AllOf(
            HasSubstr("matched  4 of 4 estimated poses with 4 of 5 of the reference"),
            HasSubstr("origin: estimate turned by 90.000 deg, then shifted by x 5.000 m, y 5.000"),
            HasSubstr("RPE (relative) over consecutive steps of 1 m along the estimate: 3 of"),
            HasSubstr("   0.500 m    0.000 deg  at 11.500000")));
}

TEST_F(Eval, GivesTheSameFiguresAsJson)
{
    const auto json = Json::parse(
        eval({estimate_, reference_, "--json", "--align", "origin", "--delta", "3", "--delta", "1"})
            .out);
    EXPECT_EQ(json["reference"], "trajectory");
    EXPECT_EQ(json["matched_poses"], 4);
    EXPECT_EQ(json["reference_poses"], 5);
    EXPECT_EQ(json["alignment"]["kind"], "origin");
    EXPECT_NEAR(json["alignment"]["yaw_deg"], 90, 1e-9);
    // Errors 0, 0, 0 and 0.5 m.
    const auto& translation = json["ate"]["translation_m"];
    EXPECT_NEAR(translation["rmse"], 0.25, 1e-9);
    EXPECT_NEAR(translation["mean"], 0.125, 1e-9);
    EXPECT_NEAR(translation["median"], 0, 1e-9);
    EXPECT_NEAR(translation["max"], 0.5, 1e-9);
    EXPECT_NEAR(translation["sse"], 0.25, 1e-9);
    EXPECT_NEAR(json["ate"]["rotation_deg"]["max"], 0, 1e-9);
    ASSERT_EQ(json["rpe"].size(), 2u);
    EXPECT_EQ(json["rpe"][0]["delta"], 3);
    EXPECT_EQ(json["rpe"][0]["unit"], "frames");
    EXPECT_EQ(json["rpe"][0]["steps"], "consecutive");
    EXPECT_EQ(json["rpe"][0]["path"], "estimate");
    EXPECT_EQ(json["rpe"][0]["count"], 1);
    EXPECT_EQ(json["rpe"][1]["count"], 3);
    EXPECT_NEAR(json["rpe"][1]["translation_m"]["sse"], 0.25, 1e-9);
    EXPECT_EQ(json["worst"][0]["time_s"], 11.5);
}

/// The sum of squares that is left is the smallest: known in closed form for four points.
TEST_F(Eval, AlignsByLeastSquaresWhenNotToldOtherwise)
{
    const auto json = Json::parse(eval({estimate_, reference_, "--json"}).out);
    EXPECT_EQ(json["alignment"]["kind"], "se2");
    // Centred, as complex numbers: e = (-1.5 - 0.125i, -0.5 - 0.125i, 0.5 - 0.125i, 1.5 + 0.375i),
    // r = i (-1.5, -0.5, 0.5, 1.5). sum |e|^2 = 5.1875, sum |r|^2 = 5, |sum conj(e) r| =
    // |5 i + 0.75| = sqrt(25.5625); sse = 5.1875 + 5 - 2 sqrt(25.5625).
    EXPECT_NEAR(json["ate"]["translation_m"]["sse"], 10.1875 - 2 * std::sqrt(25.5625), 1e-9);
}

TEST_F(Eval, WritesPicturesAndBothReports)
{
    const std::string out = folder_.file("deep/results");
    const auto result = eval({estimate_, reference_, "-o", out});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(file_content(out + "/eval.txt"), result.out);
    EXPECT_EQ(Json::parse(file_content(out + "/eval.json"))["matched_poses"], 4);
    for (const char* picture : {"/eval_errors.png", "/eval_path.png"})
        EXPECT_THAT(file_content(out + picture), HasSubstr("PNG")) << picture;
    EXPECT_EQ(eval({estimate_, reference_, "-o", out}).exit_code, 0) << "and does so again";

    const auto relations = folder_.write("a.relations", "10 10.5 1 0 0 0 0 0\n10 11 2 0 0 0 0 0\n");
    EXPECT_EQ(eval({estimate_, relations, "-o", out}).exit_code, 0);
    EXPECT_EQ(Json::parse(file_content(out + "/eval.json"))["relations_used"], 2);
    expectFailure({estimate_, reference_, "-o", estimate_}, "cannot be made");
}

TEST_F(Eval, SaysWhatIsWrongWithTheFiles)
{
    const auto write = [&](const char* name, const std::string& text)
    { return folder_.write(name, text); };
    const auto empty = write("empty", "");
    expectFailure({empty, reference_}, empty);
    expectFailure({estimate_, empty}, empty);
    expectFailure({estimate_, "/nowhere/ref"}, "/nowhere/ref");

    const auto later = write("later.tum", "100 0 0 0 0 0 0 1\n101 1 0 0 0 0 0 1\n");
    expectFailure({estimate_, later}, estimate_ + " against " + later + ": no stamp");
    const auto one = write("one.tum", "10 0 0 0 0 0 0 1\n");
    expectFailure({one, reference_}, "alignment se2 finds no turn");
    expectFailure({one, reference_, "--align", "origin"}, "1 frame apart");
    const auto nan = write("nan.tum", "10 0 0 0 0 0 0 1\n10.5 nan 0 0 0 0 0 1\n");
    expectFailure({nan, reference_}, nan + ", line 2: x is not a finite number");
    const auto strangers = write("strangers", "70 71 1 0 0 0 0 0.1\n");
    expectFailure({estimate_, strangers}, "none of the 1 relations names the stamps");
    const auto rawlog =
        write("a.rawlog", rawlog_bytes({mrpt::obs::CObservationOdometry::Create()}));
    expectFailure({estimate_, rawlog}, rawlog + ": the rawlog holds no poses");
    const auto carmen = write("a.log", "FLASER 2 1 1 0 0 0 0 0 0 1 h 1\n");
    expectFailure({estimate_, carmen}, carmen + ", line 1: 'FLASER'");
    expectFailure({strangers, reference_}, "relations stand where poses are needed");
}

TEST_F(Eval, LaysAMapOnAnother)
{
    std::string header =
        "ply\nformat ascii 1.0\nelement vertex 120\nproperty float x\n"
        "property float y\nproperty float z\nend_header\n";
    std::string corner, turned;
    for (int k = 0; k < 120; ++k)
    {
        // A corner of 4 m and 2 m; the other map has its axes a quarter turn on.
        const double x = k < 80 ? 0.05 * k : 0, y = k < 80 ? 0 : 0.05 * (k - 80);
        corner += std::to_string(x) + " " + std::to_string(y) + " 0\n";
        turned += std::to_string(y) + " " + std::to_string(-x) + " 0\n";
    }
    const auto reference = folder_.write("ref.ply", header + corner);
    const auto estimate = folder_.write("est.ply", header + turned);
    const std::string out = folder_.file("maps");
    const auto json = Json::parse(eval({estimate, reference, "--json", "-o", out}).out);
    EXPECT_NEAR(json["alignment"]["yaw_deg"], 90, 0.5);
    EXPECT_EQ(json["estimate_share"], 1);
    EXPECT_EQ(json["reference_share"], 1);
    EXPECT_THAT(file_content(out + "/eval.txt"), HasSubstr("100.0 % of the estimate's"));
    EXPECT_THAT(file_content(out + "/eval_maps.png"), HasSubstr("PNG"));

    expectFailure({estimate, reference_}, "compare a map with a map", 2);
    expectFailure({reference_, estimate}, "compare a map with a map", 2);
    expectFailure({estimate, reference, "--align", "se2"}, "--align: maps", 2);
    const auto bad = [&](const std::string& text, const std::string& what) {
        expectFailure({folder_.write("bad.ply", text), reference}, what);
    };
    bad(header.substr(0, 30), "bad.ply, line 3: the file ends here");
    bad(header + "1 2 0\n", "bad.ply, line 8: the file ends here");
    bad(header + "1 a 0\n", "bad.ply, line 8: no x and y");
    bad("ply\nformat binary_little_endian 1.0\nend_header\n", "not in ASCII");
    bad("ply\nformat ascii 1.0\nelement vertex 0\nend_header\n", "holds no points");
    bad("ply\nformat ascii 1.0\nelement vertex 1\nproperty float r\nend_header\n1\n",
        "begin with x and y");
}

TEST_F(Eval, RefusesFlagsThatMeanNothing)
{
    const auto relations = folder_.write("a.relations", "10 10.5 1 0 0 0 0 0\n");
    expectFailure({estimate_, relations, "--align", "se2"}, "--align: " + relations, 2);
    expectFailure({estimate_, reference_, "--align", "se3"}, "--align: 'se3'", 2);
    expectFailure({estimate_, reference_, "--delta", "1.5"}, "--delta: '1.5'", 2);
}

/// The truth against itself, read once from the rawlog's side and once as text; the log's stamps
/// and both files' formats must agree.
TEST_F(Eval, FindsTheTruthBesideMrptsOwnLog)
{
    const std::string log =
        "/usr/share/mrpt/datasets/graphslam-engine-demos/action_observations_map/simul.rawlog";
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "Debian's mrpt-common is not installed";
    const auto json = Json::parse(eval({log, log + ".GT.txt", "--align", "none", "--json"}).out);
    EXPECT_EQ(json["matched_poses"], 1734);
    EXPECT_NEAR(json["ate"]["full"]["max"], 0, 1e-12);  // a few roundings
}
}  // namespace
}  // namespace rtob::test
