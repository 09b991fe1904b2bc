// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever pulse is lost, the axis that lost it is named.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/hmi/verify/pulse_faults.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

/// So many pulses of each axis, evenly spread over approach, layers and links.
constexpr std::size_t kTried = 60;

class LostPulse : public testing::TestWithParam<Axis> {};

/// Out where the next layer is shallower, Y past the middle, then all at once: as one way.
void blend_to(PerfectMachine& machine, const SampleJob& job, std::uint32_t layer) {
    const JobView view = job.view();
    const std::uint32_t first = carved_point(view.joining(), view.point_count(), layer, 0);
    const std::array<std::int64_t, 2> to = {view.r_left_pulses(layer)[first],
                                            view.r_right_pulses(layer)[first]};
    machine.move(Axis::r1, std::max<std::int64_t>(0, to[0] - machine.position[0]));
    machine.move(Axis::r2, std::max<std::int64_t>(0, to[1] - machine.position[1]));
    machine.move(Axis::y, SampleJob::kLayerPulses * 3 / 4);
    machine.line({to[0] - machine.position[0], to[1] - machine.position[1],
                  view.psi_pulses(layer, first) - machine.position[2],
                  view.y_pulses(layer, first) - machine.position[3]});
}

TEST_P(LostPulse, IsNamedWithItsAxisWhereverItWasLost) {
    const SampleJob job = wavy_job(Joining::continuous, 3, 11);
    PerfectMachine whole(job);
    whole.approach().layer(0).link_to(1).layer(1);
    blend_to(whole, job, 2);
    for (std::uint32_t step = 1; step + 1 < 11; ++step) whole.to_point(2, step);
    const std::size_t pulses = pulses_before(whole, GetParam());
    whole.to_point(2, 10).finish();
    ASSERT_TRUE(verified(job, whole).ok);
    for (std::size_t i = 0; i < kTried; ++i) {
        // Both ends too: the last few are those of the last link or segment.
        const std::size_t n = i * (pulses - 1) / (kTried - 1);
        PerfectMachine machine = whole;
        drop_pulse(machine, GetParam(), n);
        const Offence offence = first_of(verified(job, machine), 1);
        EXPECT_EQ(offence.axis, GetParam()) << "pulse " << n << " of " << pulses << ": " << offence.sentence;
    }
}

TEST(LostPulseOfY, DoesNotExcuseAHeadThatDivesOnTheWay) {
    const SampleJob job = wavy_job(Joining::continuous, 2, 11);
    PerfectMachine machine(job);
    machine.approach().layer(0);
    const std::size_t lost = pulses_before(machine, Axis::y);
    machine.move(Axis::r1, -300).move(Axis::r1, 300);
    machine.link_to(1).layer(1).finish();
    drop_pulse(machine, Axis::y, lost + 5);
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).fault, "too-deep") << first_of(report, 1).sentence;
    EXPECT_EQ(first_of(report, 1).axis, Axis::r1);
}

INSTANTIATE_TEST_SUITE_P(OfAnyAxis, LostPulse, testing::Values(Axis::r1, Axis::r2, Axis::psi, Axis::y),
                         [](const auto& named) { return std::string{name_of(named.param)}; });

}  // namespace
}  // namespace psicarve::verify
