// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/child_start.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <cstring>

namespace psicarve::machine {
namespace {

class SpawnSetup {
public:
    explicit SpawnSetup(const ChildStart& start) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, start.output, STDOUT_FILENO);
        if (start.errors) posix_spawn_file_actions_adddup2(&actions_, *start.errors, STDERR_FILENO);
        // Onto itself: that takes close-on-exec away.
        for (const int fd : start.inherited) posix_spawn_file_actions_adddup2(&actions_, fd, fd);
        posix_spawnattr_init(&attributes_);
        sigset_t all_by_default;
        sigset_t none_blocked;
        sigfillset(&all_by_default);
        sigemptyset(&none_blocked);
        posix_spawnattr_setsigdefault(&attributes_, &all_by_default);
        posix_spawnattr_setsigmask(&attributes_, &none_blocked);
        posix_spawnattr_setpgroup(&attributes_, 0);
        // A session's leader leads a group, too, and cannot be put into one.
        const int own = start.has_own_session ? POSIX_SPAWN_SETSID : POSIX_SPAWN_SETPGROUP;
        posix_spawnattr_setflags(&attributes_,
                                 static_cast<short>(POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | own));
    }
    ~SpawnSetup() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnSetup(const SpawnSetup&) = delete;
    SpawnSetup& operator=(const SpawnSetup&) = delete;

    int spawn(const std::vector<std::string>& arguments, pid_t& pid) const {
        std::vector<char*> argv;
        argv.reserve(arguments.size() + 1);
        // posix_spawn promises not to write to them.
        for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        return posix_spawn(&pid, argv[0], &actions_, &attributes_, argv.data(), environ);
    }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

}  // namespace

Result<pid_t> start_child(const ChildStart& start) {
    pid_t pid = -1;
    const int error = SpawnSetup{start}.spawn(start.arguments, pid);
    if (error == 0) return pid;
    return Error{ErrorCode::no_core, start.arguments[0] + ": cannot be started: " + std::strerror(error)};
}

}  // namespace psicarve::machine
