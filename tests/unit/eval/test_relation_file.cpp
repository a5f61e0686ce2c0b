// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rtob/eval/relations.h>

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cstdlib>
#include <sstream>

#include "error_message.h"
#include "temporary_file.h"

using rtob::read_relations;
using rtob::test::error_message;
using rtob::test::TemporaryFile;
using testing::HasSubstr;

namespace
{
std::string gzipped(const std::string& text)
{
    std::istringstream plain(text);
    boost::iostreams::filtering_istream packing;
    packing.push(boost::iostreams::gzip_compressor());
    packing.push(plain);
    std::ostringstream packed;
    boost::iostreams::copy(packing, packed);
    return packed.str();
}

std::string read_error(const std::string& bytes)
{
    const TemporaryFile file(".relations", bytes);
    const auto message = error_message([&] { (void)read_relations(file.path()); });
    EXPECT_THAT(message, HasSubstr(file.path()));
    return message;
}

const std::string two_lines =
    "976052905.167303 976052911.885496 -0.05 -0.5 0.0 0.0 0.0 -1.5\n"
    "1 2 3.25 4 0 0 0 0.5\n";

void expect_two_relations(const std::string& bytes)
{
    const TemporaryFile file(".relations", bytes);
    const auto relations = read_relations(file.path());
    ASSERT_EQ(relations.size(), 2u);
    EXPECT_EQ(relations[0].t1_s, 976052905.167303);
    EXPECT_EQ(relations[0].t2_s, 976052911.885496);
    EXPECT_EQ(relations[0].pose_1_2.x, -0.05);
    EXPECT_EQ(relations[0].pose_1_2.y, -0.5);
    EXPECT_EQ(relations[0].pose_1_2.yaw, -1.5);
    EXPECT_EQ(relations[1].pose_1_2.x, 3.25);
}
}  // namespace

TEST(ReadRelations, ReadsPlainText)
{
    expect_two_relations(two_lines);
}

TEST(ReadRelations, ReadsGzipWhateverTheNameSays)
{
    expect_two_relations(gzipped(two_lines));
}

TEST(ReadRelations, SkipsCommentsAndEmptyLines)
{
    expect_two_relations("# t1 t2 x y z roll pitch yaw\r\n\r\n  \n\t" + two_lines + "\n");
}

TEST(ReadRelations, WrapsTheYaw)
{
    const TemporaryFile file(".relations", "1 2 0 0 0 0 0 4\n");
    EXPECT_DOUBLE_EQ(
        read_relations(file.path()).at(0).pose_1_2.yaw, 4 - 2 * 3.14159265358979323846);
}

TEST(ReadRelations, NamesTheLineOfBadText)
{
    EXPECT_THAT(read_error("1 2 0 0 0 0 0\n"), HasSubstr("line 1: too few numbers"));
    EXPECT_THAT(read_error("\n1 2 0 0 0 0 0 0 9\n"), HasSubstr("line 2: more than 8 words"));
    for (const std::string bad : {"abc", "1x", "nan", "inf", "1e999", "0,5"})
        EXPECT_THAT(
            read_error(two_lines + "1 2 " + bad + " 0 0 0 0 0\n"),
            HasSubstr("line 3: '" + bad + "' is not a number"));
}

TEST(ReadRelations, RefusesMotionsOutOfThePlane)
{
    for (const char* line : {"1 2 0 0 0.1 0 0 0", "1 2 0 0 0 0.1 0 0", "1 2 0 0 0 0 0.1 0"})
        EXPECT_THAT(read_error(line), HasSubstr("line 1: z, roll and pitch must be 0"));
}

TEST(ReadRelations, RefusesAFileWithoutRelations)
{
    EXPECT_THAT(read_error(""), HasSubstr("missing, unreadable or empty"));
    EXPECT_THAT(read_error("# nothing\n"), HasSubstr("has no relations"));
    EXPECT_THAT(
        error_message([] { (void)read_relations("/nowhere/x"); }),
        HasSubstr("/nowhere/x is missing"));
    EXPECT_THAT(
        error_message([] { (void)read_relations(testing::TempDir()); }), HasSubstr("unreadable"));
}

TEST(ReadRelations, RefusesDamagedGzip)
{
    std::string text;
    for (int i = 0; i < 2000; ++i) text += std::to_string(i * 977 % 1009) + " 2 3 4 0 0 0 0\n";
    const std::string packed = gzipped(text);
    EXPECT_NE(read_error(packed.substr(0, packed.size() / 2)), "");
    EXPECT_NE(read_error(packed.substr(0, packed.size() - 8)), "");  // checksum and length cut off
    std::string flipped = packed;
    flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 0x55);
    EXPECT_NE(read_error(flipped), "");
}

TEST(ReadRelations, ReadsThePublishedFiles)
{
    const char* const folder = std::getenv("RTOB_DATASETS");
    if (!folder) GTEST_SKIP() << "RTOB_DATASETS is not set";
    const auto count = [&](const std::string& name) {
        return read_relations(std::string(folder) + "/" + name + "/" + name + ".relations.gz")
            .size();
    };
    EXPECT_EQ(count("intel"), 2984u);
    EXPECT_EQ(count("fr079"), 1685u);
    EXPECT_EQ(count("mit-killian"), 4677u);
}
