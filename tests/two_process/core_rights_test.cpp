// SPDX-License-Identifier: GPL-3.0-or-later
// What a core keeps of its privileges, and where its threads run.
#include <sched.h>

#include <filesystem>

#include "tests/two_process/kernel_facts.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

class CoreRights : public PortRig {
protected:
    /// Only what its limits cannot replace, and it has said so.
    void expect_no_privileges(pid_t process) {
        const std::string said = text_of(file("core.err"));
        const unsigned long long allowed = said.find(" stays: ") != std::string::npos ? kReplacedByLimits : 0;
        for (const pid_t thread : threads_of(process)) {
            auto facts = kernel_facts(process, thread);
            for (const char* set : {"CapInh", "CapPrm", "CapEff", "CapAmb"}) {
                EXPECT_EQ(std::stoull(facts[set], nullptr, 16) & ~allowed, 0U) << set << ' ' << facts["Name"];
            }
            if (geteuid() != 0) continue;
            EXPECT_EQ(std::stoull(facts["CapBnd"], nullptr, 16) & ~allowed, 0U) << facts["Name"];
            EXPECT_EQ(facts["NoNewPrivs"], "1") << facts["Name"];
        }
    }
};

TEST_F(CoreRights, CoreAndGuardOfARealPortKeepNoPrivilege) {
    home_by_one_sensor();
    start_port_core();
    ASSERT_TRUE(eventually([&] { return status().tick > 10; }));
    expect_no_privileges(core_pid_);
    expect_no_privileges(core_->pid());
    const bool says_root = text_of(file("core.err")).find("goes on as root") != std::string::npos;
    EXPECT_EQ(says_root, geteuid() == 0) << text_of(file("core.err"));
    // And all goes on: it moves, and makes files of its own.
    home();
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
}

TEST_F(CoreRights, ASimulatorKeepsNoneEither) {
    start_core({"--trace", file("pins.trace")});
    expect_no_privileges(core_->pid());
    home();
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
    EXPECT_GT(std::filesystem::file_size(file("pins.trace")), 1000U);
}

TEST_F(CoreRights, NoOutputGoesThroughALink) {
    std::ofstream{file("precious")} << "precious";
    std::filesystem::create_symlink(file("precious"), file("trace"));
    std::filesystem::create_symlink(file("precious"), file("late.csv"));
    CoreProcess refused{{"--segment", segment_name_, "--clock", "virtual", "--trace", file("trace")},
                        file("core.err")};
    EXPECT_NE(refused.wait_for_exit(), 0);
    EXPECT_NE(text_of(file("core.err")).find("symbolic link"), std::string::npos);
    EXPECT_EQ(text_of(file("precious")), "precious");
    std::filesystem::create_hard_link(file("precious"), file("hard"));
    CoreProcess hard{{"--segment", segment_name_, "--clock", "virtual", "--trace", file("hard")},
                     file("core.err")};
    EXPECT_NE(hard.wait_for_exit(), 0);
    EXPECT_NE(text_of(file("core.err")).find("hard link"), std::string::npos);
    EXPECT_EQ(text_of(file("precious")), "precious");
    std::filesystem::create_symlink(file("precious"), file("times.csv"));
    start_core({"--profile", file("machine.toml"), "--layer-times", file("times.csv")});
    home();
    ASSERT_EQ(publish(coarse_job(2)), "");
    EXPECT_TRUE(eventually([&] { return !std::filesystem::is_symlink(file("times.csv")); }));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    core_->wait_for_exit();
    EXPECT_EQ(text_of(file("precious")), "precious");
    core_.reset();

    core_ = std::make_unique<CoreProcess>(
        std::vector<std::string>{"--segment", segment_name_, "--clock", "real", "--profile",
                                 file("machine.toml"), "--lateness", file("late.csv")},
        file("core.err"));
    attach();
    ASSERT_TRUE(eventually([&] { return segment_->core_pid() && status().tick > 10; }));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
    EXPECT_EQ(text_of(file("precious")), "precious") << "the link was replaced, not followed";
    EXPECT_FALSE(std::filesystem::is_symlink(file("late.csv")));
}

TEST_F(CoreRights, NoThreadButTheTickRunsOnItsProcessor) {
    cpu_set_t allowed;
    ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
    if (CPU_COUNT(&allowed) < 2) GTEST_SKIP() << "needs two processors";
    int cpu = CPU_SETSIZE - 1;
    while (!CPU_ISSET(cpu, &allowed)) --cpu;
    core_ = std::make_unique<CoreProcess>(
        std::vector<std::string>{"--segment", segment_name_, "--clock", "real", "--profile",
                                 file("machine.toml"), "--capacity", "100x20", "--cpu", std::to_string(cpu)},
        file("core.err"));
    attach();
    ASSERT_TRUE(eventually([&] { return segment_->core_pid() && status().tick > 10; }));
    // The estimator thinks about it.
    ASSERT_EQ(publish(coarse_job(40)), "");
    int on_it = 0;
    const auto threads = threads_of(core_->pid());
    EXPECT_GE(threads.size(), 4U);
    for (const pid_t thread : threads) {
        cpu_set_t of_thread;
        ASSERT_EQ(sched_getaffinity(thread, sizeof of_thread, &of_thread), 0);
        if (!CPU_ISSET(cpu, &of_thread)) continue;
        ++on_it;
        EXPECT_EQ(CPU_COUNT(&of_thread), 1) << "a thread that may run anywhere";
    }
    EXPECT_EQ(on_it, 1);
}

}  // namespace
}  // namespace psicarve::two_process
