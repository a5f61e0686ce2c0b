// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "compare/child_process.h"
#include "error_message.h"
#include "temporary_folder.h"

namespace rtob::test
{
namespace
{
using testing::HasSubstr;

ssize_t read_byte(int from)
{
    char byte = 0;
    return read(from, &byte, 1);
}
void write_byte(int to)
{
    const char byte = 0;
    if (write(to, &byte, 1) != 1) _exit(1);
}

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

TEST(EndWithParent, NobodyOutlivesTheOneThatStartedIt)
{
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t parent = fork();
    if (parent == 0)
    {
        if (fork() == 0)
        {
            end_with_parent();
            write_byte(ends[1]);
            pause();
        }
        pause();
    }
    close(ends[1]);
    read_byte(ends[0]);  // the grandchild waits now, and holds the last end to write into
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    EXPECT_EQ(read_byte(ends[0]), 0);  // closed: it has ended
    close(ends[0]);
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
