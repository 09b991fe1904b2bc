// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/replay/recorded_job.hpp"

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

/// In place of an error's code: success.
constexpr char kDone = '+';

/// Runs in the process of its own, which does not outlive the core: sends a code and an error's words, or
/// kDone.
[[noreturn]] void publish_and_tell(Segment& segment, std::span<const std::byte> job_blob, int to_core,
                                   pid_t core) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != core) _exit(1);
    const auto published = publish_job(segment, job_blob);
    const std::string told = published
                                 ? std::string{kDone}
                                 : static_cast<char>(published.error().code) + published.error().message;
    _exit(write(to_core, told.data(), told.size()) == static_cast<ssize_t>(told.size()) ? 0 : 1);
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
    const pid_t core = getpid();
    const pid_t publisher = fork();
    if (publisher == 0) publish_and_tell(segment, job_blob, ends[1], core);
    const int fork_error = errno;
    close(ends[1]);
    const std::string told = publisher > 0 ? all_of(ends[0]) : std::string{};
    close(ends[0]);
    if (publisher < 0) return cannot_publish(std::generic_category().message(fork_error));
    while (waitpid(publisher, nullptr, 0) < 0 && errno == EINTR) {
    }
    if (told.empty()) return cannot_publish("its publisher was ended");
    if (told.front() == kDone) return {};
    return Error{static_cast<ErrorCode>(told.front()), told.substr(1)};
}

}  // namespace psicarve::supervisor
