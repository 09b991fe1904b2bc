// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/computer/realtime_step.hpp"

namespace psicarve::rtcore {

/// One step of preparing for real time: what was tried, whether it worked, and what to do if not. A program
/// can go on without it; its caller reports that, and refuses real hardware.
struct SetupStep {
    enum class Outcome : std::uint8_t { done, refused, not_asked };
    RealtimeStep step{};
    Outcome outcome = Outcome::not_asked;
    std::string detail;  ///< what is in force now, or why it was refused
    std::string remedy;  ///< empty unless refused
};

/// Prepares the whole process, before other threads start and before large sparse memory is mapped: the heap
/// never returns memory, pages that are there now are locked, later ones when they are first touched.
std::vector<SetupStep> set_up_process_memory();

/// Makes every page of the heap so far, and of a reserve, present from now on. Call it before other threads
/// start, after what the tick uses was made.
SetupStep touch_heap();

/// Writes to every page of it without changing a byte, so that none of them faults later.
void touch_pages(void* begin, std::size_t bytes) noexcept;

/// Whether this kernel is PREEMPT_RT. `root` stands before /sys and /proc.
bool has_realtime_kernel(const std::string& root = {});

/// The processor for the tick when none is named: the last isolated one (isolcpus) that this process may use;
/// nothing when there is none. `root` stands before /sys.
std::optional<int> isolated_cpu(const std::string& root = {});

/// Moves the calling thread, and those that it starts from here on, off this processor, if another is
/// allowed.
void keep_off_cpu(int cpu) noexcept;

/// Prepares the calling thread: touches its stack, binds it to this processor (nothing: any), sets SCHED_FIFO
/// at `priority`.
std::vector<SetupStep> set_up_realtime_thread(int priority, std::optional<int> cpu = std::nullopt);

/// While it lives no processor enters a sleep state that it wakes from late: holds /dev/cpu_dma_latency open
/// with 0.
class WakeLatencyHold {
public:
    WakeLatencyHold() = default;
    WakeLatencyHold(const WakeLatencyHold&) = delete;
    WakeLatencyHold& operator=(const WakeLatencyHold&) = delete;
    ~WakeLatencyHold();

    SetupStep hold(const char* path = "/dev/cpu_dma_latency");

private:
    int descriptor_ = -1;
};

/// Bit by RealtimeStep.
std::uint32_t steps_asked(std::span<const SetupStep> steps) noexcept;
std::uint32_t steps_done(std::span<const SetupStep> steps) noexcept;

/// "real time: SCHED_FIFO, priority 80; ...", and a line for each step that was refused: what, why, and the
/// remedy.
std::vector<std::string> report_of(std::span<const SetupStep> steps);

}  // namespace psicarve::rtcore
