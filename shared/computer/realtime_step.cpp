// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/realtime_step.hpp"

namespace psicarve {

std::string_view name_of(RealtimeStep step) noexcept {
    switch (step) {
        case RealtimeStep::keep_heap:
            return "heap kept";
        case RealtimeStep::lock_memory:
            return "memory locked";
        case RealtimeStep::touch_memory:
            return "memory touched";
        case RealtimeStep::tick_cpu:
            return "processor of the tick";
        case RealtimeStep::wake_latency:
            return "processors kept awake";
        case RealtimeStep::scheduling:
            return "real-time scheduling";
    }
    return "unknown";
}

std::string_view remedy_of(RealtimeStep step) noexcept {
    switch (step) {
        case RealtimeStep::keep_heap:
            return "use the GNU C library's allocator";
        case RealtimeStep::lock_memory:
            return "raise the limit: a line \"@GROUP - memlock unlimited\" in /etc/security/limits.d and a "
                   "new login, or the capability CAP_IPC_LOCK";
        case RealtimeStep::touch_memory:
            return "the computer has too little free memory: end other programs";
        case RealtimeStep::tick_cpu:
            return "give --cpu the number of a processor that this process may use, or any";
        case RealtimeStep::wake_latency:
            return "allow writing to /dev/cpu_dma_latency: a udev rule KERNEL==\"cpu_dma_latency\", "
                   "GROUP=\"GROUP\", MODE=\"0660\", and be in that group";
        case RealtimeStep::scheduling:
            return "allow it: a line \"@GROUP - rtprio 90\" in /etc/security/limits.d and a new login, or "
                   "the "
                   "capability CAP_SYS_NICE; in a container, real-time time for its control group";
    }
    return "";
}

}  // namespace psicarve
