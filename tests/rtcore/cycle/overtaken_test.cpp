// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <vector>

#include "rtcore/cycle/pin_trial.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

using StopWord = std::atomic<std::uint64_t> UrgentWords::*;
constexpr StopWord kBothWords[] = {&UrgentWords::stop_word, &UrgentWords::estop_word};

/// As whoever asks for it now.
Request asked_now(const MachineRig& rig, RequestKind kind, std::uint64_t value = 0) {
    Request request{};
    request.kind = kind;
    request.value = value;
    request.has_sender = 1;
    request.stops_seen = static_cast<std::uint32_t>(rig.io->urgent.stop_word.load());
    request.emergency_stops_seen = static_cast<std::uint32_t>(rig.io->urgent.estop_word.load());
    return request;
}

constexpr std::uint64_t test_order(bool is_on) {
    return packed(PinOrder{static_cast<std::uint8_t>(Signal::spindle), is_on, 0, 1});
}

TEST(AnOvertakenRequest, IsRefusedWhateverItWouldSetGoing) {
    for (const StopWord word : kBothWords) {
        for (const RequestKind kind :
             {RequestKind::home, RequestKind::start, RequestKind::start_interpolation, RequestKind::resume,
              RequestKind::reset_alarm, RequestKind::back_off, RequestKind::reset_height, RequestKind::jog,
              RequestKind::jog_on, RequestKind::move, RequestKind::run_program, RequestKind::spindle,
              RequestKind::test_pin}) {
            SCOPED_TRACE(static_cast<int>(kind));
            MachineRig sut(quick_profile());
            const Request before = asked_now(sut, kind, kind == RequestKind::test_pin ? test_order(true) : 1);
            ++(sut.io->urgent.*word);
            EXPECT_EQ(sut.ask(before), Refusal::overtaken);
            sut.run(10);
            EXPECT_EQ(sut.ask(before), Refusal::overtaken) << "however late it comes";
            EXPECT_EQ(sut.records_of(RecordKind::state_change).size(),
                      word == &UrgentWords::stop_word ? 0U : 1U);
            EXPECT_EQ(sut.cycle->pulses().levels() & kOutputMask, 0U);
        }
    }
}

TEST(AnOvertakenRequest, IsTakenIfItSetsNothingGoing) {
    for (const StopWord word : kBothWords) {
        for (const RequestKind kind : {RequestKind::hold, RequestKind::spindle, RequestKind::override,
                                       RequestKind::test_pin, RequestKind::drives_off, RequestKind::record}) {
            SCOPED_TRACE(static_cast<int>(kind));
            MachineRig sut(quick_profile());
            const std::uint64_t value = kind == RequestKind::override   ? 50
                                        : kind == RequestKind::test_pin ? test_order(false)
                                                                        : 0;
            const Request before = asked_now(sut, kind, value);
            ++(sut.io->urgent.*word);
            EXPECT_NE(sut.ask(before), Refusal::overtaken);
        }
    }
}

TEST(AnOvertakenRequest, OfTheSpindleSwitchesItOff) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.home());
    ASSERT_EQ(sut.ask(asked_now(sut, RequestKind::spindle, 1)), Refusal::none);
    const Request off = asked_now(sut, RequestKind::spindle, 0);
    ++sut.io->urgent.stop_word;
    EXPECT_EQ(sut.ask(off), Refusal::none);
    EXPECT_EQ(sut.cycle->pulses().levels() & bit_of(Signal::spindle), 0U);
}

TEST(ARequestAfterAStop, IsDone) {
    MachineRig sut(quick_profile());
    ++sut.io->urgent.stop_word;
    EXPECT_EQ(sut.ask(asked_now(sut, RequestKind::home)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    ++sut.io->urgent.estop_word;
    sut.tick();
    ASSERT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_EQ(sut.ask(asked_now(sut, RequestKind::reset_alarm)), Refusal::none);
    EXPECT_NE(sut.cycle->state(), MachineState::alarm);
}

TEST(ARequestOfTheCoreItself, IsOvertakenByNoStop) {
    MachineRig sut(quick_profile());
    Request own = asked_now(sut, RequestKind::home);
    own.has_sender = 0;
    ++sut.io->urgent.stop_word;
    EXPECT_EQ(sut.ask(own), Refusal::none);
    EXPECT_EQ(sut.cycle->state(), MachineState::homing);
}

// The words count up for years, and one day from their highest value to 0.
TEST(AnOvertakenRequest, IsToldFromALaterOneBeyondTheHighestWord) {
    MachineRig sut(quick_profile());
    sut.io->urgent.stop_word = 0xFFFF'FFFFU;
    sut.tick();
    const Request before = asked_now(sut, RequestKind::home);
    sut.io->urgent.stop_word = 0;
    EXPECT_EQ(sut.ask(before), Refusal::overtaken);
    EXPECT_EQ(sut.ask(asked_now(sut, RequestKind::home)), Refusal::none);
}

// Both came between the tick's looks at the words and at the ring.
TEST(ARequestAfterAStop, IsNotStoppedByIt) {
    MachineRig sut(quick_profile());
    sut.port->healthy = false;
    sut.run(2);
    ASSERT_EQ(sut.cycle->state(), MachineState::alarm);
    sut.port->answers = true;
    sut.port->when_taken_up = [&] {
        ++sut.io->urgent.stop_word;
        sut.io->replayed_requests.push(asked_now(sut, RequestKind::home));
    };
    ASSERT_EQ(sut.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_EQ(sut.records_of(RecordKind::stop).size(), 1U);
    sut.run(2);
    EXPECT_EQ(sut.cycle->state(), MachineState::homing);
    EXPECT_EQ(sut.records_of(RecordKind::stop).size(), 1U);
}

TEST(TheSegmentsWords, AreActedOnAtAnyChangeAndOnceBesidesTheCoresOwn) {
    MachineRig sut(quick_profile());
    ++sut.io->urgent.stop_word;
    sut.run(3);
    EXPECT_EQ(sut.records_of(RecordKind::stop).size(), 1U);
    sut.stop();
    sut.run(3);
    EXPECT_EQ(sut.records_of(RecordKind::stop).size(), 2U);
    // Another segment, whose words go on where the old one's ended.
    sut.io->urgent.stop_word.fetch_add(std::uint64_t{1} << 32U);
    sut.run(3);
    EXPECT_EQ(sut.records_of(RecordKind::stop).size(), 2U);
    sut.io->urgent.stop_word = 0x1'2345'6789U;
    sut.run(3);
    EXPECT_EQ(sut.records_of(RecordKind::stop).size(), 3U);
}

}  // namespace
}  // namespace psicarve::cycle
