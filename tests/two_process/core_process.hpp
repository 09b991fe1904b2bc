// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/places.hpp"
#include "tests/shared/child_signals.hpp"

namespace psicarve::two_process {

/// A real psicarve-rtcore, started by a test and gone when the object is.
class CoreProcess {
public:
    /// `leads_group`: of processes, as whatever a shell starts.
    explicit CoreProcess(const std::vector<std::string>& arguments,
                         const std::string& error_path = "/dev/null", bool leads_group = false) {
        std::vector<std::string> words{in_build("bin/psicarve-rtcore")};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<char*> pointers;
        pointers.reserve(words.size() + 1);
        for (std::string& word : words) pointers.push_back(word.data());
        pointers.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, error_path.c_str(),
                                         O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        sigset_t default_signals;
        sigemptyset(&default_signals);
        for (const int number : test::kSignalsToTake) sigaddset(&default_signals, number);
        posix_spawnattr_setsigdefault(&attributes, &default_signals);
        posix_spawnattr_setflags(&attributes, static_cast<short>(POSIX_SPAWN_SETSIGDEF |
                                                                 (leads_group ? POSIX_SPAWN_SETPGROUP : 0)));
        if (posix_spawn(&pid_, words[0].c_str(), &actions, &attributes, pointers.data(), environ) != 0)
            pid_ = -1;
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&actions);
    }
    CoreProcess(const CoreProcess&) = delete;
    CoreProcess& operator=(const CoreProcess&) = delete;
    ~CoreProcess() {
        if (pid_ > 0 && !exit_status_) {
            kill(pid_, SIGKILL);
            wait_for_exit();
        }
    }

    pid_t pid() const noexcept { return pid_; }
    void send_signal(int number) const { kill(pid_, number); }

    /// Exit code, or 128 + signal.
    int wait_for_exit() {
        int status = 0;
        if (!exit_status_ && waitpid(pid_, &status, 0) == pid_) {
            exit_status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
        return exit_status_.value_or(-1);
    }

private:
    pid_t pid_ = -1;
    std::optional<int> exit_status_;
};

/// Whole, or as far as it can be read.
inline std::string text_of(const std::string& path) {
    std::ifstream file{path, std::ios::binary};
    // What is read of a process that ends meanwhile fails, and would be thrown out of an iterator.
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace psicarve::two_process
