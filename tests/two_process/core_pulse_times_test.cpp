// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>

#include "shared/base/units.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

/// How often the edges of a run came sooner than a driver needs, by the stamps of the port itself, and by how
/// much at most.
struct TooSoon {
    int pulses = 0;
    int high = 0;
    int low = 0;
    int setup = 0;
    int hold = 0;
    std::int64_t most_ns = 0;
    void note(int& count, std::int64_t passed_ns, std::int64_t least_ns) {
        if (passed_ns >= least_ns) return;
        ++count;
        most_ns = std::max(most_ns, least_ns - passed_ns);
    }
};

TooSoon judge(const std::vector<fake_port::Write>& writes, const Profile& profile) {
    const PortProfile& port = profile.port;
    const auto levels = fake_port::levels_of(writes, profile);
    constexpr std::int64_t kNever = -kNsPerS;
    std::array<std::int64_t, kAxisCount> rose_ns{kNever, kNever, kNever, kNever};
    auto fell_ns = rose_ns;
    auto turned_ns = rose_ns;
    TooSoon result;
    for (std::size_t i = 1; i < writes.size(); ++i) {
        const auto now_ns = static_cast<std::int64_t>(writes[i].time_ns);
        const std::uint32_t changed = levels[i - 1] ^ levels[i];
        // An alarm or the end: nothing is enabled any more, and these edges do not count.
        const bool counts = (levels[i] & kEnableMask) != 0;
        for (std::size_t k = 0; counts && k < kAxisCount; ++k) {
            if ((changed & bit_of(dir_of(kAllAxes[k]))) != 0) {
                result.note(result.hold, now_ns - rose_ns[k], port.dir_hold_ns);
                turned_ns[k] = now_ns;
            }
            if ((changed >> k & 1U) == 0) continue;
            if ((levels[i] >> k & 1U) != 0) {
                ++result.pulses;
                result.note(result.low, now_ns - fell_ns[k], port.step_low_ns);
                result.note(result.setup, now_ns - turned_ns[k], port.dir_setup_ns);
                rose_ns[k] = now_ns;
            } else {
                result.note(result.high, now_ns - rose_ns[k], port.step_high_ns);
                fell_ns[k] = now_ns;
            }
        }
    }
    return result;
}

class CorePulseTimes : public PortRig {
protected:
    CorePulseTimes() { home_by_one_sensor(); }
    void carve_with(std::int64_t time_ns) {
        PortProfile& port = profile_.port;
        port.step_high_ns = port.step_low_ns = port.dir_setup_ns = port.dir_hold_ns = time_ns;
        write_profile();
        port_.stand(profile_);
        port_.state().write_count.store(0);
        start_port_core();
        home();
        ASSERT_EQ(publish(coarse_job(2)), "");
        start_carving();
        ASSERT_TRUE(
            eventually([&] { return status().job_end_tick != 0 || status().state == MachineState::alarm; }));
        EXPECT_EQ(status().state, MachineState::ready) << name_of(status().alarm_cause);
        ticks_ = status().tick;
        missed_ticks_ = status().missed_ticks;
        ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
        EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
    }
    void expect_none_too_soon() {
        const TooSoon found = judge(port_.writes(), profile_);
        EXPECT_GT(found.pulses, 100);
        EXPECT_EQ(found.high, 0) << "by up to " << found.most_ns << " ns";
        EXPECT_EQ(found.low, 0) << "by up to " << found.most_ns << " ns";
        EXPECT_EQ(found.setup, 0) << "by up to " << found.most_ns << " ns";
        EXPECT_EQ(found.hold, 0) << "by up to " << found.most_ns << " ns";
    }
    std::uint64_t ticks_ = 0;
    std::uint64_t missed_ticks_ = 0;
};

TEST_F(CorePulseTimes, AreKeptWhereAWriteTakesEffectLate) {
    for (const PulseForm form : {PulseForm::over_ticks, PulseForm::within_tick}) {
        profile_.port.pulses = form;
        port_.state().delay_every.store(7);
        port_.state().delay_ns.store(form == PulseForm::over_ticks ? 600'000 : 400'000);
        ASSERT_NO_FATAL_FAILURE(carve_with(form == PulseForm::over_ticks ? 900'000 : 450'000));
        expect_none_too_soon();
    }
}

TEST_F(CorePulseTimes, LongerThanATickAreKeptToo) {
    profile_.tick.period_us = 500.0;
    port_.state().delay_every.store(7);
    port_.state().delay_ns.store(400'000);
    ASSERT_NO_FATAL_FAILURE(carve_with(900'000));
    expect_none_too_soon();
}

// A third and more of them were left out: each that was less late than the one before. What a busy computer
// takes away is a few in a hundred.
TEST_F(CorePulseTimes, OverAPeriodCostNoTicks) {
    profile_.tick.period_us = 500.0;
    ASSERT_NO_FATAL_FAILURE(carve_with(900'000));
    expect_none_too_soon();
    EXPECT_LT(missed_ticks_ * 5, ticks_) << missed_ticks_ << " of " << ticks_;
}

}  // namespace
}  // namespace psicarve::two_process
