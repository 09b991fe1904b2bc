// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <stop_token>
#include <thread>

#include "shared/machine/jog_lease.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

class CoreMoves : public CoreRig {
protected:
    std::string refusal_of_command(const Command& command) {
        const auto sent = send_command(*segment_, command, kLimit);
        return sent ? std::string{} : sent.error().message;
    }
    void move_heads(double r1_mm, double y_mm) {
        Command command{};
        command.kind = CommandKind::move;
        command.axis = 0b1001;
        command.target[0] = r1_mm;
        command.target[3] = y_mm;
        ASSERT_EQ(refusal_of_command(command), "");
        ASSERT_TRUE(reaches(MachineState::ready));
    }
    /// On the real clock this is long enough for a computer that is busy with other programs.
    static constexpr std::uint32_t kLongLease_ms = 2000;
    void jog_on(Axis axis, std::uint32_t token, std::uint32_t lease_ms = kLongLease_ms) {
        Command command{};
        command.kind = CommandKind::jog_on;
        command.axis = static_cast<std::uint32_t>(index_of(axis));
        command.value = 1.0;
        command.lease_token = token;
        command.lease_ms = lease_ms;
        ASSERT_EQ(refusal_of_command(command), "");
    }
};

TEST_F(CoreMoves, ALeaseThatNobodyRenewsEndsOnTheVirtualClockToo) {
    start_core();
    home();
    jog_on(Axis::psi, 5, 200);
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(status().move_end, MoveEnd::lease_gone);
    EXPECT_GT(status().position_pulses[index_of(Axis::psi)], 0);
}

TEST_F(CoreMoves, AJogIsKeptGoingByItsHolderForLongerThanItsLease) {
    start_core();
    home();
    jog_on(Axis::psi, 5);
    const auto begin = std::chrono::steady_clock::now();
    std::int64_t seen = 0;
    for (std::uint32_t beat = 1; std::chrono::steady_clock::now() - begin < 1.5 * milliseconds{kLongLease_ms};
         ++beat) {
        write_jog_lease(*segment_, 5, beat);
        ASSERT_TRUE(eventually([&] { return status().position_pulses[2] > seen + 1000; }));
        ASSERT_EQ(status().state, MachineState::moving);
        write_jog_lease(*segment_, 6,
                        0);  // another holder's: it ends nothing, for several of the core's looks
        seen = status().position_pulses[2];
        ASSERT_TRUE(eventually([&] {
            return status().position_pulses[2] > seen + 10'000 || status().state == MachineState::ready;
        }));
        ASSERT_EQ(status().state, MachineState::moving);
        seen = status().position_pulses[2];
    }
    write_jog_lease(*segment_, 5, 0);
    ASSERT_TRUE(reaches(MachineState::ready));
    EXPECT_EQ(status().move_end, MoveEnd::released);
}

/// Has the core run for a moment and stand still for longer, again and again.
class Stutter {
public:
    explicit Stutter(pid_t core) : core_(core), thread_([this](const std::stop_token& end) { run(end); }) {}

private:
    void run(const std::stop_token& end) const {
        while (!end.stop_requested()) {
            kill(core_, SIGSTOP);
            std::this_thread::sleep_for(milliseconds{5});
            kill(core_, SIGCONT);
            std::this_thread::sleep_for(std::chrono::microseconds{100});
        }
    }

    pid_t core_;
    std::jthread thread_;
};

// The lease of the jog before, however short it was, is over and done with.
TEST_F(CoreMoves, AJogIsJudgedByItsOwnLeaseFromItsFirstTick) {
    start_core();
    home();
    const Stutter stutter{core_->pid()};
    for (std::uint32_t token = 1; token <= 20; ++token) {
        SCOPED_TRACE(token);
        jog_on(Axis::psi, 2 * token, 1);
        ASSERT_TRUE(reaches(MachineState::ready));
        ASSERT_EQ(status().move_end, MoveEnd::lease_gone);
        const std::int64_t before = status().position_pulses[2];
        jog_on(Axis::psi, 2 * token + 1);
        std::uint32_t beat = 0;
        ASSERT_TRUE(eventually([&] {
            write_jog_lease(*segment_, 2 * token + 1, ++beat);
            return status().position_pulses[2] > before + 1000 || status().state == MachineState::ready;
        }));
        write_jog_lease(*segment_, 2 * token + 1, 0);
        ASSERT_TRUE(reaches(MachineState::ready));
        ASSERT_EQ(status().move_end, MoveEnd::released);
    }
}

TEST_F(CoreMoves, AJogIsKeptGoingByNobodyElse) {
    start_core();
    home();
    jog_on(Axis::psi, 5, 200);
    std::uint32_t beat = 0;
    EXPECT_TRUE(eventually([&] {
        write_jog_lease(*segment_, 6, ++beat);
        return status().state == MachineState::ready;
    }));
    EXPECT_EQ(status().move_end, MoveEnd::lease_gone);
}

TEST_F(CoreMoves, AreAppliedAgainByAReplay) {
    start_core();
    ASSERT_EQ(publish(lobed_job(3, 33)), "");
    home();
    move_heads(30.0, 12.5);
    jog_on(Axis::psi, 7);
    ASSERT_TRUE(eventually([&] { return status().position_pulses[2] > 5000; }));
    write_jog_lease(*segment_, 7, 0);
    ASSERT_TRUE(reaches(MachineState::ready));
    move_heads(20.0, 3.0);
    const CoreStatus end = status();

    Snapshot snapshot;
    snapshot.status = end;
    RingReader reader{segment_->header().recorder};
    while (const auto record = reader.next()) snapshot.records.push_back(*record);
    snapshot.job_blob = job_blob_from_table(lobed_job(3, 33));
    ASSERT_TRUE(save_snapshot(snapshot, file("snapshot")));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);

    CoreProcess replay{{"--segment", segment_name_, "--clock", "virtual", "--replay", file("snapshot")},
                       file("replay.err")};
    ASSERT_EQ(replay.wait_for_exit(), 0) << text_of(file("replay.err"));
    attach();
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ(status().position_pulses[index_of(axis)], end.position_pulses[index_of(axis)])
            << name_of(axis);
    }
    EXPECT_GT(end.position_pulses[2], 5000);
}

}  // namespace
}  // namespace psicarve::two_process
