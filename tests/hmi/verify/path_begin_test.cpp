// SPDX-License-Identifier: GPL-3.0-or-later
// Where rule 1 sees carving begin and end.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

/// The one layer carved from a place beside its first point, that is never reached itself.
VerifyReport carved_from_beside(Axis axis, std::int64_t off_pulses) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    PerfectMachine at_first_point(job);
    auto wanted = at_first_point.approach().position;
    wanted[index_of(axis)] += off_pulses;
    for (const Axis each : kAllAxes) machine.set(enable_of(each), true);
    machine.set(Signal::spindle, true);
    machine.move(axis, wanted[index_of(axis)] - machine.position[index_of(axis)]);
    for (const Axis each : {Axis::psi, Axis::y, Axis::r1, Axis::r2})
        machine.move(each, wanted[index_of(each)] - machine.position[index_of(each)]);
    machine.layer(0).finish();
    return verified(job, machine);
}

TEST(PathBegin, BesideTheFirstPointCarvingHasBegunAndFarFromItNot) {
    constexpr std::int64_t kNear_pulses = 64;
    // On the straight way from there to the next point, psi is no longer near when the axis is.
    constexpr std::int64_t kFar_pulses = 400;
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
        SCOPED_TRACE(name_of(axis));
        EXPECT_EQ(first_of(carved_from_beside(axis, kNear_pulses), 1).fault, "point-missed");
        EXPECT_EQ(first_of(carved_from_beside(axis, kFar_pulses), 1).fault, "no-carving");
    }
}

/// Switches the spindle off with the last pulse, or one event before it.
void stop_spindle_at_last_pulse(PerfectMachine& machine, bool before) {
    auto& events = machine.events;
    std::size_t last = events.size() - 1;
    while ((events[last].levels & kStepMask) == 0) --last;
    for (std::size_t i = before ? last - 1 : last; i < events.size(); ++i)
        events[i].levels &= ~bit_of(Signal::spindle);
}

TEST(PathBegin, ASpindleSwitchedOffWithTheLastPulseStillRanForIt) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    for (const bool before : {false, true}) {
        PerfectMachine whole(job);
        whole.approach().layer(0);
        stop_spindle_at_last_pulse(whole, before);
        const VerifyReport report = verified(job, whole);
        EXPECT_EQ(report.ok, !before) << report_text(report);
        EXPECT_EQ(report.points_visited, report.points_total - (before ? 1U : 0U));

        PerfectMachine one_point(job);
        one_point.approach();
        stop_spindle_at_last_pulse(one_point, before);
        const VerifyReport begun = verified(job, one_point);
        EXPECT_EQ(first_of(begun, 1).fault, before ? "no-carving" : "ends-early");
        EXPECT_EQ(begun.points_visited, before ? 0U : 1U);
    }
}

}  // namespace
}  // namespace psicarve::verify
