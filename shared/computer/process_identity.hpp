// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace psicarve {

/// Start time of a process [clock ticks since boot], from /proc/PID/stat; 0 when there is no such process, it
/// is a zombie, or /proc does not say.
std::uint64_t process_start_time(std::uint32_t pid) noexcept;

std::uint32_t own_pid() noexcept;

/// Whether the process with this pid and start time lives. Start time 0 means unknown: then the pid alone
/// decides. A zombie is dead. A pid means the same process only within one pid namespace.
bool is_process_alive(std::uint32_t pid, std::uint64_t start_time) noexcept;

/// `prefix` and a word that is unique to this process among the living ones of this computer: its pid
/// namespace and its pid. Containers may share /dev/shm and not their pids.
std::string named_after_this_process(std::string_view prefix);
/// Whether a name that begins so belongs to a dead process of our pid namespace. False for another namespace,
/// whose processes cannot be seen.
bool is_named_after_dead_process(std::string_view name, std::string_view prefix) noexcept;

/// The kernel's name for this boot (36 characters); empty when /proc does not say.
std::string current_boot_id();

}  // namespace psicarve
