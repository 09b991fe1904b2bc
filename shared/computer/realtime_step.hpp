// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace psicarve {

/// What the core does so that its ticks come in time. The numbers are the bits of CoreStatus::realtime_asked
/// and realtime_done.
enum class RealtimeStep : std::uint8_t {
    keep_heap = 0,     ///< freed memory stays with the process
    lock_memory = 1,   ///< no page of the process is ever taken away
    touch_memory = 2,  ///< stack, heap, queues and rings are there before the first tick
    tick_cpu = 3,      ///< the tick has a processor, the core's other threads keep off it
    wake_latency = 4,  ///< processors do not fall asleep deeply
    scheduling = 5,    ///< SCHED_FIFO
};
inline constexpr std::array kAllRealtimeSteps{RealtimeStep::keep_heap,    RealtimeStep::lock_memory,
                                              RealtimeStep::touch_memory, RealtimeStep::tick_cpu,
                                              RealtimeStep::wake_latency, RealtimeStep::scheduling};

/// Default priority of SCHED_FIFO: above kernel threads that may wait, below the kernel's watchdogs.
inline constexpr int kTickPriority = 80;

/// "memory locked": the state after the step.
std::string_view name_of(RealtimeStep step) noexcept;
/// What an administrator does when the system refuses the step.
std::string_view remedy_of(RealtimeStep step) noexcept;
/// The same for a kernel without /dev/cpu_dma_latency.
inline constexpr std::string_view kNoLatencyDeviceRemedy =
    "start the kernel with processor.max_cstate=1, or one that has that device";

/// Whether a kernel is PREEMPT_RT, by the text of /sys/kernel/realtime (empty: no such file) and of
/// /proc/version.
constexpr bool is_realtime_kernel(std::string_view realtime_file, std::string_view version) noexcept {
    return realtime_file.starts_with('1') || version.find("PREEMPT_RT") != std::string_view::npos;
}
inline constexpr std::string_view kKernelRemedy =
    "install a real-time kernel: apt install linux-image-rt-amd64";

constexpr std::uint32_t bit_of(RealtimeStep step) noexcept {
    return std::uint32_t{1} << static_cast<unsigned>(step);
}
/// A core without these cannot keep its promises: it refuses a real machine.
inline constexpr std::uint32_t kNeededRealtimeSteps =
    bit_of(RealtimeStep::lock_memory) | bit_of(RealtimeStep::scheduling);

}  // namespace psicarve
