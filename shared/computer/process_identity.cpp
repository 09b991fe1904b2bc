// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/process_identity.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <limits>
#include <string_view>

namespace psicarve {
namespace {

/// The beginning of a small file in /proc, in one read; empty when it cannot be read.
template <std::size_t kBytes>
std::string_view read_small_file(const char* path, std::array<char, kBytes>& buffer) noexcept {
    const int file = ::open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) return {};
    const ssize_t got = ::read(file, buffer.data(), buffer.size());
    ::close(file);
    return got > 0 ? std::string_view{buffer.data(), static_cast<std::size_t>(got)} : std::string_view{};
}

struct StatLine {
    char state = 0;  ///< 0: could not be read
    std::uint64_t start_time = 0;
};

StatLine read_stat(std::uint32_t pid) noexcept {
    std::array<char, 32> path{"/proc/"};
    const auto end = std::to_chars(path.data() + 6, path.data() + 20, pid).ptr;
    std::string_view{"/stat"}.copy(end, 5);
    std::array<char, 1024> buffer{};
    std::string_view line = read_small_file(path.data(), buffer);
    // Field 2 is the program's name in brackets and may itself hold brackets and spaces.
    const std::size_t name_end = line.rfind(')');
    if (name_end == std::string_view::npos || name_end + 2 >= line.size()) return {};
    line.remove_prefix(name_end + 2);
    StatLine stat{.state = line.front()};
    for (int field = 3; field < 22; ++field) {
        const std::size_t space = line.find(' ');
        if (space == std::string_view::npos) return {};
        line.remove_prefix(space + 1);
    }
    std::from_chars(line.data(), line.data() + line.size(), stat.start_time);
    return stat;
}

/// Its number in the kernel; 0 when /proc does not say.
std::uint64_t own_pid_namespace() noexcept {
    struct stat facts {};
    return ::stat("/proc/self/ns/pid", &facts) == 0 ? facts.st_ino : 0;
}

bool is_dead_state(char state) noexcept {
    return state == 'Z' || state == 'X' || state == 'x';
}

}  // namespace

std::uint64_t process_start_time(std::uint32_t pid) noexcept {
    const StatLine stat = read_stat(pid);
    return is_dead_state(stat.state) ? 0 : stat.start_time;
}

std::uint32_t own_pid() noexcept {
    return static_cast<std::uint32_t>(::getpid());
}

bool is_process_alive(std::uint32_t pid, std::uint64_t start_time) noexcept {
    if (pid == 0 || pid > static_cast<std::uint32_t>(std::numeric_limits<pid_t>::max())) return false;
    if (::kill(static_cast<pid_t>(pid), 0) != 0 && errno == ESRCH) return false;
    const StatLine stat = read_stat(pid);
    if (stat.state == 0) return true;  // hidden from us, but kill() found it
    if (is_dead_state(stat.state)) return false;
    return start_time == 0 || stat.start_time == start_time;
}

std::string named_after_this_process(std::string_view prefix) {
    return std::string{prefix} + std::to_string(own_pid_namespace()) + "-" + std::to_string(own_pid());
}

bool is_named_after_dead_process(std::string_view name, std::string_view prefix) noexcept {
    if (!name.starts_with(prefix)) return false;
    const char* const end = name.data() + name.size();
    std::uint64_t pid_namespace = 0;
    const auto [dash, no_namespace] = std::from_chars(name.data() + prefix.size(), end, pid_namespace);
    if (no_namespace != std::errc{} || dash == end || *dash != '-') return false;
    std::uint32_t pid = 0;
    const auto [rest, no_pid] = std::from_chars(dash + 1, end, pid);
    if (no_pid != std::errc{} || (rest != end && *rest != '-')) return false;
    return pid_namespace == own_pid_namespace() && pid > 0 && !is_process_alive(pid, 0);
}

std::string current_boot_id() {
    std::array<char, 64> buffer{};
    const std::string_view text = read_small_file("/proc/sys/kernel/random/boot_id", buffer);
    return std::string{text.substr(0, text.find('\n'))};
}

}  // namespace psicarve
