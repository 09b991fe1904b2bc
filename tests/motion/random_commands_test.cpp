// SPDX-License-Identifier: GPL-3.0-or-later
// Commands and stops in any order at any tick, as programs send that die in the midst of it: no alarm comes
// of it, no motor stalls, and a stop brings every state to rest.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>

#include "tests/motion/carving_bench.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

using cycle::MachineRig;
using cycle::RequestKind;

constexpr std::uint32_t kCommandedLayers = 30;

/// Sends what comes to its mind, and waits now and then.
class RashSender {
public:
    RashSender(std::uint64_t seed, const JobTable& table) : random_(seed), table_(&table) {}

    void send_one(MachineRig& rig) {
        constexpr std::array kKinds{
            RequestKind::home,    RequestKind::start,       RequestKind::start_interpolation,
            RequestKind::hold,    RequestKind::resume,      RequestKind::override,
            RequestKind::spindle, RequestKind::reset_height};
        const std::uint64_t choice = random_() % 24;
        if (choice == 0) {
            rig.load(*table_);
        } else if (choice == 1) {
            rig.stop();
            rig.tick();
        } else {
            const RequestKind kind = kKinds[random_() % kKinds.size()];
            rig.ask(kind, 0, value_for(kind));
        }
        rig.run(pause());
    }

private:
    std::uint64_t value_for(RequestKind kind) {
        if (kind == RequestKind::home) return random_() % 3 == 0 ? random_() % 16 : 0;
        if (kind == RequestKind::start) return random_() % kCommandedLayers;
        if (kind == RequestKind::override) return 10 + random_() % 191;
        return random_() % 2;
    }
    std::uint64_t pause() {
        constexpr std::array<std::uint64_t, 4> kLongest{2, 300, 8'000, 400'000};
        return random_() % kLongest[random_() % kLongest.size()];
    }

    std::mt19937_64 random_;
    const JobTable* table_;
};

void expect_every_pulse_followed(MachineRig& rig) {
    const sim::SimReport report = rig.machine->report();
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ(
            report.axis(axis).stalls + report.axis(axis).pulses_ignored + report.axis(axis).timing_lost(), 0U)
            << name_of(axis);
        const std::int64_t off = report.axis(axis).position_pulses - rig.positions()[index_of(axis)];
        EXPECT_EQ(axis == Axis::psi ? off % rig.profile.psi.pulses_per_rev : off, 0) << name_of(axis);
    }
}

/// Parts of the same lives, so that no processor has all of them at the end of a suite.
constexpr std::uint64_t kParts = 4;
class RandomCommands : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomCommands, EndInAlarmNeverAndAtRestAfterAStop) {
    Profile profile = cycle::quick_profile();
    profile.job.planner = Planner::lookahead;
    const JobTable table = table_of(profile, sample_shapes()[1].shape, kCommandedLayers, 41);
    const std::uint64_t lives = test::is_long_run() ? 20'000 : 40;
    for (std::uint64_t seed = GetParam(); seed <= lives; seed += kParts) {
        MachineRig rig(profile);
        rig.port->records = false;
        rig.load(table);
        ASSERT_TRUE(rig.home());
        RashSender sender(seed, table);
        for (int sent = 0; sent < 40; ++sent) sender.send_one(rig);
        rig.stop();
        rig.tick();
        const auto is_ended = [&] {
            const MachineState state = rig.cycle->state();
            return state == MachineState::ready || state == MachineState::off || state == MachineState::alarm;
        };
        ASSERT_TRUE(rig.run_while([&] { return !is_ended(); })) << "seed " << seed;
        ASSERT_NE(rig.cycle->state(), MachineState::alarm) << "seed " << seed;
        if (rig.cycle->state() == MachineState::ready) expect_every_pulse_followed(rig);
        ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed;
    }
}
INSTANTIATE_TEST_SUITE_P(Parts, RandomCommands, testing::Range(std::uint64_t{1}, kParts + 1));

}  // namespace
}  // namespace psicarve::motion
