// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <rtob/io/text_file.h>

#include <filesystem>

#include "log_files.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
std::string written(const TemporaryFolder& folder, const std::string& name)
{
    TextFile file(folder.file(name));
    file.stream() << "line " << 12345 << "\n";
    file.commit();
    return file_content(folder.file(name));
}

TEST(TextFile, IsPackedAsItsNameSays)
{
    const TemporaryFolder folder;
    const std::string text = "line 12345\n";
    EXPECT_EQ(written(folder, "a.log"), text);
    EXPECT_EQ(written(folder, "a.log.gz"), gzip(text));
    EXPECT_EQ(written(folder, "a.log.bz2"), bzip2(text));
}

TEST(TextFile, LeavesNothingBehindWithoutCommit)
{
    const TemporaryFolder folder;
    {
        TextFile file(folder.file("a.log.gz"));
        file.stream() << "half a file";
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}
}  // namespace
}  // namespace rtob::test
