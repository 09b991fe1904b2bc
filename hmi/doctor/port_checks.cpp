// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "hmi/doctor/checks.hpp"
#include "shared/kernel_ports.hpp"

namespace psicarve::doctor {
namespace {

Finding check_device(const SystemFiles& files, const std::string& device,
                     const std::vector<KernelPort>& kernels) {
    const std::string path = "/dev/" + device;
    const auto port = std::ranges::find(kernels, device, &KernelPort::name);
    const std::string holder = port == kernels.end() ? std::string{} : port->holder;
    if (!holder.empty()) {
        return {path, Verdict::problem, "held by " + holder,
                "two programs on one port move motors by accident",
                holder == "lp" ? "rmmod lp, and keep it out: a line \"blacklist lp\" in /etc/modprobe.d"
                               : "end the program that holds it; psicarve status shows a core"};
    }
    if (!files.may_write(path)) {
        return {path, Verdict::problem, "may not be written", "the core cannot drive it",
                "be in the group that owns it: adduser USER " + group_of(files.path_of(path)) +
                    ", and a new login"};
    }
    return fine(path, "free");
}

}  // namespace

std::vector<Finding> check_ports(const SystemFiles& files) {
    const std::vector<KernelPort> kernels = kernel_ports(files.path_of("/proc"));
    std::vector<Finding> findings;
    for (const std::string& device : files.names_in("/dev")) {
        if (device.starts_with("parport")) findings.push_back(check_device(files, device, kernels));
    }
    const bool has_hardware = !kernels.empty();
    if (findings.empty()) {
        findings.push_back(
            {"parallel port", Verdict::problem,
             has_hardware ? "the kernel has one, but /dev/parport0 is not there" : "none",
             "only the simulated machine can be driven",
             has_hardware ? "modprobe ppdev" : "fit a parallel port; modprobe parport_pc ppdev"});
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
