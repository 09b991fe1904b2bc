// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace psicarve {

/// What the core does so that its ticks come in time; the bits of CoreStatus::realtime_asked and
/// realtime_done, by number.
enum class RealtimeStep : std::uint8_t {
    keep_heap = 0,     ///< freed memory stays with the process
    lock_memory = 1,   ///< no page of it is ever taken away
    touch_memory = 2,  ///< stack, heap, queues and rings are there before the first tick
    tick_cpu = 3,      ///< the tick has a processor, the core's other threads keep off it
    wake_latency = 4,  ///< processors do not fall asleep deeply
    scheduling = 5,    ///< SCHED_FIFO
};
inline constexpr std::array kAllRealtimeSteps{RealtimeStep::keep_heap,    RealtimeStep::lock_memory,
                                              RealtimeStep::touch_memory, RealtimeStep::tick_cpu,
                                              RealtimeStep::wake_latency, RealtimeStep::scheduling};

/// Of SCHED_FIFO, if nobody says otherwise: above kernel threads that may wait, below its watchdogs.
inline constexpr int kTickPriority = 80;

/// "memory locked": what holds when it was done.
std::string_view name_of(RealtimeStep step) noexcept;
/// What an administrator does when the system refused it.
std::string_view remedy_of(RealtimeStep step) noexcept;
/// The same where the kernel has no /dev/cpu_dma_latency that one could be let write to.
inline constexpr std::string_view kNoLatencyDeviceRemedy =
    "start the kernel with processor.max_cstate=1, or one that has that device";

/// Whether a kernel is PREEMPT_RT, by /sys/kernel/realtime (empty: it has none) and /proc/version.
constexpr bool is_realtime_kernel(std::string_view realtime_file, std::string_view version) noexcept {
    return realtime_file.starts_with('1') || version.find("PREEMPT_RT") != std::string_view::npos;
}
inline constexpr std::string_view kKernelRemedy =
    "install a real-time kernel: apt install linux-image-rt-amd64";

constexpr std::uint32_t bit_of(RealtimeStep step) noexcept {
    return std::uint32_t{1} << static_cast<unsigned>(step);
}
/// Without these a core may keep no promise: a real machine is refused.
inline constexpr std::uint32_t kNeededRealtimeSteps =
    bit_of(RealtimeStep::lock_memory) | bit_of(RealtimeStep::scheduling);

}  // namespace psicarve
