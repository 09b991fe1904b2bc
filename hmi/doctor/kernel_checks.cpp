// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "hmi/doctor/checks.hpp"
#include "shared/computer/cpu_list.hpp"
#include "shared/computer/realtime_step.hpp"
#include "shared/segment/layout.hpp"

namespace psicarve::doctor {
namespace {

constexpr const char* kCpuFolder = "/sys/devices/system/cpu";
constexpr std::uint64_t kBytesPerMb = 1'000'000;

/// cpu0, cpu1 ... : those folders alone.
bool is_cpu(const std::string& name) {
    return name.starts_with("cpu") && name.size() > 3 &&
           std::all_of(name.begin() + 3, name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

Finding check_preemption(const SystemFiles& files) {
    const std::string name = "kernel";
    const std::string version = files.text("/proc/sys/kernel/osrelease").value_or("unknown");
    if (is_realtime_kernel(files.text("/sys/kernel/realtime").value_or(""),
                           files.text("/proc/version").value_or("")))
        return fine(name, version + ", PREEMPT_RT");
    return {
        name, Verdict::warning, version + ", not PREEMPT_RT",
        "the kernel itself keeps the tick waiting, at times for milliseconds; they are skipped and counted",
        std::string{kKernelRemedy}};
}

Finding check_isolated_cpus(const SystemFiles& files) {
    const std::string name = "processor of the tick";
    const std::string list = files.text(std::string{kCpuFolder} + "/isolated").value_or("");
    const auto isolated = cpus_from_list(list);
    if (isolated && !isolated->empty()) {
        return fine(name, "isolated: " + list + "; the tick takes " + std::to_string(isolated->back()));
    }
    return {name, Verdict::warning, "none is kept free",
            "other programs and interrupts run where the tick does",
            "start the kernel with isolcpus=N nohz_full=N rcu_nocbs=N, N the last processor"};
}

Finding check_frequency(const SystemFiles& files) {
    const std::string name = "processor speed";
    std::string slow;
    bool is_known = false;
    for (const std::string& cpu : files.names_in(kCpuFolder)) {
        if (!is_cpu(cpu)) continue;
        const auto governor = files.text(std::string{kCpuFolder} + "/" + cpu + "/cpufreq/scaling_governor");
        if (!governor) continue;
        is_known = true;
        if (*governor != "performance") slow += (slow.empty() ? "" : ", ") + cpu + ": " + *governor;
    }
    if (!is_known) return fine(name, "not changed by the kernel");
    if (slow.empty()) return fine(name, "performance");
    return {name, Verdict::warning, slow, "a processor that first speeds up makes ticks late",
            "cpupower frequency-set --governor performance (package linux-cpupower)"};
}

Finding check_clock_source(const SystemFiles& files) {
    const std::string name = "clock";
    const std::string source =
        files.text("/sys/devices/system/clocksource/clocksource0/current_clocksource").value_or("unknown");
    if (source == "tsc" || source == "kvm-clock") return fine(name, source);
    return {name, Verdict::warning, source, "reading it takes about a microsecond, several times a tick",
            "see in the kernel's messages why the tsc is not trusted; often the firmware is to blame"};
}

Finding check_swap(const SystemFiles& files) {
    const std::string name = "swap";
    const std::string swaps = files.text("/proc/swaps").value_or("");
    const auto lines = std::ranges::count(swaps, '\n');
    if (lines == 0) return fine(name, "none");
    return {name, Verdict::warning, std::to_string(lines) + " in use",
            "the core's memory is locked, but a computer that swaps is late with everything else",
            "swapoff --all while carving, or more memory"};
}

Finding check_hypervisor(const SystemFiles& files) {
    const std::string name = "computer";
    const std::string flags = " " + files.field("/proc/cpuinfo", "flags").value_or("") + " ";
    if (flags.find(" hypervisor ") == std::string::npos) return fine(name, "no virtual machine");
    return {name, Verdict::warning, "a virtual machine",
            "its host takes the processor away when it likes, and nothing here can prevent that",
            "drive a real machine from a real computer"};
}

Finding check_shared_memory(std::optional<std::uint64_t> free_bytes) {
    const std::string name = "shared memory";
    const std::uint64_t wanted = segment_geometry(kDefaultCapacityLayers, kDefaultCapacityPoints).slot_bytes;
    const std::string wanted_text = std::to_string(wanted / kBytesPerMb) + " MB";
    const std::string remedy =
        "mount -o remount,size=1G /dev/shm, or psicarve-rtcore --capacity for smaller jobs";
    const std::string meaning = "the largest job takes " + wanted_text;
    if (!free_bytes) return {name, Verdict::problem, "/dev/shm is not there", meaning, "mount a tmpfs there"};
    const std::string seen = std::to_string(*free_bytes / kBytesPerMb) + " MB free in /dev/shm";
    if (*free_bytes < wanted) return {name, Verdict::problem, seen, meaning, remedy};
    // One job is published while another is carved.
    if (*free_bytes < 2 * wanted)
        return {name, Verdict::warning, seen, meaning + ", two may be there", remedy};
    return fine(name, seen);
}

std::vector<Finding> check_all(const SystemFiles& files) {
    std::vector<Finding> findings{
        check_scheduling(files),    check_locked_memory(files),
        check_wake_latency(files),  check_preemption(files),
        check_isolated_cpus(files), check_frequency(files),
        check_clock_source(files),  check_swap(files),
        check_hypervisor(files),    check_shared_memory(files.free_bytes("/dev/shm"))};
    constexpr std::uint16_t kClassicBase = 0x378;
    constexpr std::uint16_t kRegisters = 3;
    const auto refusal = ask_for_addresses(kClassicBase, kRegisters);
    bool has_device = false;
    for (Finding& finding : check_ports(files, !refusal)) {
        has_device = has_device || (finding.verdict == Verdict::ok && finding.name.starts_with("/dev/"));
        findings.push_back(std::move(finding));
    }
    findings.push_back(check_raw_access(refusal, has_device));
    return findings;
}

Verdict worst_of(const std::vector<Finding>& findings) noexcept {
    Verdict worst = Verdict::ok;
    for (const Finding& finding : findings) worst = std::max(worst, finding.verdict);
    return worst;
}

}  // namespace psicarve::doctor
