// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include "hmi/doctor/checks.hpp"

namespace psicarve::doctor {
namespace {

bool is_module_loaded(const SystemFiles& files, const std::string& module) {
    std::istringstream lines{files.text("/proc/modules").value_or("")};
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(module + " ")) return true;
    }
    return false;
}

Finding check_device(const SystemFiles& files, const std::string& device, const std::string& kernel_name) {
    const std::string path = "/dev/" + device;
    const std::string holder =
        files.text("/proc/sys/dev/parport/" + kernel_name + "/devices/active").value_or("none");
    if (holder != "none" && !holder.empty()) {
        return {path, Verdict::problem, "held by " + holder,
                "two programs on one port move motors by accident",
                holder == "lp" ? "rmmod lp, and keep it out: a line \"blacklist lp\" in /etc/modprobe.d"
                               : "end the program that holds it; psicarve status shows a core"};
    }
    if (!files.may_write(path)) {
        return {path, Verdict::problem, "may not be written", "the core cannot drive it",
                "be in the group that owns it: adduser USER lp, and a new login"};
    }
    return fine(path, "free");
}

}  // namespace

std::vector<Finding> check_ports(const SystemFiles& files) {
    std::vector<Finding> findings;
    for (const std::string& device : files.names_in("/dev")) {
        if (device.starts_with("parport")) findings.push_back(check_device(files, device, device));
    }
    const bool has_hardware = !files.names_in("/proc/sys/dev/parport").empty();
    if (findings.empty()) {
        findings.push_back(
            {"parallel port", Verdict::warning,
             has_hardware ? "the kernel has one, but /dev/parport0 is not there" : "none",
             "only the simulated machine can be driven",
             has_hardware ? "modprobe ppdev" : "fit a parallel port; modprobe parport_pc ppdev"});
    }
    if (is_module_loaded(files, "lp")) {
        findings.push_back({"module lp", Verdict::warning, "loaded", "the printer driver may take the port",
                            "rmmod lp, and keep it out: a line \"blacklist lp\" in /etc/modprobe.d"});
    }
    return findings;
}

}  // namespace psicarve::doctor
