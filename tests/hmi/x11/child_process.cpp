// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/x11/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "tests/two_process/core_rig.hpp"

namespace psicarve::test {
namespace {

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Ours, with these in front: the first of a name counts.
std::vector<std::string> with_ours(std::vector<std::string> environment) {
    const std::size_t added = environment.size();
    for (char** ours = environ; *ours != nullptr; ++ours) {
        const std::string entry{*ours};
        const std::string name = entry.substr(0, entry.find('=') + 1);
        const auto end = environment.begin() + static_cast<std::ptrdiff_t>(added);
        const bool is_replaced = std::any_of(environment.begin(), end, [&name](const std::string& mine) {
            return mine.compare(0, name.size(), name) == 0;
        });
        if (!is_replaced) environment.push_back(entry);
    }
    return environment;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                           const std::string& error_path) {
    int to_child[2] = {-1, -1};
    int from_child[2] = {-1, -1};
    if (pipe2(to_child, O_CLOEXEC) != 0 || pipe2(from_child, O_CLOEXEC) != 0) return;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, to_child[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, from_child[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, error_path.c_str(),
                                     O_WRONLY | O_CREAT | O_APPEND, 0600);
    // A shell has what it runs in the background ignore them, and a program that begins so leaves them
    // ignored.
    sigset_t heard;
    sigemptyset(&heard);
    for (const int number : {SIGINT, SIGHUP, SIGQUIT}) sigaddset(&heard, number);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &heard);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    auto all_words = words;
    auto all_environment = with_ours(environment);
    if (posix_spawnp(&pid_, words[0].c_str(), &actions, &attributes, pointers_to(all_words).data(),
                     pointers_to(all_environment).data()) != 0)
        pid_ = -1;
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    close(to_child[0]);
    close(from_child[1]);
    to_ = to_child[1];
    from_ = from_child[0];
}

ChildProcess::~ChildProcess() {
    kill_now();
    close(to_);
    close(from_);
}

void ChildProcess::write_line(const std::string& line) const {
    const std::string text = line + "\n";
    [[maybe_unused]] const auto written = ::write(to_, text.data(), text.size());
}

std::string ChildProcess::read_line() {
    for (std::size_t end = rest_.find('\n'); true; end = rest_.find('\n')) {
        if (end != std::string::npos) {
            const std::string line = rest_.substr(0, end);
            rest_.erase(0, end + 1);
            return line;
        }
        pollfd ready{from_, POLLIN, 0};
        if (poll(&ready, 1, static_cast<int>(two_process::kLimit.count())) <= 0) return {};
        std::array<char, 4096> block{};
        const auto count = ::read(from_, block.data(), block.size());
        if (count <= 0) return {};
        rest_.append(block.data(), static_cast<std::size_t>(count));
    }
}

void ChildProcess::send_signal(int number) const {
    if (pid_ > 0) ::kill(pid_, number);
}

void ChildProcess::kill_now() {
    if (pid_ > 0) ::kill(pid_, SIGKILL);
    wait();
}

int ChildProcess::wait() {
    int status = 0;
    if (pid_ <= 0 || waitpid(pid_, &status, 0) != pid_) return -1;
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int run_to_end(const std::vector<std::string>& words, const std::vector<std::string>& environment) {
    return ChildProcess{words, environment, "/dev/null"}.wait();
}

}  // namespace psicarve::test
