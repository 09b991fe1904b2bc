// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace psicarve::rtcore {

/// One step of preparing for real time: what was tried, whether it worked, and what to do if not. A program
/// goes on without; it is for its caller to say so, and to refuse real hardware.
struct SetupStep {
    std::string name;  ///< "lock memory", "real-time scheduling" ...
    bool ok = false;
    std::string detail;  ///< what is in force now, or why it was refused
    std::string remedy;  ///< empty when ok
};

/// For the whole process, before other threads start and before large sparse memory is mapped: heap that is
/// never given back, pages locked that are there now, later ones when they are first touched.
std::vector<SetupStep> set_up_process_memory();

/// For the calling thread: SCHED_FIFO at `priority` (1..99), its stack touched once.
std::vector<SetupStep> set_up_realtime_thread(int priority);

/// Every step worked.
bool all_ok(std::span<const SetupStep> steps) noexcept;

inline constexpr int kTickPriority = 80;  ///< above kernel threads that may wait, below its watchdogs

}  // namespace psicarve::rtcore
