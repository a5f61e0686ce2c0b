// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/ptrace.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "program.h"

namespace rtob::test
{
/// One thread of a child process hangs for as long as this lives; all others go on. It is held from
/// outside, as a debugger does it, wherever it happens to be.
class HeldThread
{
 public:
    /// Throws std::runtime_error where there is no such thread, or the system does not allow it.
    HeldThread(pid_t process, const std::string& name) : thread_(find(process, name))
    {
        if (ptrace(PTRACE_SEIZE, thread_, nullptr, nullptr) != 0) fail("seized");
        if (ptrace(PTRACE_INTERRUPT, thread_, nullptr, nullptr) != 0) fail("interrupted");
        if (waitpid(thread_, nullptr, __WALL) != thread_) fail("waited for");
    }
    ~HeldThread() { ptrace(PTRACE_DETACH, thread_, nullptr, nullptr); }
    HeldThread(const HeldThread&) = delete;
    HeldThread& operator=(const HeldThread&) = delete;

 private:
    static pid_t find(pid_t process, const std::string& name)
    {
        const auto threads = "/proc/" + std::to_string(process) + "/task";
        for (const auto& thread : std::filesystem::directory_iterator(threads))
            if (file_content(thread.path() / "comm") == name + "\n")
                return std::stoi(thread.path().filename());
        throw std::runtime_error("no thread is called " + name);
    }
    [[noreturn]] static void fail(const std::string& what)
    {
        throw std::runtime_error("the thread cannot be " + what + ": " + std::strerror(errno));
    }

    pid_t thread_;
};

/// Some containers forbid it.
inline bool may_hold_threads()
{
    const RunningProgram sleeper("/bin/sleep", {"60"});
    return ptrace(PTRACE_SEIZE, sleeper.id(), nullptr, nullptr) == 0;
}
}  // namespace rtob::test
