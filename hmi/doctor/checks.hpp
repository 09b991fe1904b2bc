// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/doctor/finding.hpp"
#include "hmi/doctor/system_files.hpp"
#include "shared/computer/raw_access.hpp"

namespace psicarve::doctor {

// rights_checks.cpp: what this user may do
Finding check_scheduling(const SystemFiles& files);
Finding check_locked_memory(const SystemFiles& files);
Finding check_wake_latency(const SystemFiles& files);
// kernel_checks.cpp: what the computer does to a tick
Finding check_preemption(const SystemFiles& files);
Finding check_isolated_cpus(const SystemFiles& files);
Finding check_frequency(const SystemFiles& files);
Finding check_clock_source(const SystemFiles& files);
Finding check_swap(const SystemFiles& files);
Finding check_hypervisor(const SystemFiles& files);
/// `free_bytes` of /dev/shm; nothing: unknown.
Finding check_shared_memory(std::optional<std::uint64_t> free_bytes);
// port_checks.cpp: one finding for each device, or one that says there is none. `has_raw_access`: a core with
// --port io:... may access the addresses; then also one for each address at which a core drives a port, and,
// where no device can be driven, one for each address that a core would take.
std::vector<Finding> check_ports(const SystemFiles& files, bool has_raw_access);
/// Whether the kernel lets a core with --port io:... access the addresses. A user with a device that can be
/// driven does not need that.
Finding check_raw_access(const std::optional<RawRefusal>& refusal, bool has_device);

/// All checks, in the order of the report.
std::vector<Finding> check_all(const SystemFiles& files);

/// The worst verdict of them.
Verdict worst_of(const std::vector<Finding>& findings) noexcept;

}  // namespace psicarve::doctor
