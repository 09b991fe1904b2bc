// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/program_lock.hpp"

#include <gtest/gtest.h>

namespace psicarve::program {
namespace {

using S = MachineState;

class ProgramLock : public ::testing::Test {
protected:
    ProgramLock() {
        machine_.life = session::CoreLife::alive;
        machine_.profile = Profile{};
        machine_.status.emplace();
        machine_.status->state = S::ready;
        machine_.status->homed_mask = 0xF;
        program_.facts.line_count = 10;
    }
    std::string lock() {
        const auto why = start_lock({machine_, report_, is_own_, is_replay_, is_changed_},
                                    has_program_ ? &program_ : nullptr, is_reading_, switches_);
        return why ? session::in_english(*why) : "";
    }

    session::MachineView machine_;
    ProgramReport report_;
    Decoded program_;
    RunSwitches switches_;
    bool has_program_ = true;
    bool is_reading_ = false;
    bool is_own_ = false;
    bool is_replay_ = false;
    bool is_changed_ = false;
};

TEST_F(ProgramLock, LetsARightProgramStartOnAReadyMachine) {
    EXPECT_EQ(lock(), "");
    switches_.from_line = 10;
    EXPECT_EQ(lock(), "");
}

TEST_F(ProgramLock, SaysWhatIsWrongWithTheProgram) {
    switches_.from_line = 11;
    EXPECT_EQ(lock(), "Start: the program ends in line 10");
    program_.problems.add({1, 1, gcode::ProblemCode::feed_missing, session::phrase("x")});
    EXPECT_EQ(lock(), "Start: errors in the program: 1");
    has_program_ = false;
    EXPECT_EQ(lock(), "Start: no program is open");
    is_reading_ = true;
    EXPECT_EQ(lock(), "Start: the program is being read");
}

TEST_F(ProgramLock, WantsTheFileReadAsItWouldRun) {
    switches_.skips_deleted = true;
    EXPECT_EQ(lock(), "Start: it was read with another block delete; decode it again");
    program_.request.skips_deleted = true;
    EXPECT_EQ(lock(), "");
    is_changed_ = true;
    EXPECT_EQ(lock(), "Start: the file has been changed since it was read; decode it again");
}

TEST_F(ProgramLock, KnowsWhetherWhatWasToldStillHolds) {
    program_.request.start = known_place(machine_);
    program_.request.from_line = 1;
    EXPECT_TRUE(is_read_as_it_is(program_, machine_, switches_));
    machine_.status->position_pulses[0] += 1;
    EXPECT_FALSE(is_read_as_it_is(program_, machine_, switches_)) << "one pulse";
    program_.request.start = known_place(machine_);
    switches_.skips_deleted = true;
    EXPECT_FALSE(is_read_as_it_is(program_, machine_, switches_));
    switches_.skips_deleted = false;
    switches_.from_line = 2;
    EXPECT_FALSE(is_read_as_it_is(program_, machine_, switches_));
    switches_.from_line = 1;
    machine_.profile->y.travel_mm[1] += 1.0;
    EXPECT_FALSE(is_read_as_it_is(program_, machine_, switches_));
}

TEST_F(ProgramLock, SaysWhatTheMachineIsAt) {
    for (int state = 0; state < kMachineStateCount; ++state) {
        machine_.status->state = static_cast<S>(state);
        EXPECT_EQ(lock().empty(), machine_.state() == S::ready) << name_of(machine_.state());
    }
    machine_.status->state = S::ready;
    machine_.status->homed_mask = 0x7;
    EXPECT_EQ(lock(), "Start: axis Y is not homed");
    machine_.life = session::CoreLife::none;
    EXPECT_EQ(lock(), "No core serves the segment");
}

TEST_F(ProgramLock, LetsOneProgramRunAtATime) {
    is_own_ = true;
    EXPECT_EQ(lock(), "Start: the program is on its way");
    is_own_ = false;
    report_.running = 4;
    EXPECT_EQ(lock(), "Start: another program runs; stop it first");
    report_ = {};
    is_replay_ = true;
    EXPECT_EQ(lock(), "Start: a recording is shown; leave replay first");
}

TEST_F(ProgramLock, JudgesByTheCoresOwnProfileAlone) {
    program_.request.profile.r1.pulses_per_mm *= 2.0;
    EXPECT_EQ(lock(), "Start: it was judged for another profile; decode it again");
    machine_.is_profile_of_job = true;
    EXPECT_EQ(lock(), "Start: the core's profile is not known; open it on page Profile");
}

TEST_F(ProgramLock, WantsTheSpindleOffForADryRun) {
    switches_.is_dry = true;
    EXPECT_EQ(lock(), "");
    machine_.status->signals = bit_of(Signal::spindle);
    EXPECT_EQ(lock(), "Start: a dry run switches nothing; switch the spindle off first");
}

TEST_F(ProgramLock, TellsWhyAProgramWaits) {
    ProgramStatus status{};
    status.line = 12;
    EXPECT_EQ(session::in_english(place_phrase(status, S::carving)), "Line 12");
    EXPECT_EQ(session::in_english(place_phrase(status, S::held)), "Line 12: on hold; Resume goes on");
    status.hold = ProgramHold::optional;
    EXPECT_EQ(session::in_english(place_phrase(status, S::held)),
              "Line 12: an optional stop (M1); Resume goes on");
    for (int hold = 1; hold < kProgramHoldCount; ++hold)
        EXPECT_TRUE(hold_advice(static_cast<ProgramHold>(hold))) << hold;
}

}  // namespace
}  // namespace psicarve::program
