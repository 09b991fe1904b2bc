// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "hmi/doctor/checks.hpp"
#include "shared/layout.hpp"

namespace psicarve::doctor {
namespace {

/// A computer as its kernel tells about it, made of files; at first one that is in perfect order.
class MadeUpComputer : public ::testing::Test {
protected:
    MadeUpComputer() {
        root_ = testing::TempDir() + "psicarve-doctor-" + std::to_string(getpid());
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

void expect_bad(const Finding& finding, Verdict verdict, const std::string& remedy_part) {
    EXPECT_EQ(finding.verdict, verdict) << finding.name << ": " << finding.seen;
    EXPECT_FALSE(finding.meaning.empty()) << finding.name;
    EXPECT_NE(finding.remedy.find(remedy_part), std::string::npos) << finding.remedy;
}

TEST_F(MadeUpComputer, InPerfectOrderHasNoProblem) {
    for (const Finding& finding : check_all(files())) {
        // Its room for shared memory is that of the folder the test lies in.
        if (finding.name == "shared memory") continue;
        EXPECT_EQ(finding.verdict, Verdict::ok) << finding.name << ": " << finding.seen;
        EXPECT_TRUE(finding.remedy.empty()) << finding.name;
    }
}

TEST_F(MadeUpComputer, WithoutRightsNamesLimitsFile) {
    limits("8388608", "0");
    expect_bad(check_scheduling(files()), Verdict::problem, "rtprio 99");
    expect_bad(check_locked_memory(files()), Verdict::problem, "memlock unlimited");
    EXPECT_EQ(check_locked_memory(files()).seen, "at most 8192 KiB");
    limits("unlimited", "50");
    expect_bad(check_scheduling(files()), Verdict::problem, "rtprio 99");
    EXPECT_EQ(check_locked_memory(files()).verdict, Verdict::ok);
}

TEST_F(MadeUpComputer, CapabilitiesStandInForLimits) {
    limits("8388608", "0");
    user("0000000000800000", 1000, "");
    EXPECT_EQ(check_scheduling(files()).verdict, Verdict::ok);
    EXPECT_EQ(check_locked_memory(files()).verdict, Verdict::problem);
    user("0000000000004000", 1000, "");
    EXPECT_EQ(check_scheduling(files()).verdict, Verdict::problem);
    EXPECT_EQ(check_locked_memory(files()).verdict, Verdict::ok);
}

TEST_F(MadeUpComputer, DevicesBelongToGroupsOrToNobodyElse) {
    const auto own_group = getegid();
    mode("/dev/parport0", 0660);
    mode("/dev/cpu_dma_latency", 0600);
    user("0000000000000000", 54321, "54322");
    expect_bad(check_ports(files()).front(), Verdict::problem, "lp");
    expect_bad(check_wake_latency(files()), Verdict::warning, "udev");
    user("0000000000000000", 54321, "54322 " + std::to_string(own_group));
    EXPECT_EQ(check_ports(files()).front().verdict, Verdict::ok);
    user("0000000000000002", 54321, "");
    EXPECT_EQ(check_ports(files()).front().verdict, Verdict::ok);
    EXPECT_EQ(check_wake_latency(files()).verdict, Verdict::ok);
    remove("/dev/cpu_dma_latency");
    expect_bad(check_wake_latency(files()), Verdict::warning, "max_cstate");
}

TEST_F(MadeUpComputer, PortInAnothersHandsNamesIt) {
    put("/proc/sys/dev/parport/parport0/devices/active", "lp\n");
    expect_bad(check_ports(files()).front(), Verdict::problem, "rmmod lp");
    put("/proc/sys/dev/parport/parport0/devices/active", "ppdev0\n");
    EXPECT_EQ(check_ports(files()).front().seen, "held by ppdev0");
}

TEST_F(MadeUpComputer, ModuleLpIsAWarningAndItsNameMustBeWhole) {
    put("/proc/modules", "lpc_ich 1 0 - Live 0x0\nppdev 24576 0 - Live 0x0\n");
    EXPECT_EQ(check_ports(files()).size(), 1U);
    put("/proc/modules", "lp 20480 0 - Live 0x0\n");
    ASSERT_EQ(check_ports(files()).size(), 2U);
    expect_bad(check_ports(files()).back(), Verdict::warning, "blacklist lp");
}

TEST_F(MadeUpComputer, WithoutAPortMayStillSimulate) {
    remove("/dev/parport0");
    expect_bad(check_ports(files()).front(), Verdict::warning, "modprobe ppdev");
    remove("/proc/sys/dev/parport");
    EXPECT_EQ(check_ports(files()).front().seen, "none");
}

TEST_F(MadeUpComputer, EachWayToBeLateIsAWarning) {
    put("/sys/kernel/realtime", "0\n");
    expect_bad(check_preemption(files()), Verdict::warning, "linux-image-rt");
    put("/proc/version", "Linux version 6.1.0-rt (gcc) #1 SMP PREEMPT_RT Debian\n");
    EXPECT_EQ(check_preemption(files()).verdict, Verdict::ok);
    put("/sys/devices/system/cpu/isolated", "\n");
    expect_bad(check_isolated_cpus(files()), Verdict::warning, "isolcpus");
    put("/sys/devices/system/cpu/cpu1/cpufreq/scaling_governor", "powersave\n");
    expect_bad(check_frequency(files()), Verdict::warning, "performance");
    EXPECT_EQ(check_frequency(files()).seen, "cpu1: powersave");
    put("/sys/devices/system/clocksource/clocksource0/current_clocksource", "hpet\n");
    expect_bad(check_clock_source(files()), Verdict::warning, "tsc");
    put("/proc/swaps", "Filename\tType\n/dev/sda2\tpartition\n");
    expect_bad(check_swap(files()), Verdict::warning, "swapoff");
    put("/proc/cpuinfo", "flags\t\t: fpu hypervisor tsc\n");
    expect_bad(check_hypervisor(files()), Verdict::warning, "real computer");
}

TEST(DoctorMemory, RoomIsJudgedByTheLargestJob) {
    const std::uint64_t job = segment_geometry(kDefaultCapacityLayers, kDefaultCapacityPoints).slot_bytes;
    EXPECT_EQ(check_shared_memory(2 * job).verdict, Verdict::ok);
    expect_bad(check_shared_memory(2 * job - 1), Verdict::warning, "remount");
    expect_bad(check_shared_memory(job - 1), Verdict::problem, "--capacity");
    expect_bad(check_shared_memory(std::nullopt), Verdict::problem, "tmpfs");
}

TEST(DoctorVerdict, WorstOfAllCounts) {
    const auto finding = [](Verdict verdict) { return Finding{"", verdict, "", "", ""}; };
    EXPECT_EQ(worst_of({}), Verdict::ok);
    EXPECT_EQ(worst_of({finding(Verdict::ok), finding(Verdict::warning)}), Verdict::warning);
    EXPECT_EQ(worst_of({finding(Verdict::problem), finding(Verdict::warning)}), Verdict::problem);
}

}  // namespace
}  // namespace psicarve::doctor
