// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/eval/comparison_report.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "comparison_sample.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

TEST(ComparisonCsv, HasALineForEachRun)
{
    const auto lines = lines_of(comparison_csv(comparison_sample()));
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_THAT(lines[0], StartsWith("variant,round,seed,scans,lost_scans,error_mean_m"));
    // 3 scans of 1, 2 and 3 ms; an error of 0.25 +- 0.01 m, 1.5 +- 0.5 deg.
    EXPECT_EQ(lines[1], "good,1,1,3,,0.25,0.01,1.5,0.5,2,3,3,3,2,3,3,1,3,0.006,64,1234567,points,");
    EXPECT_THAT(lines[2], StartsWith("good,1,2,3,,0.5,"));
    EXPECT_THAT(lines[3], StartsWith("poor,1,,3,7,4,"));
}

TEST(ComparisonCsv, AFailedRunHasItsReasonInTheLastColumn)
{
    const auto lines = lines_of(comparison_csv(comparison_sample()));
    const std::string reason = R"(,"a file <x.ini> is ""missing"", so | it ends")";
    const std::string& line = lines.back();
    ASSERT_THAT(line, HasSubstr(reason));
    const std::string before = line.substr(0, line.find(reason) + 1);
    EXPECT_EQ(
        std::count(before.begin(), before.end(), ','),
        std::count(lines[0].begin(), lines[0].end(), ','));
}

TEST(ComparisonMarkdown, EveryRowOfTheTableHasAllColumns)
{
    std::vector<std::ptrdiff_t> bars;
    for (const auto& line : lines_of(comparison_markdown(comparison_sample())))
        if (line.rfind("|", 0) == 0) bars.push_back(std::count(line.begin(), line.end(), '|'));
    ASSERT_EQ(bars.size(), 5u);  // head, rule, three variants
    EXPECT_THAT(bars, testing::Each(bars.front()));
}

TEST(ComparisonMarkdown, ShowsTheWorstRunAndTheSpread)
{
    const auto text = comparison_markdown(comparison_sample());
    EXPECT_THAT(text, HasSubstr("| good | 0.5 ± 0.01 | 0.375 (0.25 – 0.5) |"));
    EXPECT_THAT(text, HasSubstr("good (0.5\u00a0m), poor (4\u00a0m)"));
    EXPECT_THAT(text, HasSubstr("| – | 1 234 567 points"));  // good cannot say that it is lost
    EXPECT_THAT(text, HasSubstr("| 7 | 1 234 567 points"));
    EXPECT_THAT(text, HasSubstr("| broken | failed: a file <x.ini> is"));
}

TEST(ComparisonMarkdown, SaysBeforeTheTableHowToReadIt)
{
    auto comparison = comparison_sample();
    comparison.remarks = {"The computer was busy."};
    const auto text = comparison_markdown(comparison);
    const auto table = text.find("| variant |");
    ASSERT_NE(table, std::string::npos);
    EXPECT_LT(text.find("The computer was busy."), table);
    EXPECT_LT(text.find("the median of a variant's runs"), table);
    EXPECT_LT(text.find("that of the worst run"), table);
}

TEST(ComparisonMarkdown, WithoutTruthClaimsNoError)
{
    auto comparison = comparison_sample();
    comparison.truth_kind = TruthKind::None;
    for (auto& variant : comparison.variants)
        for (auto& run : variant.runs) run.accuracy.reset();
    const auto text = comparison_markdown(comparison);
    EXPECT_THAT(text, HasSubstr("No truth was given"));
    EXPECT_THAT(text, Not(HasSubstr("error, worst run")));
    EXPECT_THAT(text, HasSubstr("differences.svg"));
    EXPECT_THAT(text, HasSubstr("that of good at most, nearest first: poor (0\u00a0m)."));
}

TEST(ComparisonMarkdown, NamesVariantsThatFailedNowAndThen)
{
    auto comparison = comparison_sample();
    comparison.variants[0].runs.push_back(failed_run("crashed"));
    EXPECT_THAT(
        comparison_markdown(comparison), HasSubstr("**good**: 1 of 3 runs failed: crashed"));
}

TEST(ComparisonHtml, HoldsAllItNeeds)
{
    const TemporaryFolder folder;
    auto comparison = comparison_sample();
    comparison.variants[1].runs[0].folder = "runs/poor-1";
    std::filesystem::create_directories(folder.file("runs/poor-1"));
    folder.write("runs/poor-1/scans.png", "PNG");
    const auto html = comparison_html(comparison, folder.path());
    EXPECT_THAT(html, HasSubstr("data:image/png;base64,UE5H"));  // "PNG" in base64
    EXPECT_THAT(html, HasSubstr("poor, mean error 4 m"));
    EXPECT_THAT(html, HasSubstr("<svg"));
    EXPECT_THAT(html, HasSubstr("failed: a file &lt;x.ini&gt; is &quot;missing&quot;"));
    EXPECT_THAT(html, Not(HasSubstr("src=\"http")));
    EXPECT_THAT(html, Not(HasSubstr("src=\"runs")));
    EXPECT_THAT(html, HasSubstr("</html>"));
}

TEST(ComparisonReport, OfVariantsThatAllFailedIsWritten)
{
    const TemporaryFolder folder;
    auto comparison = comparison_sample();
    comparison.variants.erase(comparison.variants.begin(), comparison.variants.begin() + 2);
    write_comparison_report(folder.path(), comparison);
    EXPECT_THAT(file_content(folder.file("report.html")), HasSubstr("is &quot;missing&quot;"));
    EXPECT_THAT(file_content(folder.file("report.md")), HasSubstr("Failed: broken"));
    EXPECT_EQ(lines_of(file_content(folder.file("results.csv"))).size(), 2u);
}

TEST(ComparisonReport, WritesThePlotsThatTheMarkdownShows)
{
    const TemporaryFolder folder;
    write_comparison_report(folder.path(), comparison_sample());
    for (const char* plot : {"paths.svg", "errors.svg", "error_shares.svg", "times.svg"})
    {
        EXPECT_THAT(file_content(folder.file("report.md")), HasSubstr(plot));
        EXPECT_THAT(file_content(folder.file(plot)), StartsWith("<svg"));
    }
}
}  // namespace
}  // namespace rtob::test
