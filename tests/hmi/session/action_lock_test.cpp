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

std::string lock(Action action, const MachineView& machine, OpenJobState desk = OpenJobState::published) {
    const auto why = lock_of(action, machine, OpenJobView{desk, false, 10});
    return why ? in_english(*why) : "";
}

std::vector<S> states_that_allow(Action action) {
    std::vector<S> allowed;
    for (std::uint8_t i = 0; i < kMachineStateCount; ++i) {
        const auto state = static_cast<S>(i);
        if (lock(action, machine_in(state), OpenJobState::job).empty()) allowed.push_back(state);
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
    EXPECT_EQ(lock(Action::start, machine_in(S::ready), OpenJobState::model),
              "Start: slice the model, then publish the job");
    EXPECT_EQ(lock(Action::start, machine_in(S::ready), OpenJobState::job),
              "Start: the job is not published");
    EXPECT_EQ(lock(Action::start, machine_in(S::ready), OpenJobState::empty), "");
    MachineView machine = machine_in(S::ready);
    machine.status->job_generation = 0;
    EXPECT_EQ(lock(Action::start, machine, OpenJobState::empty), "Start: no job is published");
}

TEST(ActionLock, LocksOneLayerWithTheStartAndWhileTheHeadsWait) {
    EXPECT_EQ(lock(Action::one_layer, machine_in(S::ready)), "");
    EXPECT_EQ(lock(Action::one_layer, machine_in(S::off, 0)), "Start: axis R1 is not homed");
    EXPECT_EQ(lock(Action::one_layer, machine_in(S::carving)), "Start: already carving");
    EXPECT_EQ(lock(Action::one_layer, machine_in(S::waiting)),
              "The heads wait at the first point; start or stop");
}

TEST(ActionLock, KeepsTheAlarmUntilItsCauseIsGone) {
    MachineView machine = limit_alarm(Axis::r2);
    EXPECT_EQ(lock(Action::reset_alarm, machine), "Switch R2 is still closed");
    EXPECT_EQ(lock(Action::back_off, machine), "");
    machine.status->signals = 0;
    EXPECT_EQ(lock(Action::reset_alarm, machine), "");
    EXPECT_EQ(lock(Action::back_off, machine), "Back off: no switch is closed");
    machine.status->signals = bit_of(Signal::estop);
    EXPECT_EQ(lock(Action::reset_alarm, machine), "The emergency stop switch is still pressed");
}

TEST(ActionLock, LocksAllMotionWithoutACoreThatIsHeard) {
    MachineView machine = machine_in(S::ready);
    machine.life = CoreLife::none;
    EXPECT_EQ(lock(Action::start, machine), "No core serves the segment");
    machine.life = CoreLife::silent;
    EXPECT_EQ(lock(Action::home, machine), "The core is silent");
    machine.life = CoreLife::late;
    EXPECT_EQ(lock(Action::home, machine), "");
}

TEST(ActionLock, SlicesMeshesAlone) {
    const auto slicing = [](OpenJobState desk, bool can_be_sliced) {
        const auto why = lock_of(Action::slice, MachineView{}, OpenJobView{desk, can_be_sliced, 0});
        return why ? in_english(*why) : "";
    };
    EXPECT_EQ(slicing(OpenJobState::model, true), "");
    EXPECT_EQ(slicing(OpenJobState::published, true), "");
    EXPECT_EQ(slicing(OpenJobState::empty, false), "Slice: open a model first");
    EXPECT_EQ(slicing(OpenJobState::job, false), "Slice: this is a job, and already sliced");
    EXPECT_EQ(slicing(OpenJobState::slicing, true), "Slice: a job is being made");
}

TEST(CoreLife, TurnsLateThenSilent) {
    using std::chrono::milliseconds;
    EXPECT_EQ(core_life(true, milliseconds{249}), CoreLife::alive);
    EXPECT_EQ(core_life(true, milliseconds{250}), CoreLife::late);
    EXPECT_EQ(core_life(true, milliseconds{500}), CoreLife::silent);
    EXPECT_EQ(core_life(false, milliseconds{0}), CoreLife::none);
}

std::string failing_check(const MachineView& machine, OpenJobState desk) {
    std::string failing;
    for (const Check& check : preflight_checks(machine, OpenJobView{desk, false, 10})) {
        if (check.verdict == Check::Verdict::fail)
            failing += in_english(check.name) + ": " + in_english(check.detail) + "; ";
    }
    return failing;
}

TEST(Preflight, SaysWhatIsMissing) {
    EXPECT_EQ(failing_check(machine_in(S::ready), OpenJobState::published), "");
    EXPECT_EQ(failing_check(machine_in(S::off, 0x3), OpenJobState::published), "Axes homed: Ψ Y; ");
    EXPECT_EQ(failing_check(machine_in(S::ready), OpenJobState::job), "Job published: publish first; ");
    EXPECT_EQ(failing_check(limit_alarm(Axis::r1), OpenJobState::published),
              "No alarm: reset first; Limits clear: R1 closed; Axes homed: R1; ");
    EXPECT_EQ(failing_check(MachineView{}, OpenJobState::empty), "Core alive: no core; ");
}

TEST(Preflight, FailsWithAnyLimitClosedAndNamesEach) {
    for (const auto& [axis, said] : {std::pair{Axis::r1, "R1"}, {Axis::r2, "R2"}, {Axis::y, "Y"}}) {
        MachineView machine = machine_in(S::ready);
        machine.status->signals = bit_of(sensor_of(axis));
        EXPECT_EQ(failing_check(machine, OpenJobState::published),
                  std::string{"Limits clear: "} + said + " closed; ");
    }
    MachineView machine = machine_in(S::ready);
    machine.status->signals = bit_of(Signal::r1_limit) | bit_of(Signal::y_limit);
    EXPECT_EQ(failing_check(machine, OpenJobState::published), "Limits clear: R1, Y closed; ");
    machine.status->signals = bit_of(Signal::psi_index);
    EXPECT_EQ(failing_check(machine, OpenJobState::published), "") << "the table may stand anywhere";
}

TEST(Preflight, TellsTheClearanceThatTheJobKeeps) {
    MachineView machine = machine_in(S::ready);
    const auto clearance_row = [&](OpenJobState desk) {
        for (const Check& check : preflight_checks(machine, OpenJobView{desk, false, 10})) {
            if (in_english(check.name) == "Head clearance") return check;
        }
        return Check{};
    };
    machine.profile.reset();
    EXPECT_EQ(in_english(clearance_row(OpenJobState::published).detail), "not known");
    machine.profile = Profile{};
    machine.profile->head_clearance_mm = 3.5;
    EXPECT_EQ(in_english(clearance_row(OpenJobState::published).detail), "≥ 3.5 mm");
    EXPECT_EQ(clearance_row(OpenJobState::published).verdict, Check::Verdict::pass);
    EXPECT_EQ(clearance_row(OpenJobState::model).verdict, Check::Verdict::info) << "nothing keeps it yet";
}

TEST(Preflight, TellsOfAnotherBlankThanTheMachinesProfile) {
    MachineView machine = machine_in(S::ready);
    machine.profile = Profile{};
    OpenJobView job{OpenJobState::published, false, 10};
    const auto row_for = [&](const BlankProfile& of_job, const BlankProfile& of_machine) {
        job.blank_difference = blank_difference(of_job, of_machine);
        for (const Check& check : preflight_checks(machine, job)) {
            const std::string name = in_english(check.name);
            if (name.starts_with("Blank ") || name == "Profile matches job") return check;
        }
        return Check{};
    };
    EXPECT_EQ(row_for({20.0, 60.0}, {20.0, 60.0}).verdict, Check::Verdict::pass);
    const Check larger = row_for({20.0, 60.0}, {25.0, 60.0});
    EXPECT_EQ(larger.verdict, Check::Verdict::warning) << "the core takes it: who mounts it knows";
    EXPECT_EQ(in_english(larger.name), "Blank in the way?");
    EXPECT_EQ(in_english(larger.detail), "r 20.0 ≠ 25.0");
    const Check smaller = row_for({20.0, 60.0}, {15.0, 60.0});
    EXPECT_EQ(smaller.verdict, Check::Verdict::warning);
    EXPECT_EQ(in_english(smaller.name), "Blank matches job");
    EXPECT_EQ(in_english(smaller.detail), "r 20.0 ≠ 15.0");
    EXPECT_EQ(in_english(row_for({20.0, 60.0}, {20.0, 62.0}).detail), "h 60.0 ≠ 62.0");
    EXPECT_EQ(in_english(row_for({20.0, 60.0}, {20.0, 60.0, 3.0, 4.0}).detail), "5.0 mm beside");
    // The core's own, where nothing is open.
    job.state = OpenJobState::empty;
    machine.status->job_generation = 1;
    EXPECT_EQ(row_for({20.0, 60.0}, {25.0, 60.0}).verdict, Check::Verdict::warning);
}

TEST(Preflight, TellsInWhatTheJobsMachineIsAnother) {
    MachineView machine = machine_in(S::ready);
    machine.profile = Profile{};
    OpenJobView job{OpenJobState::job, false, 10};
    const auto profile_row = [&] {
        const auto checks = preflight_checks(machine, job);
        EXPECT_EQ(checks.size(), kMostChecks);
        const auto row = std::find_if(checks.begin(), checks.end(), [](const Check& check) {
            return in_english(check.name) == "Profile matches job";
        });
        return row == checks.end() ? Check{} : *row;
    };
    EXPECT_EQ(in_english(profile_row().detail), "default");
    EXPECT_EQ(profile_row().verdict, Check::Verdict::pass);
    job.profile_difference = "r1.pulses_per_mm";
    EXPECT_EQ(in_english(profile_row().detail), "r1.pulses_per_mm");
    EXPECT_EQ(profile_row().verdict, Check::Verdict::fail);
    machine.status->state = S::carving;
    EXPECT_EQ(profile_row().verdict, Check::Verdict::pass) << "the job at work is the core's own";
    job.profile_difference.clear();
    machine = machine_in(S::ready);
    machine.profile.reset();
    EXPECT_EQ(in_english(profile_row().detail), "not known");
    EXPECT_EQ(profile_row().verdict, Check::Verdict::info);
    job.state = OpenJobState::model;
    EXPECT_EQ(profile_row().verdict, Check::Verdict::info) << "there is no job";
    machine = machine_in(S::ready);
    job.state = OpenJobState::empty;
    EXPECT_EQ(profile_row().verdict, Check::Verdict::pass) << "the core's own";
    machine.status->job_generation = 0;
    EXPECT_EQ(profile_row().verdict, Check::Verdict::info);
    EXPECT_EQ(in_english(profile_row().detail), "no job");
}

// Whatever has been opened or sliced since: the checks are of the job that runs.
TEST(Preflight, IsOfTheRunningJobWhileOneRuns) {
    for (const OpenJobState desk :
         {OpenJobState::model, OpenJobState::slicing, OpenJobState::job, OpenJobState::published}) {
        EXPECT_EQ(failing_check(machine_in(S::carving), desk), "") << static_cast<int>(desk);
        EXPECT_EQ(failing_check(machine_in(S::held), desk), "") << static_cast<int>(desk);
    }
    EXPECT_EQ(failing_check(machine_in(S::ready), OpenJobState::job), "Job published: publish first; ");
}

/// Each kind of thing that a check looks at: as it should be, and as it should not.
std::vector<MachineView> machines_at_rest() {
    std::vector<MachineView> machines;
    for (const S state : {S::off, S::ready}) {
        for (std::uint8_t homed = 0; homed <= test::kAllHomed; ++homed)
            machines.push_back(machine_in(state, homed));
    }
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
        machines.push_back(machine_in(S::ready));
        machines.back().status->signals = bit_of(sensor_of(axis));
    }
    for (const CoreLife life : {CoreLife::late, CoreLife::silent, CoreLife::none}) {
        machines.push_back(machine_in(S::ready));
        machines.back().life = life;
    }
    machines.push_back(machine_in(S::ready));
    machines.back().status->job_generation = 0;
    machines.push_back(machine_in(S::ready));
    machines.back().profile.reset();
    machines.push_back(machine_in(S::ready));
    machines.back().status->override_percent = 40;
    machines.push_back(machine_in(S::ready));
    machines.back().status->is_simulator = 0;
    return machines;
}

std::vector<OpenJobView> jobs_on_the_desk() {
    std::vector<OpenJobView> jobs;
    for (const OpenJobState desk :
         {OpenJobState::empty, OpenJobState::opening, OpenJobState::model, OpenJobState::slicing,
          OpenJobState::job, OpenJobState::publishing, OpenJobState::published}) {
        jobs.push_back({desk, false, 10});
        jobs.push_back({desk, false, 10});
        jobs.back().profile_difference = "r1.pulses_per_mm";
        jobs.push_back({desk, false, 10});
        jobs.back().blank_difference = blank_difference({20.0, 60.0}, {25.0, 60.0});
    }
    return jobs;
}

TEST(Preflight, FailsExactlyWhenStartIsLocked) {
    for (const MachineView& machine : machines_at_rest()) {
        for (const OpenJobView& job : jobs_on_the_desk()) {
            std::string failing;
            for (const Check& check : preflight_checks(machine, job)) {
                if (check.verdict == Check::Verdict::fail) failing += in_english(check.name) + "; ";
            }
            for (const Action action : {Action::start, Action::one_layer, Action::from_layer}) {
                const auto why = lock_of(action, machine, job);
                EXPECT_EQ(failing.empty(), !why.has_value())
                    << failing << (why ? in_english(*why) : "") << " " << static_cast<int>(job.state);
            }
        }
    }
}

TEST(Preflight, IsNamedByStartWhereNothingElseLocksIt) {
    MachineView machine = machine_in(S::ready);
    machine.status->signals = bit_of(Signal::r2_limit);
    EXPECT_EQ(lock(Action::start, machine), "Start: pre-flight, Limits clear: R2 closed");
    machine.status->state = S::waiting;
    EXPECT_EQ(lock(Action::start, machine), "Start: pre-flight, Limits clear: R2 closed") << "to go on, too";
    EXPECT_EQ(lock(Action::start, machine_in(S::waiting)), "");
    EXPECT_EQ(lock(Action::start, machine_in(S::off)), "Start: the drives are off; home all axes");
}

std::string to_look_at(const MachineView& machine) {
    std::string named;
    for (const Check& check : preflight_checks(machine, OpenJobView{OpenJobState::published, false, 10})) {
        if (check.verdict == Check::Verdict::warning)
            named += in_english(check.name) + ": " + in_english(check.detail) + "; ";
    }
    EXPECT_EQ(lock(Action::start, machine), "");
    return named;
}

TEST(Preflight, WarnsOfMoreMissedTicksThanTheAlarmAllowsWithItsRemedy) {
    MachineView machine = machine_in(S::ready);
    const auto ticks = [&] {
        for (const Check& check :
             preflight_checks(machine, OpenJobView{OpenJobState::published, false, 10})) {
            if (in_english(check.name) == "Ticks in time") return check;
        }
        return Check{};
    };
    machine.profile->tick.missed_alarm_per_s = 50;
    machine.missed_per_s = 50;
    EXPECT_EQ(to_look_at(machine), "") << "so many are allowed";
    EXPECT_EQ(ticks().verdict, Check::Verdict::pass);
    EXPECT_EQ(in_english(ticks().detail), "missed 50 of 50 a second");
    machine.missed_per_s = 51;
    EXPECT_EQ(to_look_at(machine), "Ticks in time: missed 51 of 50 a second; ");
    EXPECT_TRUE(in_english(ticks().remedy).find("--clock virtual") != std::string::npos);
    machine.status->is_simulator = 0;
    machine.status->has_realtime_rights = 1;
    EXPECT_EQ(to_look_at(machine), "Ticks in time: missed 51 of 50 a second; ");
    EXPECT_TRUE(remedy_of(AlarmCause::missed_ticks).find(in_english(ticks().remedy)) != std::string::npos)
        << "the command line says it so";
    machine.profile->tick.missed_alarm_per_s = 0;
    EXPECT_EQ(to_look_at(machine), "") << "there is no such alarm";
}

TEST(Preflight, WarnsOfWhatTheCoreAllows) {
    MachineView machine = machine_in(S::ready);
    EXPECT_EQ(to_look_at(machine), "");
    machine.status->override_percent = 80;
    EXPECT_EQ(to_look_at(machine), "Feed override: 80 %; ");
    machine.status->override_percent = 100;
    machine.status->is_simulator = 0;
    EXPECT_EQ(to_look_at(machine), "Real-time rights: missing; ");
    machine.status->has_realtime_rights = 1;
    EXPECT_EQ(to_look_at(machine), "");
}

TEST(Preflight, WarnsOfTicksThatComeTooLate) {
    MachineView machine = machine_in(S::ready);
    machine.status->is_simulator = 0;
    machine.status->has_realtime_rights = 1;
    machine.status->tick = 1'000'000;
    machine.status->missed_ticks = 10;
    EXPECT_EQ(to_look_at(machine), "") << "now and then";
    machine.status->missed_ticks = 11;
    EXPECT_EQ(to_look_at(machine), "Ticks in time: 11 missed; ");
    machine.status->missed_ticks = 0;
    machine.status->max_lateness_ns = 60'000;
    machine.status->lateness_histogram[10] = 980'000;  // 1 to 2 us
    machine.status->lateness_histogram[15] = 20'000;   // about the period
    EXPECT_EQ(to_look_at(machine), "Ticks in time: 1 % later than 60 µs; ");
    machine.status->is_simulator = 1;
    EXPECT_EQ(to_look_at(machine), "") << "nothing is at stake";
}

}  // namespace
}  // namespace psicarve::session
