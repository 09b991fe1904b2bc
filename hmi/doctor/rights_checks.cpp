// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "hmi/doctor/checks.hpp"
#include "shared/computer/realtime_step.hpp"

namespace psicarve::doctor {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
constexpr const char* kLatencyDevice = "/dev/cpu_dma_latency";

}  // namespace

Finding check_scheduling(const SystemFiles& files) {
    const std::string name = "real-time scheduling";
    if (files.has_capability(kCapSysNice)) return fine(name, "allowed by CAP_SYS_NICE");
    const std::uint64_t most = files.limit("Max realtime priority").value_or(0);
    if (most >= std::uint64_t{kTickPriority}) return fine(name, "priority up to " + std::to_string(most));
    return {name, Verdict::problem,
            most == 0 ? "not allowed"
                      : "priority up to " + std::to_string(most) + " only, the tick has " +
                            std::to_string(kTickPriority),
            "any program may keep the tick waiting; a real machine is refused",
            std::string{remedy_of(RealtimeStep::scheduling)}};
}

Finding check_locked_memory(const SystemFiles& files) {
    const std::string name = "locked memory";
    if (files.has_capability(kCapIpcLock)) return fine(name, "allowed by CAP_IPC_LOCK");
    const std::uint64_t most_bytes = files.limit("Max locked memory").value_or(0);
    if (most_bytes == kUnlimited) return fine(name, "unlimited");
    return {name, Verdict::problem, "at most " + std::to_string(most_bytes / 1024) + " KiB",
            "a page that was taken away stops the tick until it is back; a real machine is refused",
            std::string{remedy_of(RealtimeStep::lock_memory)}};
}

Finding check_wake_latency(const SystemFiles& files) {
    const std::string name = "processor sleep";
    if (!files.exists(kLatencyDevice)) {
        return {name, Verdict::warning, std::string{kLatencyDevice} + " is not there",
                "processors that sleep deeply wake up late", std::string{kNoLatencyDeviceRemedy}};
    }
    if (files.may_write(kLatencyDevice)) return fine(name, "can be kept shallow");
    return {name, Verdict::warning, std::string{kLatencyDevice} + " may not be written",
            "processors that sleep deeply wake up late", std::string{remedy_of(RealtimeStep::wake_latency)}};
}

}  // namespace psicarve::doctor
