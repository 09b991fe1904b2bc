// SPDX-License-Identifier: GPL-3.0-or-later
#include <grp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>

#include "hmi/doctor/checks.hpp"
#include "shared/segment/layout.hpp"
#include "tests/hmi/doctor/made_up_computer.hpp"

namespace psicarve::doctor {
namespace {

using test::MadeUpComputer;

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
    expect_bad(check_scheduling(files()), Verdict::problem, "rtprio 90");
    expect_bad(check_locked_memory(files()), Verdict::problem, "memlock unlimited");
    EXPECT_EQ(check_locked_memory(files()).seen, "at most 8192 KiB");
    limits("unlimited", "50");
    expect_bad(check_scheduling(files()), Verdict::problem, "rtprio 90");
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
    expect_bad(check_ports(files(), false).front(), Verdict::problem,
               std::string{"adduser USER "} + ::getgrgid(own_group)->gr_name + ",");
    expect_bad(check_wake_latency(files()), Verdict::warning, "udev");
    user("0000000000000000", 54321, "54322 " + std::to_string(own_group));
    EXPECT_EQ(check_ports(files(), false).front().verdict, Verdict::ok);
    user("0000000000000002", 54321, "");
    EXPECT_EQ(check_ports(files(), false).front().verdict, Verdict::ok);
    EXPECT_EQ(check_wake_latency(files()).verdict, Verdict::ok);
    remove("/dev/cpu_dma_latency");
    expect_bad(check_wake_latency(files()), Verdict::warning, "max_cstate");
}

TEST(RawAddresses, AreARightThatNobodyHasToHaveWhoHasADevice) {
    EXPECT_EQ(check_raw_access(std::nullopt, true).seen, "allowed by CAP_SYS_RAWIO");
    const Finding unneeded = check_raw_access(raw_refusal(ENOSYS, true), true);
    EXPECT_EQ(unneeded.verdict, Verdict::ok);
    EXPECT_TRUE(unneeded.seen.starts_with("this kernel lets nobody at addresses; ")) << unneeded.seen;
    expect_bad(check_raw_access(raw_refusal(ENOSYS, true), false), Verdict::warning, "use --port ppdev");
    expect_bad(check_raw_access(raw_refusal(EPERM, false), false), Verdict::warning, "CAP_SYS_RAWIO");
}

// What the core would be told, which a capability alone does not say.
TEST_F(MadeUpComputer, SaysOfRawAddressesWhatThisKernelSays) {
    user("0000000000020000", 1000, "1000");
    const auto refusal = ask_for_addresses(0x378, 3);
    const Finding with_device = check_all(files()).back();
    EXPECT_EQ(with_device.verdict, Verdict::ok);
    remove("/dev/parport0");
    const Finding without = check_all(files()).back();
    EXPECT_EQ(without.name, "raw addresses");
    EXPECT_EQ(without.seen, refusal ? refusal->reason : "allowed by CAP_SYS_RAWIO");
    EXPECT_EQ(without.verdict, refusal ? Verdict::warning : Verdict::ok);
    EXPECT_TRUE(with_device.seen.starts_with(without.seen)) << with_device.seen;
}

TEST_F(MadeUpComputer, PortInAnothersHandsNamesIt) {
    put("/proc/sys/dev/parport/parport0/devices/active", "lp\n");
    expect_bad(check_ports(files(), false).front(), Verdict::problem, "rmmod lp");
    put("/proc/sys/dev/parport/parport0/devices/active", "ppdev0\n");
    EXPECT_EQ(check_ports(files(), false).front().seen, "held by ppdev0");
}

TEST_F(MadeUpComputer, ModuleLpIsAWarningAndItsNameMustBeWhole) {
    put("/proc/modules", "lpc_ich 1 0 - Live 0x0\nppdev 24576 0 - Live 0x0\n");
    EXPECT_EQ(check_ports(files(), false).size(), 1U);
    put("/proc/modules", "lp 20480 0 - Live 0x0\n");
    ASSERT_EQ(check_ports(files(), false).size(), 2U);
    expect_bad(check_ports(files(), false).back(), Verdict::warning, "blacklist lp");
}

TEST_F(MadeUpComputer, WithoutAPortDrivesNoRealMachine) {
    remove("/dev/parport0");
    expect_bad(check_ports(files(), false).front(), Verdict::problem, "modprobe ppdev");
    EXPECT_EQ(worst_of(check_ports(files(), false)), Verdict::problem);
    remove("/proc/sys/dev/parport");
    EXPECT_EQ(check_ports(files(), false).front().seen, "none");
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
