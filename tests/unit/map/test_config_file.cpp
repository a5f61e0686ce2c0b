// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <rtob/map/config_file.h>

#include "error_message.h"
#include "temporary_file.h"

using mrpt::config::CConfigFileMemory;
using rtob::test::error_message;
using rtob::test::TemporaryFile;
using testing::HasSubstr;

namespace
{
std::string open_error(const std::string& text)
{
    const TemporaryFile file(".ini", text);
    const auto message = error_message([&] { (void)rtob::open_config(file.path()); });
    EXPECT_THAT(message, HasSubstr(file.path()));
    return message;
}
}  // namespace

TEST(OpenConfig, RefusesWhatIsNoReadableFile)
{
    const auto error_of = [](const std::string& path)
    { return error_message([&] { (void)rtob::open_config(path); }); };
    EXPECT_THAT(error_of("/nowhere/x.ini"), HasSubstr("/nowhere/x.ini does not exist"));
    EXPECT_THAT(error_of(testing::TempDir()), HasSubstr("is not a regular file"));
}

TEST(OpenConfig, AcceptsWhatMrptReads)
{
    const TemporaryFile file(
        ".ini",
        "\xEF\xBB\xBF; head\r\n@define N 3\r\n// a comment = here\r\n[A] // first\r\n\r\n"
        "n = ${N} # three\r\nlabel = front \\\r\n laser\r\n// m = 1\r\n# end");
    const auto config = rtob::open_config(file.path());
    EXPECT_THAT(rtob::config_keys(config, "A"), testing::UnorderedElementsAre("n", "label"));
    EXPECT_EQ(rtob::config_value(config, "A", "n"), "3");
    EXPECT_EQ(rtob::config_name(config), file.path());
}

TEST(OpenConfig, NamesTheLineThatMrptWouldSkip)
{
    EXPECT_THAT(open_error("[A]\nx = 1\nnonsense\n"), HasSubstr("line 3: 'nonsense' is neither"));
    EXPECT_THAT(open_error("[A\nx = 1\n"), HasSubstr("line 1: '[A' lacks its closing ']'"));
    EXPECT_THAT(open_error("[A]\n= 1\n"), HasSubstr("line 2: '= 1' lacks the key"));
    EXPECT_THAT(open_error("x = 1\n[A]\n"), HasSubstr("line 1: key 'x' stands before the first"));
    EXPECT_THAT(open_error("[]\n"), HasSubstr("line 1: a section without a name"));
    EXPECT_THAT(open_error("[A] x = 1\n"), HasSubstr("line 1: text after the section's ']'"));
}

TEST(OpenConfig, RefusesAKeyThatIsSetTwice)
{
    EXPECT_THAT(
        open_error("[A]\nx = 1\n[B]\nx = 2\n[a]\nX = 3\n"),
        HasSubstr("line 6: key 'X' of section [a] was set already in line 2"));
}

TEST(CheckSections, RefusesAnUnknownSectionAndSuggestsTheNearest)
{
    const CConfigFileMemory config(std::string("// c = d\n[Probe]\nx=1\n[Filtr]\ny=1\n"));
    EXPECT_NO_THROW(rtob::check_sections(config, {"Filtr", "Probe", "Slam"}));
    EXPECT_THAT(
        error_message(
            [&] {
                rtob::check_sections(config, {"Filter", "Probe"});
            }),
        HasSubstr("unknown section [Filtr]; did you mean 'Filter'?"));
}
