// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/thread_counts.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>

namespace psicarve::rtcore {
namespace {

/// Empty for a file that cannot be read, such as that of a thread that has ended since it was opened: here
/// that is a state of the stream, where iterators would throw.
std::string text_of(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream{path}.rdbuf();
    return text.str();
}

/// The number behind "name:" at the begin of a line.
std::optional<std::uint64_t> number_of(std::string_view text, std::string_view name) {
    const std::size_t at = text.find("\n" + std::string{name} + ":");
    if (at == std::string_view::npos) return std::nullopt;
    text.remove_prefix(at + name.size() + 2);
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{}) return std::nullopt;
    return number;
}

}  // namespace

ThreadCounts ThreadCounts::since(const ThreadCounts& before) const noexcept {
    return {.minor_faults = minor_faults - before.minor_faults,
            .major_faults = major_faults - before.major_faults,
            .sleeps = sleeps - before.sleeps,
            .preemptions = preemptions - before.preemptions};
}

std::optional<ThreadCounts> counts_of_thread(pid_t thread, const std::string& root) {
    const std::string folder = root + "/proc/self/task/" + std::to_string(thread);
    const std::string stat = text_of(folder + "/stat");
    // Behind the name, which may contain any character: state, then ppid pgrp session tty tpgid flags minflt
    // cminflt majflt.
    const std::size_t name_end = stat.rfind(')');
    if (name_end == std::string::npos) return std::nullopt;
    std::istringstream fields{stat.substr(name_end + 1)};
    std::string skipped;
    for (int field = 0; field < 7; ++field) fields >> skipped;
    ThreadCounts counts;
    fields >> counts.minor_faults >> skipped >> counts.major_faults;
    const std::string status = text_of(folder + "/status");
    const auto sleeps = number_of(status, "voluntary_ctxt_switches");
    const auto preemptions = number_of(status, "nonvoluntary_ctxt_switches");
    if (!fields || !sleeps || !preemptions) return std::nullopt;
    counts.sleeps = *sleeps;
    counts.preemptions = *preemptions;
    return counts;
}

}  // namespace psicarve::rtcore
