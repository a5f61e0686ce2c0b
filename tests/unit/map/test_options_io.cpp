// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <rtob/core/option_checks.h>
#include <rtob/map/options_io.h>

#include "error_message.h"
#include "temporary_file.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <utility>

using mrpt::config::CConfigFileMemory;
using rtob::test::error_message;
using rtob::test::TemporaryFile;
using testing::HasSubstr;

namespace
{
enum class Colour
{
    Red,
    DarkBlue
};

constexpr auto enum_names(Colour)
{
    return std::array<std::pair<Colour, std::string_view>, 2>{
        {{Colour::Red, "red"}, {Colour::DarkBlue, "dark_blue"}}};
}

struct ProbeOptions
{
    double max_distance_m = 0.5;
    float gain = 0.1f;
    int iterations = 30;
    unsigned count = 7;
    std::uint64_t seed = 1;
    bool is_on = true;
    std::string label = "laser";
    Colour colour = Colour::Red;

    template <class Self, class Visit>
    static void fields(Self& s, Visit&& visit)
    {
        visit("max_distance_m", s.max_distance_m, "drop farther pairs; > 0");
        visit("gain", s.gain, "a|b");
        visit("iterations", s.iterations, ">= 1");
        visit("count", s.count, "any");
        visit("seed", s.seed, "any");
        visit("is_on", s.is_on, "whether");
        visit("label", s.label, "which sensor");
        visit("colour", s.colour, "of the line");
    }
    void validate() const
    {
        rtob::require(max_distance_m > 0, "max_distance_m", max_distance_m, "> 0");
    }
};

ProbeOptions loaded(const std::string& body)
{
    CConfigFileMemory config(std::string("[Probe]\n") + body);
    ProbeOptions options;
    rtob::load_options(config, "Probe", options);
    return options;
}

std::string load_error(const std::string& body)
{
    return error_message([&] { (void)loaded(body); });
}

template <class Number>
bool same_bits(Number a, Number b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}
}  // namespace

TEST(LoadOptions, AnEmptySectionKeepsTheDefaults)
{
    const auto options = loaded("");
    EXPECT_EQ(options.max_distance_m, 0.5);
    EXPECT_EQ(options.label, "laser");
    EXPECT_EQ(options.colour, Colour::Red);
}

TEST(LoadOptions, ReadsEveryTypeOfField)
{
    const auto options = loaded(
        "max_distance_m = 1.25e-1\ngain=+2\niterations = -3\ncount = 4294967295\n"
        "seed = 18446744073709551615\nis_on = No\nlabel = front laser\ncolour = dark_blue\n");
    EXPECT_EQ(options.max_distance_m, 0.125);
    EXPECT_EQ(options.gain, 2.0f);
    EXPECT_EQ(options.iterations, -3);
    EXPECT_EQ(options.count, 4294967295u);
    EXPECT_EQ(options.seed, std::numeric_limits<std::uint64_t>::max());
    EXPECT_FALSE(options.is_on);
    EXPECT_EQ(options.label, "front laser");
    EXPECT_EQ(options.colour, Colour::DarkBlue);
}

TEST(LoadOptions, CommentsAfterValuesAreNotPartOfThem)
{
    const auto options = loaded(
        "max_distance_m = 2  // metres\niterations = 4 # few\ncount = 5\t; some\n"
        "label = a#b//c;d\n// seed = 9\n# seed = 8\n; seed = 7\n");
    EXPECT_EQ(options.max_distance_m, 2);
    EXPECT_EQ(options.iterations, 4);
    EXPECT_EQ(options.count, 5u);
    EXPECT_EQ(options.label, "a#b//c;d");
    EXPECT_EQ(options.seed, 1u);
}

TEST(LoadOptions, RefusesMalformedValues)
{
    for (const char* line :
         {"max_distance_m = abc",
          "max_distance_m = 1x",
          "max_distance_m = 1,5",
          "gain = nan",
          "max_distance_m =",
          "max_distance_m = 1 2",
          "max_distance_m = 1e999",
          "gain = 0x10",
          "gain = +-1",
          "iterations = 1.5",
          "iterations = 1e3",
          "iterations = 2147483648",
          "count = -1",
          "count = 4294967296",
          "seed = -1",
          "seed = 18446744073709551616",
          "is_on = yess",
          "is_on = 2",
          "is_on =",
          "colour = Red",
          "colour = 0",
          "colour ="})
    {
        SCOPED_TRACE(line);
        const std::string text = line;
        const auto message = load_error(text);
        EXPECT_THAT(message, HasSubstr("section [Probe], key " + text.substr(0, text.find(' '))));
        EXPECT_THAT(
            message,
            HasSubstr("'" + text.substr(std::min(text.size(), text.find('=') + 2)) + "' is not"));
    }
}

TEST(LoadOptions, SaysWhatIsAllowed)
{
    EXPECT_THAT(load_error("is_on = yess"), HasSubstr("true, false, yes, no, on, off, 1, 0"));
    EXPECT_THAT(load_error("colour = dark"), HasSubstr("one of: red, dark_blue"));
    EXPECT_THAT(load_error("colour = dark_bleu"), HasSubstr("did you mean 'dark_blue'?"));
}

TEST(LoadOptions, RefusesAnUnknownKeyAndSuggestsTheNearest)
{
    EXPECT_THAT(
        load_error("max_distnace_m = 1"),
        HasSubstr("unknown key 'max_distnace_m'; did you mean 'max_distance_m'?"));
    EXPECT_THAT(load_error("Seed = 1"), HasSubstr("did you mean 'seed'?"));
    EXPECT_THAT(load_error("zzzzzzzz = 1"), HasSubstr("known: max_distance_m, gain"));
}

TEST(LoadOptions, ValidatesAndNamesTheFile)
{
    const TemporaryFile file(".ini", "[Probe]\nmax_distance_m = -1\n");
    const auto config = rtob::open_config(file.path());
    ProbeOptions options;
    const auto message = error_message([&] { rtob::load_options(config, "Probe", options); });
    EXPECT_THAT(
        message, HasSubstr(file.path() + ", section [Probe], max_distance_m = -1 is out of range"));
}

TEST(LoadOptions, LeavesTheOptionsAloneWhenItThrows)
{
    CConfigFileMemory config(std::string("[Probe]\ncount = 9\nmax_distance_m = -1\n"));
    ProbeOptions options;
    EXPECT_THROW(rtob::load_options(config, "Probe", options), std::runtime_error);
    EXPECT_EQ(options.count, 7u);
    EXPECT_EQ(options.max_distance_m, 0.5);
}

TEST(SaveOptions, AFileRoundTripIsExactToTheBit)
{
    ProbeOptions saved;
    saved.gain = 1.0f / 3;
    saved.iterations = std::numeric_limits<int>::min();
    saved.count = std::numeric_limits<unsigned>::max();
    saved.seed = std::numeric_limits<std::uint64_t>::max();
    saved.is_on = false;
    saved.label = "front laser#2";
    saved.colour = Colour::DarkBlue;
    for (const double value :
         {1.0 / 3, 0.1, 1e-300, std::nextafter(1.0, 2.0), std::numeric_limits<double>::max(),
          std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::infinity()})
    {
        saved.max_distance_m = value;
        std::ostringstream text;
        rtob::save_options(text, "Probe", saved);
        const TemporaryFile file(".ini", text.str());
        ProbeOptions read;
        rtob::load_options(rtob::open_config(file.path()), "Probe", read);
        EXPECT_TRUE(same_bits(read.max_distance_m, value)) << text.str();
        EXPECT_TRUE(same_bits(read.gain, saved.gain));
        EXPECT_EQ(read.iterations, saved.iterations);
        EXPECT_EQ(read.count, saved.count);
        EXPECT_EQ(read.seed, saved.seed);
        EXPECT_EQ(read.is_on, saved.is_on);
        EXPECT_EQ(read.label, saved.label);
        EXPECT_EQ(read.colour, saved.colour);
    }
}

TEST(SaveOptions, AnEmptyTextSurvivesTheRoundTrip)
{
    ProbeOptions saved;
    saved.label = "";
    std::ostringstream text;
    rtob::save_options(text, "Probe", saved);
    const TemporaryFile file(".ini", text.str());
    ProbeOptions read;
    rtob::load_options(rtob::open_config(file.path()), "Probe", read);
    EXPECT_EQ(read.label, "");
}

TEST(SaveOptions, WritesTheDocAboveEachKey)
{
    std::ostringstream text;
    rtob::save_options(text, "Probe", ProbeOptions{});
    EXPECT_THAT(
        text.str(),
        testing::StartsWith(
            "[Probe]\n# drop farther pairs; > 0\nmax_distance_m = 0.5\n# a|b\ngain = 0.1\n"));
    EXPECT_THAT(text.str(), HasSubstr("# of the line; one of: red, dark_blue\ncolour = red\n"));
}

TEST(SaveOptions, RefusesATextThatWouldNotComeBack)
{
    for (const char* label :
         {"a // b", "a #b", "# a", "a ;b", " a", "a ", "a\nb", "${HOME}", "a\\"})
    {
        SCOPED_TRACE(label);
        ProbeOptions options;
        options.label = label;
        std::ostringstream text;
        EXPECT_THROW(rtob::save_options(text, "Probe", options), std::invalid_argument);
    }
}

TEST(SetOption, SetsOneFieldByName)
{
    ProbeOptions options;
    rtob::set_option(options, "iterations", "12");
    rtob::set_option(options, "colour", "dark_blue");
    EXPECT_EQ(options.iterations, 12);
    EXPECT_EQ(options.colour, Colour::DarkBlue);
    EXPECT_EQ(options.max_distance_m, 0.5);
}

TEST(SetOption, NamesTheKeyItRefuses)
{
    ProbeOptions options;
    using Error = std::invalid_argument;
    EXPECT_THAT(
        error_message<Error>([&] { rtob::set_option(options, "itertions", "1"); }),
        HasSubstr("unknown key 'itertions'; did you mean 'iterations'?"));
    EXPECT_THAT(
        error_message<Error>([&] { rtob::set_option(options, "count", "many"); }),
        HasSubstr("key count: 'many' is not a whole number from 0"));
}

TEST(OptionsMarkdown, HasOneRowPerField)
{
    const auto text = rtob::options_markdown("Probe", ProbeOptions{});
    EXPECT_THAT(text, testing::StartsWith("## [Probe]\n\n| key | default | meaning, range |\n"));
    EXPECT_THAT(text, HasSubstr("| `max_distance_m` | `0.5` | drop farther pairs; > 0 |\n"));
    EXPECT_THAT(text, HasSubstr("| `gain` | `0.1` | a\\|b |\n"));
    EXPECT_THAT(text, HasSubstr("| `colour` | `red` | of the line; one of: red, dark_blue |\n"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4 + 8);  // heading, table head, 8 fields
}
