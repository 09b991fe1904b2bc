// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/bench/slice/measure.hpp"

extern char** environ;

namespace psicarve::bench {

/// A command and what its runs cost.
struct Cost {
    std::string name;
    std::vector<std::string> command;
    std::vector<double> cpu_s;
    std::vector<double> wall_s;
    double peak_mb = 0.0;
    bool failed = false;
};

/// Runs the command, what it prints thrown away, and adds what it cost. The parent stays small: a child's
/// peak begins with its parent's.
inline void run(Cost& cost, bool is_silent = false) {
    std::vector<char*> arguments;
    for (std::string& word : cost.command) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", 1, 0);
    if (is_silent) ::posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", 1, 0);
    const double begin = wall_s();
    ::pid_t child = 0;
    cost.failed = ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ) != 0;
    ::posix_spawn_file_actions_destroy(&actions);
    if (cost.failed) return;
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    cost.wall_s.push_back(wall_s() - begin);
    cost.cpu_s.push_back(seconds(usage.ru_utime) + seconds(usage.ru_stime));
    cost.peak_mb = std::max(cost.peak_mb, static_cast<double>(usage.ru_maxrss) / 1024.0);
    cost.failed = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
}

}  // namespace psicarve::bench
