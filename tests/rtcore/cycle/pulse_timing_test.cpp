// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <new>
#include <sstream>
#include <string>

#include "shared/base/units.hpp"
#include "tests/places.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/rtcore/cycle/move_requests.hpp"

namespace {
std::atomic<std::uint64_t> allocations{0};
}  // namespace

// Every allocation of this program is counted; the tick must add none.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;  // NOLINT(cppcoreguidelines-no-malloc)
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace psicarve::cycle {
namespace {

/// Judges every edge of a run by the driver's times [ns].
class TimingJudge {
public:
    explicit TimingJudge(const PortProfile& port) : port_(port) {}

    void take(const PortWrite& write) {
        const std::int64_t now_ns = write.time_ns;
        const SignalWord changed = write.levels ^ levels_;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const bool is_high = (write.levels >> k & 1U) != 0;
            if ((changed >> (4 + k) & 1U) != 0) {
                EXPECT_TRUE(!ever_rose_[k] || now_ns - rose_ns_[k] >= port_.dir_hold_ns) << "hold " << now_ns;
                turned_ns_[k] = now_ns;
            }
            if ((changed >> k & 1U) == 0) continue;
            if (is_high) {
                ++pulses;
                EXPECT_GE(now_ns - turned_ns_[k], port_.dir_setup_ns) << "setup " << now_ns;
                EXPECT_TRUE(!ever_rose_[k] || now_ns - fell_ns_[k] >= port_.step_low_ns) << "low " << now_ns;
                EXPECT_NE(write.levels >> (8 + k) & 1U, 0U) << "disabled " << now_ns;
                rose_ns_[k] = now_ns;
                ever_rose_[k] = true;
            } else {
                EXPECT_GE(now_ns - rose_ns_[k], port_.step_high_ns) << "high " << now_ns;
                fell_ns_[k] = now_ns;
            }
        }
        levels_ = write.levels;
    }
    int pulses = 0;

private:
    PortProfile port_;
    SignalWord levels_ = 0;
    std::array<bool, kAxisCount> ever_rose_{};
    std::array<std::int64_t, kAxisCount> rose_ns_{};
    std::array<std::int64_t, kAxisCount> fell_ns_{};
    std::array<std::int64_t, kAxisCount> turned_ns_{};
};

struct Timing {
    double period_us;
    std::int64_t setup_ns;
    std::int64_t hold_ns;
    std::int64_t high_ns;
    std::int64_t low_ns;
};

Profile quick_with(const Timing& timing) {
    Profile profile = quick_profile();
    profile.tick.period_us = timing.period_us;
    profile.port.dir_setup_ns = timing.setup_ns;
    profile.port.dir_hold_ns = timing.hold_ns;
    profile.port.step_high_ns = timing.high_ns;
    profile.port.step_low_ns = timing.low_ns;
    return profile;
}

TEST(PulseTiming, ObeysTheDriversTimesOverWholeTicks) {
    for (const Timing timing :
         {Timing{50.0, 5000, 5000, 10000, 10000}, Timing{50.0, 0, 0, 1000, 1000},
          Timing{20.0, 5000, 5000, 30000, 30000}, Timing{20.0, 50000, 70000, 10000, 45000},
          Timing{10.0, 200, 200, 2500, 2500}}) {
        const Profile profile = quick_with(timing);
        MachineRig sut(profile);
        ASSERT_TRUE(sut.prepare(random_job(2, 80, 41)));
        ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        TimingJudge judge(profile.port);
        for (const PortWrite& write : sut.port->writes) judge.take(write);
        EXPECT_GT(judge.pulses, 10000);
        for (const Axis axis : kAllAxes) {
            EXPECT_EQ(sut.machine->position_pulses(axis), sut.positions()[index_of(axis)]);
        }
    }
}

Profile quick_within_tick(const Timing& timing) {
    Profile profile = quick_with(timing);
    profile.port.pulses = PulseForm::within_tick;
    return profile;
}

TEST(PulseWithinATick, ObeysTheDriversTimesAndLosesNothing) {
    for (const Timing timing : {Timing{50.0, 5000, 5000, 10000, 10000}, Timing{25.0, 0, 0, 10000, 10000},
                                Timing{20.0, 50000, 70000, 2500, 2500}, Timing{12.0, 200, 200, 2500, 2500}}) {
        const Profile profile = quick_within_tick(timing);
        MachineRig sut(profile);
        ASSERT_TRUE(sut.prepare(random_job(2, 80, 41)));
        ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
        ASSERT_TRUE(sut.run_until(MachineState::ready));
        TimingJudge judge(profile.port);
        for (const PortWrite& write : sut.port->writes) judge.take(write);
        EXPECT_GT(judge.pulses, 10000);
        EXPECT_EQ(sut.port->waited_ns, timing.high_ns);
        for (const Axis axis : kAllAxes) {
            EXPECT_EQ(sut.machine->position_pulses(axis), sut.positions()[index_of(axis)]);
        }
    }
}

TEST(PulseWithinATick, KeepsTheOrderOfPulses) {
    const auto order = [](PulseForm form) {
        Profile profile = quick_profile();
        profile.port.pulses = form;
        MachineRig sut(profile);
        EXPECT_TRUE(sut.prepare(random_job(2, 80, 7)));
        sut.port->writes.clear();
        EXPECT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
        EXPECT_TRUE(sut.run_until(MachineState::finishing));
        return order_of(sut.port->writes);
    };
    EXPECT_EQ(order(PulseForm::within_tick), order(PulseForm::over_ticks));
}

TEST(PulseWithinATick, AllowsOneATick) {
    Profile profile = quick_within_tick({50.0, 5000, 5000, 10000, 10000});
    // A speed that two ticks a pulse could not make: 15000 pulses/s of 20000 ticks/s.
    profile.r1.speed_mm_s = 15000.0 / profile.r1.pulses_per_mm;
    profile.r1.accel_mm_s2 = 2000.0;
    const auto checked = parse_profile(profile_to_toml(profile), "quick.toml");
    ASSERT_TRUE(checked) << checked.error().message;
    MachineRig sut(profile);
    ASSERT_TRUE(sut.home());
    sut.port->writes.clear();
    ASSERT_EQ(sut.ask(jog_request(Axis::r1, -6000, 15000.0)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    std::int64_t shortest_ns = kNsPerS;
    std::int64_t last_ns = -kNsPerS;
    SignalWord before = 0;
    for (const PortWrite& write : sut.port->writes) {
        if ((write.levels & ~before & bit_of(Signal::r1_step)) != 0) {
            shortest_ns = std::min(shortest_ns, write.time_ns - last_ns);
            last_ns = write.time_ns;
        }
        before = write.levels;
    }
    EXPECT_EQ(shortest_ns, tick_period_ns(profile));
    EXPECT_EQ(sut.machine->position_pulses(Axis::r1), sut.positions()[0]);
}

TEST(Tick, AllocatesNothing) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(3, 200, 41)));
    sut.port->records = false;
    sut.ask(RequestKind::start_interpolation);
    sut.run(100);
    sut.planner->poll();
    const std::uint64_t before = allocations;
    for (int n = 0; n < 10'000; ++n) sut.cycle->tick();
    EXPECT_EQ(allocations, before);
    EXPECT_EQ(sut.cycle->state(), MachineState::carving);
}

/// "tick axes" a line: which axes stepped in which direction, counted from the first write.
std::string compact(const std::vector<PortWrite>& writes) {
    std::ostringstream text;
    PinCounter pins({});
    for (const PortWrite& write : writes) {
        const std::uint32_t axes = pins.take(write.levels);
        if (axes == 0) continue;
        text << write.tick - writes.front().tick;
        for (const Axis axis : kAllAxes) {
            if ((axes & bit_of(step_of(axis))) == 0) continue;
            text << ' ' << name_of(axis) << ((write.levels & bit_of(dir_of(axis))) != 0 ? '+' : '-');
        }
        text << '\n';
    }
    return text.str();
}

std::string golden(const std::string& name) {
    std::ifstream file(in_source("tests/data/golden/") + name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(GoldenTrace, ASmallLayerAndItsLinkComeOutPulseForPulse) {
    JobTable job = random_job(2, 6, 1);
    job.psi_sweep_pulses = 40;
    job.r_left_pulses = {4000, 4003, 4009, 4004, 4004, 4001, 4005, 4004, 4003, 4002, 4001, 4000};
    job.r_right_pulses = {3600, 3600, 3601, 3602, 3601, 3600, 3598, 3598, 3599, 3600, 3610, 3600};
    job.layer_height_pulses = {400, 405};
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(job));
    sut.port->writes.clear();
    sut.ask(RequestKind::start_interpolation);
    ASSERT_TRUE(sut.run_until(MachineState::finishing));
    EXPECT_EQ(compact(sut.port->writes), golden("two_layers.txt"));
}

TEST(Planner, MakesTheSamePulsesHoweverOftenItIsPolled) {
    const auto writes_with = [](std::uint64_t poll_every) {
        MachineRig rig(quick_profile());
        rig.poll_every = poll_every;
        JobTable job = random_job(60, 400, 4);
        EXPECT_TRUE(rig.prepare(job));
        rig.ask(RequestKind::start_interpolation);
        rig.run(300'000);
        return rig.port->writes;
    };
    const auto often = writes_with(1);
    const auto seldom = writes_with(1'000'003);
    ASSERT_EQ(often.size(), seldom.size());
    for (std::size_t i = 0; i < often.size(); ++i) {
        ASSERT_EQ(often[i].tick, seldom[i].tick);
        ASSERT_EQ(often[i].levels, seldom[i].levels);
    }
}

}  // namespace
}  // namespace psicarve::cycle
