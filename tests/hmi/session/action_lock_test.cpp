// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/action_lock.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hmi/session/preflight.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::limit_alarm;
using test::machine_in;
using S = MachineState;

std::string lock(Action action, const MachineSight& machine, DeskState desk = DeskState::published) {
    const auto why = lock_of(action, machine, JobSight{desk, false, 10});
    return why ? in_english(*why) : "";
}

std::vector<S> states_that_allow(Action action) {
    std::vector<S> allowed;
    for (std::uint8_t i = 0; i < kMachineStateCount; ++i) {
        const auto state = static_cast<S>(i);
        if (lock(action, machine_in(state), DeskState::job).empty()) allowed.push_back(state);
    }
    return allowed;
}

TEST(ActionLock, LetsHoldResumeAndStopActWhereTheyMeanSomething) {
    EXPECT_EQ(states_that_allow(Action::hold), (std::vector{S::carving}));
    EXPECT_EQ(states_that_allow(Action::resume), (std::vector{S::holding, S::held}));
    EXPECT_EQ(states_that_allow(Action::stop),
              (std::vector{S::homing, S::moving, S::positioning, S::waiting, S::carving, S::holding, S::held,
                           S::finishing, S::backing_off, S::testing}));
    EXPECT_EQ(states_that_allow(Action::home), (std::vector{S::off, S::ready}));
    EXPECT_EQ(states_that_allow(Action::publish), (std::vector{S::off, S::ready}));
}

TEST(ActionLock, NamesTheAxisThatIsNotHomed) {
    const std::uint8_t all_but_y = 0x7;
    EXPECT_EQ(lock(Action::start, machine_in(S::ready, all_but_y)), "Start: axis Y is not homed");
    EXPECT_EQ(lock(Action::start, machine_in(S::ready)), "");
}

TEST(ActionLock, NeverStartsAnotherJobThanTheOneThatIsOpen) {
    EXPECT_EQ(lock(Action::start, machine_in(S::ready), DeskState::model),
              "Start: slice the model, then publish the job");
    EXPECT_EQ(lock(Action::start, machine_in(S::ready), DeskState::job), "Start: the job is not published");
    EXPECT_EQ(lock(Action::start, machine_in(S::ready), DeskState::empty), "");
    MachineSight machine = machine_in(S::ready);
    machine.status->job_generation = 0;
    EXPECT_EQ(lock(Action::start, machine, DeskState::empty), "Start: no job is published");
}

TEST(ActionLock, LocksOneLayerWithTheStartAndWhileTheHeadsWait) {
    EXPECT_EQ(lock(Action::one_layer, machine_in(S::ready)), "");
    EXPECT_EQ(lock(Action::one_layer, machine_in(S::off, 0)), "Start: axis R1 is not homed");
    EXPECT_EQ(lock(Action::one_layer, machine_in(S::carving)), "Start: already carving");
    EXPECT_EQ(lock(Action::one_layer, machine_in(S::waiting)),
              "The heads wait at the first point; start or stop");
}

TEST(ActionLock, KeepsTheAlarmUntilItsCauseIsGone) {
    MachineSight machine = limit_alarm(Axis::r2);
    EXPECT_EQ(lock(Action::reset_alarm, machine), "Switch R2 is still closed");
    EXPECT_EQ(lock(Action::back_off, machine), "");
    machine.status->signals = 0;
    EXPECT_EQ(lock(Action::reset_alarm, machine), "");
    EXPECT_EQ(lock(Action::back_off, machine), "Back off: no switch is closed");
    machine.status->signals = bit_of(Signal::estop);
    EXPECT_EQ(lock(Action::reset_alarm, machine), "The emergency stop switch is still pressed");
}

TEST(ActionLock, LocksAllMotionWithoutACoreThatIsHeard) {
    MachineSight machine = machine_in(S::ready);
    machine.life = CoreLife::none;
    EXPECT_EQ(lock(Action::start, machine), "No core serves the segment");
    machine.life = CoreLife::silent;
    EXPECT_EQ(lock(Action::home, machine), "The core is silent");
    machine.life = CoreLife::late;
    EXPECT_EQ(lock(Action::home, machine), "");
}

TEST(ActionLock, SlicesMeshesAlone) {
    const auto slicing = [](DeskState desk, bool has_mesh) {
        const auto why = lock_of(Action::slice, MachineSight{}, JobSight{desk, has_mesh, 0});
        return why ? in_english(*why) : "";
    };
    EXPECT_EQ(slicing(DeskState::model, true), "");
    EXPECT_EQ(slicing(DeskState::published, true), "");
    EXPECT_EQ(slicing(DeskState::empty, false), "Slice: open a model first");
    EXPECT_EQ(slicing(DeskState::job, false), "Slice: this is a job, and already sliced");
    EXPECT_EQ(slicing(DeskState::slicing, true), "Slice: a job is being made");
}

TEST(CoreLife, TurnsLateThenSilent) {
    using std::chrono::milliseconds;
    EXPECT_EQ(core_life(true, milliseconds{249}), CoreLife::alive);
    EXPECT_EQ(core_life(true, milliseconds{250}), CoreLife::late);
    EXPECT_EQ(core_life(true, milliseconds{500}), CoreLife::silent);
    EXPECT_EQ(core_life(false, milliseconds{0}), CoreLife::none);
}

std::string failing_check(const MachineSight& machine, DeskState desk) {
    std::string failing;
    for (const Check& check : preflight_checks(machine, JobSight{desk, false, 10})) {
        if (check.verdict == Check::Verdict::fail)
            failing += in_english(check.name) + ": " + in_english(check.detail) + "; ";
    }
    return failing;
}

TEST(Preflight, SaysWhatIsMissing) {
    EXPECT_EQ(failing_check(machine_in(S::ready), DeskState::published), "");
    EXPECT_EQ(failing_check(machine_in(S::off, 0x3), DeskState::published), "Axes homed: Ψ Y not homed; ");
    EXPECT_EQ(failing_check(machine_in(S::ready), DeskState::job), "Job published: publish first; ");
    EXPECT_EQ(failing_check(limit_alarm(Axis::r1), DeskState::published),
              "No alarm: reset first; Limits clear: R1 closed; Axes homed: R1 not homed; ");
    EXPECT_EQ(failing_check(MachineSight{}, DeskState::empty), "Core alive: no core; ");
}

// Whatever has been opened or sliced since: the checks are of the job that runs.
TEST(Preflight, IsOfTheRunningJobWhileOneRuns) {
    for (const DeskState desk :
         {DeskState::model, DeskState::slicing, DeskState::job, DeskState::published}) {
        EXPECT_EQ(failing_check(machine_in(S::carving), desk), "") << static_cast<int>(desk);
        EXPECT_EQ(failing_check(machine_in(S::held), desk), "") << static_cast<int>(desk);
    }
    EXPECT_EQ(failing_check(machine_in(S::ready), DeskState::job), "Job published: publish first; ");
}

TEST(Preflight, PassesExactlyWhenStartIsNotLocked) {
    for (std::uint8_t homed = 0; homed <= test::kAllHomed; ++homed) {
        for (const DeskState desk :
             {DeskState::empty, DeskState::opening, DeskState::model, DeskState::slicing, DeskState::job,
              DeskState::publishing, DeskState::published}) {
            const MachineSight machine = machine_in(S::ready, homed);
            EXPECT_EQ(failing_check(machine, desk).empty(), lock(Action::start, machine, desk).empty())
                << int{homed} << " " << static_cast<int>(desk);
        }
    }
}

}  // namespace
}  // namespace psicarve::session
