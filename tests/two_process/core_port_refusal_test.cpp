// SPDX-License-Identifier: GPL-3.0-or-later
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <cerrno>

#include "shared/computer/kernel_ports.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

struct Refused {
    int exit_code;
    std::string said;
};

class CorePortRefusal : public PortRig {
protected:
    Refused start_refused(const std::vector<std::string>& more, bool on_fake_port = true) {
        std::optional<fake_port::FakePortFile::Preload> preload;
        if (on_fake_port) preload.emplace(port_);
        std::vector<std::string> arguments{"--segment", segment_name_, "--capacity", "100x20"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        CoreProcess core{arguments, file("refused.err")};
        const int exit_code = core.wait_for_exit();
        return {exit_code, text_of(file("refused.err"))};
    }
    Refused start_on(const std::string& port, bool on_fake_port = true) {
        return start_refused({"--port", port, "--allow-no-realtime"}, on_fake_port);
    }
    std::string ppdev() const { return "ppdev:" + port_.device(); }
};

void expect_one_line_with(const Refused& refused, int exit_code, const std::string& words) {
    EXPECT_EQ(refused.exit_code, exit_code) << refused.said;
    EXPECT_NE(refused.said.find(words), std::string::npos) << refused.said;
    EXPECT_EQ(std::count(refused.said.begin(), refused.said.end(), '\n'), 1) << refused.said;
}

TEST_F(CorePortRefusal, EveryReasonIsOneLineWithItsRemedy) {
    expect_one_line_with(start_on("parallel"), 2, "no such kind of port");
    expect_one_line_with(start_on("io:888"), 2, "not a hexadecimal address");
    expect_one_line_with(start_on("io:0x12378"), 2, "not a hexadecimal address");
    expect_one_line_with(start_on("io:0x3f8"), 2, "the kernel lists no parallel port there");
    expect_one_line_with(start_on("ppdev:parport0"), 2, "not the path of a device");
    expect_one_line_with(start_on("ppdev:/dev/no/parport0", false), 4, "modprobe");
    expect_one_line_with(start_on("ppdev:/dev/null", false), 4, "is not a parallel port");
    expect_one_line_with(start_on(ppdev(), false), 4, "is not a parallel port");
    port_.state().control.store(safe().control);
    port_.state().open_errno.store(EACCES);
    expect_one_line_with(start_on(ppdev()), 4, "usermod -aG " + group_of(port_.device()));
    port_.state().open_errno.store(ENXIO);
    expect_one_line_with(start_on(ppdev()), 4, "no parallel port is behind it");
    port_.state().open_errno.store(0);
    port_.state().claim_errno.store(ENXIO);
    expect_one_line_with(start_on(ppdev()), 4, "busy");
    port_.state().claim_errno.store(0);
    port_.state().modes.store(0);
    expect_one_line_with(start_on(ppdev()), 4, "no registers");
    EXPECT_EQ(port_.state().write_count.load(), 0U) << "nothing was written before it was refused";
    EXPECT_EQ(port_.state().control.load(), safe().control) << "what is refused was not claimed either";
}

TEST_F(CorePortRefusal, ARealPortTakesNoVirtualClockNoOtherMachineAndNoReplayFromNowhere) {
    const auto refused = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"--port", ppdev(), "--allow-no-realtime"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return start_refused(arguments);
    };
    expect_one_line_with(refused({"--clock", "virtual"}), 2, "real time");
    expect_one_line_with(refused({"--machine", file("machine.toml")}), 2, "simulated machine");
    expect_one_line_with(refused({"--replay", file("machine.toml")}), 2, "--assume-homed");
    EXPECT_EQ(port_.state().claimed_by.load(), 0U);
}

TEST_F(CorePortRefusal, WhatWouldBeIgnoredIsRefused) {
    expect_one_line_with(start_refused({"--clock", "virtual", "--lateness", file("late.csv")}), 2,
                         "--clock real");
    expect_one_line_with(start_refused({"--clock", "virtual", "--cpu", "0"}), 2, "--clock real");
    expect_one_line_with(start_refused({"--assume-homed"}), 2, "--replay");
    expect_one_line_with(start_refused({"--seconds", "3"}), 2, "--measure-latency");
    expect_one_line_with(start_refused({"--measure-latency", "--cpu", "5000"}), 2, "no such processor");
}

TEST_F(CorePortRefusal, APortThatTakesNoWriteIsRefusedWithWhatMayBeOn) {
    fail_port(EIO, -1);
    const Refused refused = start_on(ppdev());
    EXPECT_EQ(refused.exit_code, 4);
    EXPECT_NE(refused.said.find("does not take"), std::string::npos) << refused.said;
    EXPECT_NE(refused.said.find("spindle"), std::string::npos) << refused.said;
    EXPECT_NE(refused.said.find("y_enable"), std::string::npos) << refused.said;
    EXPECT_NE(refused.said.find("its own switch"), std::string::npos) << refused.said;
}

// The claim itself has switched the spindle on.
TEST_F(CorePortRefusal, HoweverManyAccessesFailAtOpeningTheSafeStateFollowsTheClaim) {
    const auto all_faults =
        test::is_thorough() ? std::vector<std::int64_t>{1, 2, 5, 50} : std::vector<std::int64_t>{1, 5};
    for (const std::int64_t good : {0, 1, 2}) {
        for (const std::int64_t faults : all_faults) {
            port_.state().fault_errno.store(EIO);
            port_.state().faults.store(faults);
            port_.state().accesses_to_fault.store(good);
            const fake_port::FakePortFile::Preload preload{port_};
            CoreProcess core{port_arguments(segment_name_), file("opening.err")};
            EXPECT_TRUE(eventually([&] { return port_.state().write_count.load() > 0 && is_safe(); }))
                << faults << " faults after " << good << ": " << text_of(file("opening.err"));
            EXPECT_TRUE(eventually([&] { return port_.state().faults.load() == 0; }));
            core.send_signal(SIGTERM);
            core.wait_for_exit();
            expect_safe_registers();
            port_.state().write_count.store(0);
        }
    }
}

TEST_F(CorePortRefusal, AnOrderToEndWaitsUntilTheClaimedPortIsSafe) {
    fail_port(EIO, -1);
    const fake_port::FakePortFile::Preload preload{port_};
    CoreProcess core{port_arguments(segment_name_), file("opening.err")};
    ASSERT_TRUE(eventually([&] { return port_.state().claimed_by.load() != 0; }));
    ASSERT_TRUE(eventually([&] {
        return text_of(file("opening.err")).find("does not take") != std::string::npos;
    })) << "it is said while it lasts";
    for (const int number : {SIGTERM, SIGINT, SIGHUP, SIGTSTP}) core.send_signal(number);
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
    EXPECT_FALSE(is_safe());
    mend_port();
    ASSERT_TRUE(eventually([&] { return is_safe(); })) << text_of(file("opening.err"));
    core.send_signal(SIGCONT);
    EXPECT_GT(core.wait_for_exit(), 128);
    expect_safe_registers();
}

TEST_F(CorePortRefusal, WhatFailsAfterTheClaimLeavesTheSafeState) {
    port_.state().direction_errno.store(EIO);
    expect_one_line_with(start_on(ppdev()), 4, "cannot be claimed");
    expect_safe_registers();
}

TEST_F(CorePortRefusal, WithoutRealTimeRightsItIsRefusedBeforeThePortIsTouched) {
    const pid_t child = fork();
    if (child == 0) {
        // Neither root's right nor the limit's.
        prctl(PR_CAPBSET_DROP, CAP_SYS_NICE);
        const rlimit none{0, 0};
        setrlimit(RLIMIT_RTPRIO, &none);
        const fake_port::FakePortFile::Preload preload{port_};
        const Refused refused = start_refused({"--port", ppdev()});
        const bool is_right = refused.exit_code == 4 &&
                              refused.said.find("--allow-no-realtime") != std::string::npos &&
                              refused.said.find("limits.d") != std::string::npos;
        _exit(is_right ? 0 : 1);
    }
    int wait_status = 0;
    waitpid(child, &wait_status, 0);
    EXPECT_TRUE(WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == 0) << text_of(file("refused.err"));
    EXPECT_EQ(port_.state().write_count.load(), 0U);
}

}  // namespace
}  // namespace psicarve::two_process
