// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/io/atomic_file.h>

#include <filesystem>
#include <iterator>

#include "error_message.h"
#include "temporary_file.h"

namespace rtob::test
{
namespace
{
std::string content_of(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(AtomicFile, ReplacesTheOldFileAtCommitOnly)
{
    const TemporaryFile file(".txt", "old");
    AtomicFile out(file.path());
    out.stream() << "new";
    out.stream().flush();
    EXPECT_EQ(content_of(file.path()), "old");
    out.commit();
    EXPECT_EQ(content_of(file.path()), "new");
    EXPECT_FALSE(std::filesystem::exists(file.path() + ".part"));
}

TEST(AtomicFile, LeavesNothingBehindWithoutCommit)
{
    const TemporaryFile file(".txt");
    {
        AtomicFile out(file.path());
        out.stream() << "half";
    }
    EXPECT_FALSE(std::filesystem::exists(file.path()));
    EXPECT_FALSE(std::filesystem::exists(file.path() + ".part"));
}

TEST(AtomicFile, NamesTheFileThatCannotBeWritten)
{
    const auto in_no_folder = error_message([] { AtomicFile("/nowhere/map.pgm"); });
    EXPECT_THAT(in_no_folder, testing::HasSubstr("/nowhere/map.pgm"));
    EXPECT_THAT(in_no_folder, testing::HasSubstr("No such file"));
}

TEST(AtomicFile, TellsAFullDisk)
{
    // Every write to a part file that is a link to /dev/full fails as on a full disk.
    const TemporaryFile file(".txt");
    std::filesystem::create_symlink("/dev/full", file.path() + ".part");
    const auto error = error_message(
        [&]
        {
            AtomicFile out(file.path());
            out.stream() << "does not fit";
            out.commit();
        });
    EXPECT_THAT(error, testing::HasSubstr("No space left"));
    EXPECT_FALSE(std::filesystem::exists(file.path()));
}
}  // namespace
}  // namespace rtob::test
