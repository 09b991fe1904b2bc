// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/private_segment.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <string_view>

#include "shared/segment.hpp"

namespace psicarve::machine {
namespace {

constexpr std::string_view kPrefix = "psicarve-private-";

bool is_alive(pid_t pid) {
    return kill(pid, 0) == 0 || errno != ESRCH;
}

}  // namespace

std::string private_segment_name() {
    return "/" + std::string{kPrefix} + std::to_string(getpid());
}

void remove_stale_private_segments() {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator{"/dev/shm", error}) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(kPrefix)) continue;
        pid_t pid = 0;
        const auto [end, problem] =
            std::from_chars(name.data() + kPrefix.size(), name.data() + name.size(), pid);
        const bool is_ours = problem == std::errc{} && end == name.data() + name.size() && pid > 0;
        // One of another user's cannot be removed, and is not.
        if (is_ours && !is_alive(pid)) (void)Segment::remove("/" + name);
    }
}

}  // namespace psicarve::machine
