// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "hmi/doctor/system_files.hpp"

namespace psicarve::doctor::test {

/// A computer as its kernel tells about it, made of files; at first one that is in perfect order.
class MadeUpComputer : public ::testing::Test {
protected:
    MadeUpComputer() {
        root_ = ::testing::TempDir() + "psicarve-doctor-" + std::to_string(getpid());
        std::filesystem::remove_all(root_);
        user("0000000000000000", 1000, "1000 100");
        put("/proc/self/limits",
            "Limit                     Soft Limit           Hard Limit           Units\n"
            "Max locked memory         unlimited            unlimited            bytes\n"
            "Max realtime priority     99                   99\n");
        put("/proc/sys/kernel/osrelease", "6.1.0-rt\n");
        put("/sys/kernel/realtime", "1\n");
        put("/sys/devices/system/cpu/isolated", "2-3\n");
        put("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "performance\n");
        put("/sys/devices/system/cpu/cpufreq/boost", "1\n");
        put("/sys/devices/system/clocksource/clocksource0/current_clocksource", "tsc\n");
        put("/proc/swaps", "Filename\tType\tSize\tUsed\tPriority\n");
        put("/proc/cpuinfo", "processor\t: 0\nflags\t\t: fpu tsc\n");
        put("/proc/modules", "ppdev 24576 0 - Live 0x0\n");
        put("/proc/sys/dev/parport/parport0/devices/active", "none\n");
        put("/dev/parport0", "");
        put("/dev/cpu_dma_latency", "");
        mode("/dev/parport0", 0666);
        mode("/dev/cpu_dma_latency", 0666);
        std::filesystem::create_directories(root_ + "/dev/shm");
    }
    ~MadeUpComputer() override { std::filesystem::remove_all(root_); }

    void put(const std::string& path, const std::string& text) const {
        std::filesystem::create_directories(std::filesystem::path{root_ + path}.parent_path());
        std::ofstream{root_ + path} << text;
    }
    void mode(const std::string& path, unsigned bits) const {
        std::filesystem::permissions(root_ + path, static_cast<std::filesystem::perms>(bits));
    }
    void remove(const std::string& path) const { std::filesystem::remove_all(root_ + path); }
    void user(const std::string& capabilities, unsigned id, const std::string& groups) const {
        const std::string ids = std::to_string(id) + "\t" + std::to_string(id) + "\t" + std::to_string(id) +
                                "\t" + std::to_string(id);
        put("/proc/self/status", "Name:\tdoctor\nUid:\t" + ids + "\nGid:\t" + ids + "\nGroups:\t" + groups +
                                     "\nCapEff:\t" + capabilities + "\n");
    }
    void limits(const std::string& memory, const std::string& priority) const {
        put("/proc/self/limits", "Max locked memory         " + memory + "   " + memory +
                                     "   bytes\nMax realtime priority     " + priority + "  " + priority +
                                     "\n");
    }
    SystemFiles files() const { return SystemFiles{root_}; }

    std::string root_;
};

}  // namespace psicarve::doctor::test
