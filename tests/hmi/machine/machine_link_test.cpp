// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/machine_link.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "hmi/machine/jog.hpp"
#include "hmi/machine/snapshot_taker.hpp"
#include "shared/base/message_text.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/two_process/child_process.hpp"

namespace psicarve::machine {
namespace {

using std::chrono::milliseconds;
using test::ChildProcess;

/// A process that serves a segment: writes a status again and again, answers every command by `act`. Ends in
/// order once it has answered the command back_off.
class ScriptedCore {
public:
    using Act = std::function<Message(const Command&, CoreStatus&)>;  // why it is refused, or none

    ScriptedCore(const std::string& segment_name, MachineState state, Act act)
        : child_([=](ChildProcess::Signal serving) {
              SegmentOptions options;
              options.name = segment_name;
              options.capacity_layers = 4;
              options.capacity_points = 8;
              auto segment = Segment::create_or_attach(options);
              if (!segment || !segment->claim_core()) return;
              CoreStatus status{};
              status.state = state;
              status.period_ns = 50'000;
              bool is_serving = false;
              for (;;) {
                  if (const auto command = take_command(*segment)) {
                      const Message why = act(command->command, status);
                      write(*segment, status);
                      answer_command(*segment, *command,
                                     why.is_none() ? AnswerKind::done : AnswerKind::refused, why);
                      if (command->command.kind == CommandKind::back_off) break;
                  }
                  if (segment->header().stop_requests.load() > 0) status.state = MachineState::ready;
                  write(*segment, status);
                  if (!is_serving) serving.raise();
                  is_serving = true;
                  std::this_thread::sleep_for(milliseconds{2});
              }
              write(*segment, status);
              segment->release_core();
          }) {
        EXPECT_TRUE(child_.wait_for_signal());
    }
    ChildProcess& process() { return child_; }

private:
    static void write(Segment& segment, CoreStatus& status) {
        ++status.heartbeat;
        write_record(segment.header().status, status);
    }
    ChildProcess child_;
};

class MachineLinkTest : public ::testing::Test {
protected:
    MachineLinkTest() {
        static std::atomic<int> count{0};
        name_ = "/psicarve-link-test-" + std::to_string(getpid()) + "-" + std::to_string(++count);
    }
    ~MachineLinkTest() override { (void)Segment::remove(name_); }

    MachineLink attached() {
        auto link = MachineLink::attach(name_);
        EXPECT_TRUE(link.has_value()) << link.error().message;
        return std::move(link).value();
    }
    /// A command that is answered by a core that has ended when this returns.
    static void send_last(MachineLink& link) {
        ASSERT_TRUE(link.send(CommandKind::back_off).has_value());
        while (link.core_pid()) std::this_thread::sleep_for(milliseconds{1});
    }
    static ScriptedCore::Act goes_to(MachineState state) {
        return [state](const Command&, CoreStatus& status) {
            status.state = state;
            return Message{};
        };
    }

    std::string name_;
};

TEST_F(MachineLinkTest, NoSegmentMeansNoCore) {
    const auto link = MachineLink::attach(name_);
    ASSERT_FALSE(link.has_value());
    EXPECT_EQ(link.error().code, ErrorCode::no_core);
}

TEST_F(MachineLinkTest, AnAnsweredCommandIsFollowedByTheStateItLedTo) {
    ScriptedCore core{name_, MachineState::off, goes_to(MachineState::ready)};
    MachineLink sut = attached();
    ASSERT_TRUE(sut.send(CommandKind::home).has_value());
    const auto status = sut.wait_for_state({MachineState::ready});
    ASSERT_TRUE(status.has_value()) << status.error().message;
    EXPECT_EQ(status->state, MachineState::ready);
}

TEST_F(MachineLinkTest, ARefusalCarriesTheCoresReason) {
    ScriptedCore core{name_, MachineState::off,
                      [](const Command&, CoreStatus&) { return message_of(MessageId::not_homed); }};
    MachineLink sut = attached();
    const auto sent = sut.send(CommandKind::start);
    ASSERT_FALSE(sent.has_value());
    EXPECT_EQ(sent.error().code, ErrorCode::machine_refused);
    EXPECT_NE(sent.error().message.find("home first"), std::string::npos);
    EXPECT_EQ(sent.error().said.id, MessageId::not_homed);
}

TEST_F(MachineLinkTest, AMessageWithALongTextArrivesWholeFromTheOtherProcess) {
    const std::string text = std::string(94, 'n') + "_Ψ-end";
    const Message said = with_text(message_of(MessageId::core_silent, count_argument(4711)), text);
    ScriptedCore core{name_, MachineState::off, [said](const Command&, CoreStatus&) { return said; }};
    MachineLink sut = attached();
    const auto sent = sut.send(CommandKind::start);
    ASSERT_FALSE(sent.has_value());
    EXPECT_GT(text.size(), 100U);
    EXPECT_EQ(std::memcmp(&sent.error().said, &said, sizeof said), 0);
    EXPECT_NE(sent.error().message.find(text), std::string::npos) << sent.error().message;
}

// Written before the answer, the new lease would hide that the holder before lets go.
TEST_F(MachineLinkTest, AJogTakesTheLeaseOnceItIsAccepted) {
    ScriptedCore core{name_, MachineState::ready, [count = 0](const Command&, CoreStatus&) mutable {
                          return count++ == 0 ? message_of(MessageId::overtaken) : Message{};
                      }};
    MachineLink sut = attached();
    write_jog_lease(sut.segment(), 7, 0);
    const auto word = [&] { return sut.segment().header().jog_lease.load(); };
    ASSERT_FALSE(HeldJog::on(sut, Axis::r1, true, 0.0).has_value());
    EXPECT_EQ(word(), jog_lease_word(7, 0));
    const auto jog = HeldJog::on(sut, Axis::r1, true, 0.0);
    ASSERT_TRUE(jog.has_value()) << jog.error().message;
    EXPECT_NE(jog_lease_token(word()), 7U);
    EXPECT_NE(jog_lease_beat(word()), 0U);
}

TEST_F(MachineLinkTest, AnAlarmEndsAWaitAndIsNamed) {
    ScriptedCore core{name_, MachineState::ready, [](const Command&, CoreStatus& status) {
                          status.state = MachineState::alarm;
                          status.alarm_cause = AlarmCause::limit;
                          status.alarm_axis = static_cast<std::uint8_t>(Axis::r2);
                          return Message{};
                      }};
    MachineLink sut = attached();
    ASSERT_TRUE(sut.send(CommandKind::start).has_value());
    const auto status = sut.wait_for_state({MachineState::waiting});
    ASSERT_FALSE(status.has_value());
    EXPECT_EQ(status.error().code, ErrorCode::machine_refused);
    EXPECT_NE(status.error().message.find("limit of r2"), std::string::npos) << status.error().message;
}

TEST_F(MachineLinkTest, ComingToRestElsewhereEndsAWait) {
    ScriptedCore core{name_, MachineState::ready, goes_to(MachineState::positioning)};
    MachineLink sut = attached();
    ASSERT_TRUE(sut.send(CommandKind::start).has_value());
    sut.stop();
    const auto status = sut.wait_for_state({MachineState::waiting});
    ASSERT_FALSE(status.has_value());
    EXPECT_NE(status.error().message.find("'ready', not waiting"), std::string::npos)
        << status.error().message;
}

TEST_F(MachineLinkTest, ACoreThatDiesEndsAWait) {
    ScriptedCore core{name_, MachineState::ready, goes_to(MachineState::carving)};
    MachineLink sut = attached();
    ASSERT_TRUE(sut.send(CommandKind::start).has_value());
    int seen = 0;
    const auto status = sut.wait_for_state({MachineState::ready}, [&](const CoreStatus&) -> Result<void> {
        if (++seen == 3) core.process().kill();
        return {};
    });
    ASSERT_FALSE(status.has_value());
    EXPECT_EQ(status.error().code, ErrorCode::no_core);
    // What it left behind can still be read.
    EXPECT_EQ(sut.last_status()->state, MachineState::carving);
    EXPECT_FALSE(sut.core_pid().has_value());
}

// As the one of a simulated run, whose end may come before the sender of a command looks again.
TEST_F(MachineLinkTest, ACommandIsDoneThoughItsCoreHasEndedInOrderSince) {
    ScriptedCore core{name_, MachineState::held, goes_to(MachineState::ready)};
    MachineLink sut = attached();
    send_last(sut);
    const auto status = sut.status_after_answer();
    ASSERT_TRUE(status.has_value()) << status.error().message;
    EXPECT_EQ(status->state, MachineState::ready);
    EXPECT_EQ(sut.status().error().code, ErrorCode::no_core);
    EXPECT_TRUE(sut.wait_for_state({MachineState::ready}).has_value());
    EXPECT_TRUE(sut.wait_after_stop({MachineState::ready}, milliseconds{5000}).has_value());
    EXPECT_EQ(sut.wait_for_state({MachineState::carving}).error().code, ErrorCode::no_core);
    EXPECT_EQ(sut.wait_after_stop({MachineState::alarm}, milliseconds{5000}).error().code,
              ErrorCode::no_core);
}

TEST_F(MachineLinkTest, ACommandOfACoreThatHasDiedSinceIsNotKnownToBeDone) {
    ScriptedCore core{name_, MachineState::held, goes_to(MachineState::ready)};
    MachineLink sut = attached();
    ASSERT_TRUE(sut.send(CommandKind::resume).has_value());
    core.process().kill();
    EXPECT_EQ(sut.status_after_answer().error().code, ErrorCode::no_core);
    EXPECT_EQ(sut.wait_for_state({MachineState::ready}).error().code, ErrorCode::no_core);
    EXPECT_EQ(sut.wait_after_stop({MachineState::ready}, milliseconds{5000}).error().code,
              ErrorCode::no_core);
}

TEST_F(MachineLinkTest, ACoreThatStandsStillIsSilent) {
    ScriptedCore core{name_, MachineState::ready, goes_to(MachineState::ready)};
    MachineLink sut = attached();
    core.process().stop();
    const auto status = sut.status();
    ASSERT_FALSE(status.has_value());
    EXPECT_EQ(status.error().code, ErrorCode::no_core);
    EXPECT_NE(status.error().message.find("silent"), std::string::npos) << status.error().message;
}

TEST_F(MachineLinkTest, AWatchCanEndAWait) {
    ScriptedCore core{name_, MachineState::carving, goes_to(MachineState::carving)};
    MachineLink sut = attached();
    const auto status = sut.wait_for_state({MachineState::ready}, [](const CoreStatus&) -> Result<void> {
        return Error{ErrorCode::cancelled, "enough"};
    });
    ASSERT_FALSE(status.has_value());
    EXPECT_EQ(status.error().code, ErrorCode::cancelled);
}

TEST_F(MachineLinkTest, ASnapshotOfADeadCoreHoldsItsLastStatus) {
    {
        ScriptedCore core{name_, MachineState::held, goes_to(MachineState::held)};
        core.process().kill();
    }
    MachineLink link = attached();
    const auto snapshot = take_snapshot(link, milliseconds{5000});
    ASSERT_TRUE(snapshot.has_value()) << snapshot.error().message;
    ASSERT_TRUE(snapshot->status.has_value());
    EXPECT_EQ(snapshot->status->state, MachineState::held);
    EXPECT_TRUE(snapshot->job_blob.empty());
}

}  // namespace
}  // namespace psicarve::machine
