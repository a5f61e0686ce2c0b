// SPDX-License-Identifier: BSD-3-Clause
#include "compare/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace rtob
{
namespace
{
/// Where a child's input and output go.
class Redirections
{
 public:
    explicit Redirections(const std::string& console_file)
    {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(
            &actions_, STDOUT_FILENO, console_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    }
    ~Redirections() { posix_spawn_file_actions_destroy(&actions_); }
    Redirections(const Redirections&) = delete;
    Redirections& operator=(const Redirections&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
    posix_spawn_file_actions_t actions_{};
};

std::string last_message(const std::string& console_file)
{
    constexpr const char* mark = "rtob-slam: ";
    std::ifstream in(console_file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto begin = text.rfind(mark);
    if (begin == std::string::npos) return {};
    const auto end = text.find_last_not_of(" \n");
    return text.substr(begin + std::strlen(mark), end + 1 - begin - std::strlen(mark));
}

std::string failure_of(int status, const std::string& console_file)
{
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
    if (WIFSIGNALED(status))
        return "crashed: signal " + std::to_string(WTERMSIG(status)) + " (" +
               strsignal(WTERMSIG(status)) + "); its last words are in console.txt";
    const std::string message = last_message(console_file);
    return message.empty() ? "ended with exit code " + std::to_string(WEXITSTATUS(status)) +
                                 "; its last words are in console.txt"
                           : message;
}
}  // namespace

std::string run_child(
    const std::string& program, const std::vector<std::string>& arguments,
    const std::string& console_file)
{
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const Redirections redirections(console_file);
    pid_t child = 0;
    const int error =
        posix_spawn(&child, program.c_str(), redirections.get(), nullptr, argv.data(), environ);
    if (error != 0)
        throw std::runtime_error(program + " cannot be started: " + std::strerror(error));
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            throw std::runtime_error(program + " was lost: " + std::strerror(errno));
    return failure_of(status, console_file);
}

void end_with_parent()
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
}

std::string own_program()
{
    return std::filesystem::read_symlink("/proc/self/exe");
}
}  // namespace rtob
