// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "compare/child_process.h"
#include "error_message.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

class RunChild : public testing::Test
{
 protected:
    [[nodiscard]] std::string shell(const std::string& script) const
    {
        return run_child("/bin/sh", {"-c", script}, folder_.file("console.txt"));
    }
    TemporaryFolder folder_;
};

TEST_F(RunChild, ReturnsNothingOfASuccess)
{
    EXPECT_EQ(shell("echo to out; echo 'rtob-slam: no failure' >&2"), "");
    EXPECT_EQ(file_content(folder_.file("console.txt")), "to out\nrtob-slam: no failure\n");
}

TEST_F(RunChild, ReturnsTheLastMessageOfAFailure)
{
    EXPECT_EQ(
        shell("echo rtob-slam: first; echo noise; echo 'rtob-slam: the log\nis torn'; exit 1"),
        "the log\nis torn");
}

TEST_F(RunChild, NamesTheExitCodeOfASilentFailure)
{
    EXPECT_THAT(shell("exit 7"), HasSubstr("exit code 7"));
}

TEST_F(RunChild, NamesTheSignalOfACrash)
{
    EXPECT_THAT(shell("kill -SEGV $$"), HasSubstr("signal 11 (Segmentation fault)"));
}

TEST_F(RunChild, HasEmptyInput)
{
    EXPECT_EQ(shell("read line && exit 1; exit 0"), "");
}

TEST_F(RunChild, RefusesAProgramThatIsNotThere)
{
    const auto message = error_message(
        [&] {
            static_cast<void>(run_child(folder_.file("nothing"), {}, folder_.file("console.txt")));
        });
    EXPECT_THAT(message, HasSubstr("nothing cannot be started: No such file"));
}
}  // namespace
}  // namespace rtob::test
