// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "temporary_folder.h"

namespace rtob::test
{
/// How a program ended and what it said.
struct ProgramResult
{
    int exit_code = -1;  ///< -1: killed by a signal
    std::string out, err;
};

/// A program that runs beside the test; stdin is empty.
class RunningProgram
{
 public:
    RunningProgram(const std::string& program, const std::vector<std::string>& arguments)
        : folder_("_program")
    {
        std::vector<char*> argv{const_cast<char*>(program.c_str())};
        for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        const std::string out = folder_.file("out"), err = folder_.file("err");
        pid_ = fork();
        if (pid_ != 0) return;
        signal(SIGINT, SIG_DFL);  // a shell's background job ignores it, and so would its children
        open_as(STDIN_FILENO, "/dev/null", O_RDONLY);
        open_as(STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
        open_as(STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
        execv(argv[0], argv.data());
        _exit(127);
    }
    ~RunningProgram()
    {
        if (pid_ <= 0) return;
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    [[nodiscard]] pid_t id() const { return pid_; }
    void send(int signal) const { kill(pid_, signal); }

    ProgramResult wait()
    {
        int status = 0;
        waitpid(pid_, &status, 0);
        pid_ = -1;
        return {
            WIFEXITED(status) ? WEXITSTATUS(status) : -1, file_content(folder_.file("out")),
            file_content(folder_.file("err"))};
    }

 private:
    static void open_as(int descriptor, const char* file, int flags)
    {
        const int opened = open(file, flags, 0600);
        dup2(opened, descriptor);
        close(opened);
    }

    TemporaryFolder folder_;
    pid_t pid_ = -1;
};

inline ProgramResult run_program(
    const std::string& program, const std::vector<std::string>& arguments)
{
    return RunningProgram(program, arguments).wait();
}
}  // namespace rtob::test
