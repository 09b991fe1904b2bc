// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "hmi/doctor/base_holder.hpp"
#include "hmi/doctor/checks.hpp"
#include "shared/computer/kernel_ports.hpp"

namespace psicarve::doctor {
namespace {

constexpr const char* kByAddressAlone = "only --port io:ADDRESS can drive a machine";

Finding held(const std::string& name, const std::string& holder) {
    return {name, Verdict::problem, "held by " + holder, "two programs on one port move motors by accident",
            holder == "lp" ? "rmmod lp, and keep it out: a line \"blacklist lp\" in /etc/modprobe.d"
                           : "end the program that holds it; psicarve status shows a core"};
}

/// The kernel's claim, or a core's own lock; empty: free.
std::string holder_of(const SystemFiles& files, const KernelPort& port) {
    if (!port.holder.empty() || port.base == 0) return port.holder;
    return base_holder(files.path_of("/dev"), port.base).value_or("");
}

Finding check_device(const SystemFiles& files, const KernelPort& port, bool has_raw_access) {
    const std::string path = "/dev/" + port.name;
    if (const std::string holder = holder_of(files, port); !holder.empty()) return held(path, holder);
    if (files.may_write(path)) return fine(path, "free");
    const bool is_by_address = has_raw_access && port.base != 0;
    return {
        path, is_by_address ? Verdict::warning : Verdict::problem, "may not be written",
        is_by_address ? kByAddressAlone : "the core cannot drive it",
        "be in the group that owns it: adduser USER " + group_of(files.path_of(path)) + ", and a new login"};
}

/// The result that a core with --port io:BASE would get. Does not touch the port.
Finding check_base(const SystemFiles& files, const KernelPort& port) {
    const std::string name = "io:" + hex_of(port.base);
    if (const std::string holder = holder_of(files, port); !holder.empty()) return held(name, holder);
    return fine(name, "no core has it; one that is started says whether a port is there");
}

/// The ports that a core may drive by addresses: the kernel's ports without a device, and the classic bases.
std::vector<KernelPort> ports_by_address(const SystemFiles& files, const std::vector<KernelPort>& kernels) {
    std::vector<KernelPort> ports;
    for (const KernelPort& port : kernels) {
        if (port.base != 0 && !files.exists("/dev/" + port.name)) ports.push_back(port);
    }
    for (const std::uint16_t base : kClassicBases) {
        if (std::ranges::find(kernels, base, &KernelPort::base) != kernels.end()) continue;
        KernelPort port;
        port.base = base;
        ports.push_back(port);
    }
    return ports;
}

}  // namespace

std::vector<Finding> check_ports(const SystemFiles& files, bool has_raw_access) {
    const std::vector<KernelPort> kernels = kernel_ports(files.path_of("/proc"));
    std::vector<Finding> findings;
    for (const std::string& device : files.names_in("/dev")) {
        if (!device.starts_with("parport")) continue;
        const auto known = std::ranges::find(kernels, device, &KernelPort::name);
        KernelPort port;
        port.name = device;
        findings.push_back(check_device(files, known == kernels.end() ? port : *known, has_raw_access));
    }
    const bool has_hardware = !kernels.empty();
    if (findings.empty()) {
        findings.push_back(
            {"parallel port", has_raw_access ? Verdict::warning : Verdict::problem,
             has_hardware ? "the kernel has one, but /dev/parport0 is not there" : "none",
             has_raw_access ? kByAddressAlone : "only the simulated machine can be driven",
             has_hardware ? "modprobe ppdev" : "fit a parallel port; modprobe parport_pc ppdev"});
    }
    if (has_raw_access) {
        // A user with a device that can be driven needs no address; report only addresses in use.
        const bool has_device = std::ranges::find(findings, Verdict::ok, &Finding::verdict) != findings.end();
        for (const KernelPort& port : ports_by_address(files, kernels)) {
            Finding finding = check_base(files, port);
            if (!has_device || finding.verdict != Verdict::ok) findings.push_back(std::move(finding));
        }
    }
    if (is_lp_loaded(files.path_of("/proc"))) {
        findings.push_back({"module lp", Verdict::warning, "loaded", "the printer driver may take the port",
                            "rmmod lp, and keep it out: a line \"blacklist lp\" in /etc/modprobe.d"});
    }
    return findings;
}

Finding check_raw_access(const std::optional<RawRefusal>& refusal, bool has_device) {
    const std::string name = "raw addresses";
    if (!refusal) return fine(name, "allowed by CAP_SYS_RAWIO");
    if (has_device) return fine(name, refusal->reason + "; --port ppdev:/dev/parport0 needs no such right");
    return {name, Verdict::warning, refusal->reason, "--port io:ADDRESS is refused", refusal->remedy};
}

}  // namespace psicarve::doctor
