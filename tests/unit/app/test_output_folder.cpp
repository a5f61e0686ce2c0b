// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "error_message.h"
#include "run/output_folder.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

TEST(DefaultOutputFolder, IsNamedAfterTheLogWithoutItsEndings)
{
    EXPECT_EQ(default_output_folder("/data/intel.clf.bz2"), "out/intel");
    EXPECT_EQ(default_output_folder("exp1.norm.clf.gz"), "out/exp1");
    EXPECT_EQ(default_output_folder("../a b.rawlog"), "out/a b");
    EXPECT_EQ(default_output_folder("v1.2.log"), "out/v1.2");
    EXPECT_EQ(default_output_folder("folder/"), "out/run");
}

TEST(OutputFolder, TouchesNothingBeforeItIsCreated)
{
    const TemporaryFolder parent;
    const OutputFolder folder(parent.file("a/b"), false);
    EXPECT_FALSE(std::filesystem::exists(parent.file("a")));
    folder.create();
    EXPECT_TRUE(std::filesystem::is_directory(parent.file("a/b")));
    EXPECT_EQ(folder.file("map.png"), parent.file("a/b/map.png"));
}

TEST(OutputFolder, TakesAnEmptyFolderAndRefusesAFullOne)
{
    const TemporaryFolder parent;
    EXPECT_NO_THROW(OutputFolder(parent.path(), false));
    parent.write("x", "");
    EXPECT_THAT(
        error_message([&] { OutputFolder(parent.path(), false); }),
        AllOf(HasSubstr(parent.path()), HasSubstr("-o"), HasSubstr("--overwrite")));
    EXPECT_NO_THROW(OutputFolder(parent.path(), true));
}

TEST(OutputFolder, RefusesAFile)
{
    const TemporaryFolder parent;
    const auto file = parent.write("x", "");
    for (const bool may_overwrite : {false, true})
        EXPECT_THAT(
            error_message([&] { OutputFolder(file, may_overwrite); }), HasSubstr("not a folder"));
}

TEST(OutputFolder, RemovesOldResultsOnly)
{
    const TemporaryFolder parent;
    parent.write("notes.txt", "mine");
    parent.write("map.simplemap", "old");
    OutputFolder(parent.path(), true).create();
    EXPECT_TRUE(std::filesystem::exists(parent.file("notes.txt")));
    EXPECT_FALSE(std::filesystem::exists(parent.file("map.simplemap")));
}
}  // namespace
}  // namespace rtob::test
