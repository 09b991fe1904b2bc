// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace psicarve::two_process {

/// CAP_IPC_LOCK and CAP_SYS_NICE: they stay where the limits that replace them cannot be raised.
inline constexpr unsigned long long kReplacedByLimits = 1ULL << 14 | 1ULL << 23;

inline std::vector<pid_t> threads_of(pid_t process) {
    std::vector<pid_t> threads;
    const std::string folder = "/proc/" + std::to_string(process) + "/task";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        threads.push_back(static_cast<pid_t>(std::stol(entry.path().filename().string())));
    }
    return threads;
}

/// "CapEff" -> "0000000000000000", of a thread.
inline std::map<std::string, std::string> kernel_facts(pid_t process, pid_t thread) {
    std::ifstream file{"/proc/" + std::to_string(process) + "/task/" + std::to_string(thread) + "/status"};
    std::map<std::string, std::string> facts;
    std::string key;
    std::string value;
    while (std::getline(file, key, ':') && std::getline(file >> std::ws, value)) facts[key] = value;
    return facts;
}

}  // namespace psicarve::two_process
