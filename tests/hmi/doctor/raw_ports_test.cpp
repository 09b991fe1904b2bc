// SPDX-License-Identifier: GPL-3.0-or-later
// The doctor's lines about ports that a core drives by their addresses, where the core may. The locks are
// those of a real core that opens a port and stands still in the middle of it.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "hmi/doctor/base_holder.hpp"
#include "hmi/doctor/checks.hpp"
#include "rtcore/port/base_lock.hpp"
#include "rtcore/port/raw_port.hpp"
#include "shared/computer/kernel_ports.hpp"
#include "tests/hmi/doctor/made_up_computer.hpp"
#include "tests/rtcore/port/kernel_stand_in.hpp"

namespace {

/// The process that opens a port says here that it has come to the kernel's claim.
int claim_report = -1;

}  // namespace

int psicarve::port::test::answer_of_driver(unsigned long /*request*/) noexcept {
    if (claim_report >= 0 && ::write(claim_report, "c", 1) == 1) {
        for (;;) ::pause();  // a claim that is never answered
    }
    return -1;
}

namespace psicarve::doctor {
namespace {

using test::MadeUpComputer;

/// A process that opens a port by its addresses and stands still once the lock of its base is its own.
class OpeningCore {
public:
    OpeningCore(std::uint16_t base, const SystemFiles& files) {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0) return;
        pid_ = ::fork();
        if (pid_ == 0) {
            ::close(ends[0]);
            claim_report = ends[1];
            static_cast<void>(port::open_raw(base, PinMap::from_profile(Profile{}).value(),
                                             {.proc = files.path_of("/proc"), .dev = files.path_of("/dev")}));
            ::_exit(1);
        }
        ::close(ends[1]);
        char said = 0;
        has_lock_ = ::read(ends[0], &said, 1) == 1;
        ::close(ends[0]);
    }
    ~OpeningCore() {
        if (pid_ <= 0) return;  // -1 would be all processes
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    OpeningCore(const OpeningCore&) = delete;
    OpeningCore& operator=(const OpeningCore&) = delete;

    bool has_lock() const { return has_lock_; }
    std::string held_by() const { return "held by " + process_text(pid_); }

private:
    pid_t pid_ = -1;
    bool has_lock_ = false;
};

class RawPorts : public MadeUpComputer {
protected:
    RawPorts() {
        kernel_has(0x378);
        put("/dev/port", "");
    }
    void kernel_has(std::uint16_t base) const {
        put("/proc/sys/dev/parport/parport0/base-addr", std::to_string(base) + "\t0\n");
    }
    /// The core can claim the port then, but the doctor does not see its device.
    void hide_device() const { remove("/dev/parport0"); }
    void without_port() const {
        remove("/dev/parport0");
        remove("/proc/sys/dev/parport");
    }
    Finding finding_of(const std::string& name) const {
        const auto findings = check_ports(files(), true);
        const auto found = std::ranges::find(findings, name, &Finding::name);
        return found == findings.end() ? Finding{} : *found;
    }
};

TEST_F(RawPorts, StandInForADeviceThatIsNotThere) {
    without_port();
    const auto findings = check_ports(files(), true);
    ASSERT_EQ(findings.size(), 4U);
    EXPECT_EQ(findings.front().name, "parallel port");
    EXPECT_EQ(findings.front().verdict, Verdict::warning);
    EXPECT_EQ(findings.front().meaning, "only --port io:ADDRESS can drive a machine");
    EXPECT_EQ(findings.front().remedy, "fit a parallel port; modprobe parport_pc ppdev");
    for (const char* name : {"io:0x378", "io:0x278", "io:0x3bc"}) {
        EXPECT_EQ(finding_of(name).verdict, Verdict::ok) << name;
        EXPECT_TRUE(finding_of(name).seen.starts_with("no core has it")) << name << finding_of(name).seen;
    }
    EXPECT_NE(worst_of(check_all(files())), Verdict::problem) << "a core with --port io:0x378 is let in";
    EXPECT_EQ(check_all(files()).back().seen, "allowed by CAP_SYS_RAWIO");
}

TEST_F(RawPorts, AreNoneWhereNobodyIsLetAtAddresses) {
    without_port();
    const auto findings = check_ports(files(), false);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings.front().verdict, Verdict::problem);
    EXPECT_EQ(findings.front().meaning, "only the simulated machine can be driven");
}

TEST_F(RawPorts, AreNotListedBesideADeviceThatCanBeDriven) {
    EXPECT_EQ(check_ports(files(), true).size(), 1U);
    user("0000000000000000", 54321, "54322");
    mode("/dev/parport0", 0660);
    EXPECT_EQ(finding_of("/dev/parport0").verdict, Verdict::warning) << "io:0x378 is the same port";
    EXPECT_EQ(check_ports(files(), false).front().verdict, Verdict::problem);
    EXPECT_EQ(finding_of("io:0x278").verdict, Verdict::ok);
    kernel_has(0);
    EXPECT_EQ(finding_of("/dev/parport0").verdict, Verdict::problem) << "a USB port has no address";
}

TEST_F(RawPorts, OfTheKernelAreAmongThemAndMayBeInOtherHands) {
    kernel_has(0xd010);
    hide_device();
    EXPECT_EQ(finding_of("io:0xd010").verdict, Verdict::ok);
    EXPECT_EQ(check_ports(files(), true).front().remedy, "modprobe ppdev");
    put("/proc/sys/dev/parport/parport0/devices/active", "lp\n");
    EXPECT_EQ(finding_of("io:0xd010").seen, "held by lp");
    EXPECT_EQ(finding_of("io:0xd010").verdict, Verdict::problem);
}

TEST_F(RawPorts, HeldByACoreNameItsProcess) {
    const OpeningCore core{0x378, files()};
    ASSERT_TRUE(core.has_lock());
    EXPECT_EQ(finding_of("/dev/parport0").seen, core.held_by());
    EXPECT_EQ(check_ports(files(), false).front().verdict, Verdict::problem)
        << "also for those with a device";
    // The kernel's driver is gone, the core is not.
    without_port();
    const Finding sut = finding_of("io:0x378");
    EXPECT_EQ(sut.verdict, Verdict::problem);
    EXPECT_EQ(sut.seen, core.held_by());
    EXPECT_EQ(sut.remedy, "end the program that holds it; psicarve status shows a core");
    EXPECT_EQ(finding_of("io:0x278").verdict, Verdict::ok) << "its addresses are others";
}

TEST_F(RawPorts, HeldByACoreAreSeenWithoutTheDeviceOfAddresses) {
    remove("/dev/port");
    kernel_has(0xd010);
    {
        const OpeningCore core{0xd010, files()};
        ASSERT_TRUE(core.has_lock());
        EXPECT_EQ(finding_of("/dev/parport0").seen, core.held_by());
        hide_device();
        EXPECT_EQ(finding_of("io:0xd010").seen, core.held_by());
        put("/dev/port", "");
        EXPECT_EQ(finding_of("io:0xd010").seen, core.held_by()) << "nor is it in the device's locks";
    }
    EXPECT_EQ(finding_of("io:0xd010").verdict, Verdict::ok) << "the lock goes with the core";
}

TEST_F(RawPorts, HeldByAnotherProgramThatHeedsTheDeviceAreSeenToo) {
    hide_device();
    const auto others = port::lock_range(files().path_of("/dev/port"), 0x378, kPortRegisters);
    ASSERT_TRUE(others && *others);
    EXPECT_EQ(finding_of("io:0x378").seen, "held by another program");
    ::close(**others);
    EXPECT_EQ(finding_of("io:0x378").verdict, Verdict::ok);
}

TEST_F(RawPorts, OfTwoCoresNameEachItsOwn) {
    const OpeningCore core{0x378, files()};
    kernel_has(0x278);
    const OpeningCore other{0x278, files()};
    ASSERT_TRUE(core.has_lock());
    ASSERT_TRUE(other.has_lock());
    without_port();
    EXPECT_EQ(finding_of("io:0x378").seen, core.held_by());
    EXPECT_EQ(finding_of("io:0x278").seen, other.held_by());
}

TEST_F(RawPorts, AreAskedForWithoutTakingThem) {
    hide_device();
    EXPECT_EQ(finding_of("io:0x378").verdict, Verdict::ok);
    put("/dev/parport0", "");
    const OpeningCore core{0x378, files()};
    EXPECT_TRUE(core.has_lock());
}

}  // namespace
}  // namespace psicarve::doctor
