// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "convert/convert_target.h"
#include "error_message.h"
#include "usage_error.h"

namespace rtob::test
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

TEST(ConvertTarget, IsSaidByTheNamesEnd)
{
    EXPECT_EQ(convert_target("a.rawlog", ""), ConvertTarget::Rawlog);
    EXPECT_EQ(convert_target("a.b.log", ""), ConvertTarget::Carmen);
    EXPECT_EQ(convert_target("dir.tum/a.clf.bz2", ""), ConvertTarget::Carmen);
    EXPECT_EQ(convert_target("a.log.gz", ""), ConvertTarget::Carmen);
    EXPECT_EQ(convert_target("a.tum", ""), ConvertTarget::Tum);
}

TEST(ConvertTarget, IsSaidByTheFlagFirst)
{
    EXPECT_EQ(convert_target("a.tum", "rawlog"), ConvertTarget::Rawlog);
    EXPECT_EQ(convert_target("a", "carmen"), ConvertTarget::Carmen);
    EXPECT_EQ(convert_target("a.txt", "tum"), ConvertTarget::Tum);
}

TEST(ConvertTarget, SaysWhatIsPossibleWhereItIsUnclear)
{
    for (const char* name : {"a", "a.txt", "log", "a.gz", "a.rawlog.bz2", "a.log.zip"})
        EXPECT_THAT(
            error_message<UsageError>([&] { static_cast<void>(convert_target(name, "")); }),
            AllOf(
                HasSubstr(name), HasSubstr("*.rawlog"), HasSubstr("*.clf"), HasSubstr("*.tum"),
                HasSubstr("--to")))
            << name;
    EXPECT_THAT(
        error_message<UsageError>([] { static_cast<void>(convert_target("a.tum", "bag")); }),
        AllOf(HasSubstr("'bag'"), HasSubstr("carmen")));
}
}  // namespace
}  // namespace rtob::test
