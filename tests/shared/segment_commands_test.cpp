// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/segment_commands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <thread>
#include <vector>

#include "shared/base/message_text.hpp"
#include "shared/computer/event.hpp"
#include "shared/computer/process_identity.hpp"
#include "shared/segment/segment.hpp"
#include "tests/shared/segment_fixture.hpp"

namespace psicarve {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

class SegmentCommands : public test::SegmentOfTwo {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(SegmentOfTwo::SetUp());
        ASSERT_TRUE(core_->claim_core().has_value());
    }
    /// Takes the command of a sender that waits for longer than this does.
    ReceivedCommand take() {
        const auto end = std::chrono::steady_clock::now() + milliseconds{50'000};
        while (std::chrono::steady_clock::now() < end) {
            if (auto command = take_command(*core_)) return *command;
            std::this_thread::yield();
        }
        ADD_FAILURE() << "nobody has sent a command";
        return {};
    }
    void put(std::size_t slot, SlotState state, std::uint32_t pid) {
        core_->header().commands[slot].state_and_sender.store((std::uint64_t{pid} << 32) |
                                                              static_cast<std::uint32_t>(state));
    }
    std::size_t used_slots() {
        std::size_t used = 0;
        for (const CommandSlot& slot : core_->header().commands) used += slot.state_and_sender.load() != 0;
        return used;
    }
};

TEST_F(SegmentCommands, AnswerDoneReachesTheSender) {
    Result<void> result = bad_input("not sent");
    const Command command{.kind = CommandKind::back_off, .axis = 2, .value = 1.5, .value2 = 9};
    std::thread sender{[&] { result = send_command(*hmi_, command, milliseconds{60'000}); }};

    const ReceivedCommand received = take();
    answer_command(*core_, received, AnswerKind::done);
    sender.join();

    EXPECT_TRUE(result.has_value());
    EXPECT_EQ(received.command.kind, CommandKind::back_off);
    EXPECT_EQ(received.command.axis, 2U);
    EXPECT_EQ(received.command.value, 1.5);
    EXPECT_EQ(received.command.value2, 9U);
    EXPECT_EQ(received.sender_pid, own_pid());
    EXPECT_EQ(used_slots(), 0U);
}

TEST_F(SegmentCommands, TellWhichStopsTheirSenderHadSeen) {
    for (int i = 0; i < 2; ++i) request_stop(*core_);
    for (int i = 0; i < 3; ++i) request_emergency_stop(*core_);
    std::thread sender{[&] { (void)send_command(*hmi_, Command{}, milliseconds{60'000}); }};

    const ReceivedCommand received = take();
    request_stop(*core_);
    answer_command(*core_, received, AnswerKind::done);
    sender.join();

    EXPECT_EQ(received.stops_seen.stops, 2U);
    EXPECT_EQ(received.stops_seen.emergency_stops, 3U);
    EXPECT_EQ(stops_seen(*hmi_).stops, 3U);
}

TEST_F(SegmentCommands, RefusalReachesTheSenderWhole) {
    Result<void> result;
    std::thread sender{[&] {
        result = send_command(*hmi_, {CommandKind::home, 0, 0, 0}, milliseconds{60'000});
    }};

    const std::string name(100, 'x');
    const Message silent = with_text(message_of(MessageId::core_silent, count_argument(4711)), name);
    answer_command(*core_, take(), AnswerKind::refused, silent);
    sender.join();

    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::machine_refused);
    EXPECT_EQ(
        result.error().message,
        "the core of segment " + name + " (pid 4711) is silent: its heartbeat stands still; is it stopped?");
    EXPECT_EQ(std::memcmp(&result.error().said, &silent, sizeof silent), 0);
}

TEST_F(SegmentCommands, RefusalWithoutAMessageSaysThatThereIsNone) {
    Result<void> result;
    std::thread sender{[&] {
        result = send_command(*hmi_, {CommandKind::home, 0, 0, 0}, milliseconds{60'000});
    }};

    answer_command(*core_, take(), AnswerKind::refused);
    sender.join();

    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().said.id, MessageId::no_reason);
}

TEST_F(SegmentCommands, WithoutACoreNothingIsSent) {
    core_->release_core();

    const auto result = send_command(*hmi_, {CommandKind::home, 0, 0, 0}, milliseconds{60'000});

    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::no_core);
    EXPECT_EQ(used_slots(), 0U);
}

TEST_F(SegmentCommands, CommandThatNobodyTookIsTakenBackAtTheLimit) {
    const auto result = send_command(*hmi_, {CommandKind::home, 0, 0, 0}, milliseconds{5});

    EXPECT_EQ(result.error().code, ErrorCode::timed_out);
    EXPECT_FALSE(take_command(*core_).has_value());
    EXPECT_EQ(used_slots(), 0U);
}

TEST_F(SegmentCommands, SlotOfASenderThatGaveUpAfterItWasTakenIsFreedByTheAnswer) {
    Result<void> result;
    // Once more, but not forever, where this computer stands still for so long that no core took it in time,
    // and the sender took it back.
    std::thread sender{[&] {
        for (int tries = 0; tries < 100; ++tries) {
            result = send_command(*hmi_, {CommandKind::home, 0, 0, 0}, milliseconds{200});
            if (used_slots() != 0U) break;
        }
    }};
    const ReceivedCommand received = take();
    sender.join();
    EXPECT_EQ(result.error().code, ErrorCode::timed_out);
    EXPECT_EQ(used_slots(), 1U);

    answer_command(*core_, received, AnswerKind::done);

    EXPECT_EQ(used_slots(), 0U);
}

TEST_F(SegmentCommands, OldestComesFirstWhereverItStands) {
    for (const std::size_t slot : {5U, 3U, 9U}) {
        core_->header().commands[slot].sequence.store(100 - slot);
        put(slot, SlotState::pending, own_pid());
    }

    EXPECT_EQ(take().slot, 9U);
    EXPECT_EQ(take().slot, 5U);
    EXPECT_EQ(take().slot, 3U);
}

TEST_F(SegmentCommands, AllSlotsInUseIsSaidClearly) {
    for (std::size_t slot = 0; slot < kCommandSlots; ++slot) put(slot, SlotState::taken, own_pid());

    const auto result = send_command(*hmi_, {CommandKind::home, 0, 0, 0}, milliseconds{60'000});

    ASSERT_FALSE(result.has_value());
    EXPECT_THAT(result.error().message, HasSubstr("all 64 command slots are in use"));
}

TEST_F(SegmentCommands, SlotsOfSendersThatAreNoMoreAreFreed) {
    constexpr std::uint32_t kNoSuchPid = 0x3FFFFFF0;
    std::size_t slot = 0;
    for (const SlotState state :
         {SlotState::writing, SlotState::pending, SlotState::taken, SlotState::answered}) {
        put(slot++, state, kNoSuchPid);
    }

    EXPECT_FALSE(take_command(*core_).has_value());
    EXPECT_EQ(used_slots(), 0U);
}

TEST_F(SegmentCommands, SlotWhosePidNowBelongsToAnotherProcessIsFreed) {
    put(0, SlotState::pending, own_pid());
    core_->header().commands[0].sender_start_time.store(process_start_time(own_pid()) + 1);

    EXPECT_FALSE(take_command(*core_).has_value());
    EXPECT_EQ(used_slots(), 0U);
}

TEST_F(SegmentCommands, NewCoreRefusesWhatTheDeadOneWasAsked) {
    Result<void> result;
    std::thread sender{[&] {
        result = send_command(*hmi_, {CommandKind::home, 0, 0, 0}, milliseconds{60'000});
    }};
    (void)take();

    clear_commands_of_dead_core(core_->header());
    sender.join();

    ASSERT_FALSE(result.has_value());
    EXPECT_THAT(result.error().message, HasSubstr("the core was replaced"));
    EXPECT_EQ(used_slots(), 0U);
}

TEST_F(SegmentCommands, NewCoreFreesWhatWasAbandonedOrOverwritten) {
    put(0, SlotState::abandoned, own_pid());
    put(1, static_cast<SlotState>(77), own_pid());

    clear_commands_of_dead_core(core_->header());

    EXPECT_EQ(used_slots(), 0U);
}

TEST_F(SegmentCommands, StopAndEmergencyStopNeedNoSlot) {
    for (std::size_t slot = 0; slot < kCommandSlots; ++slot) put(slot, SlotState::taken, own_pid());
    const std::uint32_t seen = event_count(core_->header().command_raised);

    request_stop(*hmi_);
    request_emergency_stop(*hmi_);

    EXPECT_EQ(core_->header().stop_requests.load(), 1U);
    EXPECT_EQ(core_->header().estop_requests.load(), 1U);
    EXPECT_TRUE(event_wait_past(core_->header().command_raised, seen, milliseconds{0}));
}

TEST_F(SegmentCommands, ManySendersEachGetTheirOwnAnswer) {
    constexpr int kSenders = 4;
    constexpr std::uint64_t kEach = 100;
    std::atomic<int> right{0};
    std::vector<std::thread> senders;
    for (std::uint64_t sender = 0; sender < kSenders; ++sender) {
        senders.emplace_back([&, sender] {
            for (std::uint64_t round = 0; round < kEach; ++round) {
                const std::uint64_t number = sender * kEach + round;
                const auto result =
                    send_command(*hmi_, {CommandKind::back_off, 0, 0, number}, milliseconds{60'000});
                right += !result.has_value() && result.error().said.arguments[0].bits == number;
            }
        });
    }

    for (std::uint64_t round = 0; round < kSenders * kEach; ++round) {
        const ReceivedCommand received = take();
        answer_command(*core_, received, AnswerKind::refused,
                       message_of(MessageId::no_such_layer, count_argument(received.command.value2)));
    }
    for (std::thread& sender : senders) sender.join();

    EXPECT_EQ(right.load(), static_cast<int>(kSenders * kEach));
    EXPECT_EQ(used_slots(), 0U);
}

}  // namespace
}  // namespace psicarve
