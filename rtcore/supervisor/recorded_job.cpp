// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/recorded_job.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>

namespace psicarve::supervisor {
namespace {

Error cannot_publish(const std::string& reason) {
    return Error{ErrorCode::machine_refused, "the recorded job cannot be published: " + reason};
}

/// In the process of its own: nothing written means that it is done.
[[noreturn]] void publish_and_tell(Segment& segment, std::span<const std::byte> job_blob, int to_core) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (const auto published = publish_job(segment, job_blob); !published) {
        const auto code = static_cast<char>(published.error().code);
        const std::string told = code + published.error().message;
        _exit(write(to_core, told.data(), told.size()) == static_cast<ssize_t>(told.size()) ? 0 : 1);
    }
    _exit(0);
}

std::string all_of(int descriptor) {
    std::string text;
    std::array<char, 512> part;
    for (;;) {
        const ssize_t count = read(descriptor, part.data(), part.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        text.append(part.data(), static_cast<std::size_t>(count));
    }
}

}  // namespace

Result<void> publish_recorded_job(Segment& segment, std::span<const std::byte> job_blob) {
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return cannot_publish(std::generic_category().message(errno));
    const pid_t publisher = fork();
    if (publisher == 0) publish_and_tell(segment, job_blob, ends[1]);
    const int fork_error = errno;
    close(ends[1]);
    const std::string told = publisher > 0 ? all_of(ends[0]) : std::string{};
    close(ends[0]);
    if (publisher < 0) return cannot_publish(std::generic_category().message(fork_error));
    int status = 0;
    while (waitpid(publisher, &status, 0) < 0 && errno == EINTR) {
    }
    if (!told.empty()) return Error{static_cast<ErrorCode>(told.front()), told.substr(1)};
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return cannot_publish("its publisher was ended");
    return {};
}

}  // namespace psicarve::supervisor
