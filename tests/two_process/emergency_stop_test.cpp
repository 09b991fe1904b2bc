// SPDX-License-Identifier: GPL-3.0-or-later
// Emergency stops at any tick: after it the pins say what must be true.
#include <array>
#include <random>

#include "hmi/trace/trace_reader.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr int kStops = 60;

class EmergencyStops : public CoreRig {
protected:
    static Profile small_machine() {
        Profile profile;
        for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) axis->travel_mm = {0.0, 20.0};
        profile.r1.home_position_mm = 20.0;
        profile.r2.home_position_mm = 20.0;
        profile.job.spindle_spinup_s = 0.01;
        return profile;
    }
    /// The tick of the newest alarm.
    std::uint64_t alarm_tick() {
        const CoreStatus now = status();
        const AlarmRecord& alarm = now.alarms[(now.alarm_count - 1) % kAlarmHistory];
        EXPECT_EQ(alarm.cause, AlarmCause::emergency_stop);
        return alarm.tick;
    }
    /// One that was stopped on its sensor backs off from it first.
    void leave_alarm() {
        ASSERT_TRUE(eventually([&] {
            if (refusal_of(CommandKind::reset_alarm).empty()) return true;
            for (const Axis axis : {Axis::r1, Axis::r2, Axis::y})
                (void)refusal_of(CommandKind::back_off, axis);
            return false;
        }));
    }
    std::vector<verify::TraceEvent> trace() const {
        std::vector<verify::TraceEvent> all;
        auto reader = verify::open_trace(file("pins.trace"));
        if (!reader) return all;
        std::array<verify::TraceEvent, 4096> events{};
        for (;;) {
            const auto count = (*reader)->read(events);
            if (!count || *count == 0) return all;
            all.insert(all.end(), events.begin(), events.begin() + static_cast<std::ptrdiff_t>(*count));
        }
    }
};

TEST_F(EmergencyStops, SwitchDrivesAndSpindleOffAndEndAllPulsesWithTheirTick) {
    const Profile profile = small_machine();
    const std::string text = profile_to_toml(profile);
    ASSERT_TRUE(write_file_atomically(file("machine.toml"), std::as_bytes(std::span{text})));
    start_core({"--profile", file("machine.toml"), "--trace", file("pins.trace")});
    const JobTable table = lobed_job(40, 201, profile);
    ASSERT_EQ(publish(table), "");
    std::mt19937_64 random{20261122};
    std::vector<std::uint64_t> ticks;
    int while_carving = 0;
    for (int stop = 0; stop < kStops; ++stop) {
        ASSERT_EQ(refusal_of(CommandKind::home), "");
        // Every third while it homes, the others on the way to the first point or while it carves.
        if (stop % 3 != 0) {
            ASSERT_TRUE(reaches(MachineState::ready));
            ASSERT_EQ(refusal_of(CommandKind::start), "");
            if (stop % 3 == 1) {
                ASSERT_TRUE(reaches(MachineState::waiting));
                ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
            }
        }
        std::this_thread::sleep_for(std::chrono::microseconds{static_cast<int>(random() % 20'000)});
        request_emergency_stop(*segment_);
        ASSERT_TRUE(reaches(MachineState::alarm)) << "stop " << stop;
        ticks.push_back(alarm_tick());
        while_carving += status().points_done > 0 ? 1 : 0;
        leave_alarm();
    }
    EXPECT_GT(while_carving, 5);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);

    const std::int64_t period_ns = tick_period_ns(profile);
    std::size_t next = 0;
    SignalWord before = 0;
    bool is_stopped = false;
    for (const verify::TraceEvent& event : trace()) {
        if (event.kind != verify::TraceEvent::Kind::pins) continue;
        const auto tick = static_cast<std::uint64_t>(event.time_ns / period_ns);
        // From its tick on until drives are on again: nothing that moves or turns.
        if (next < ticks.size() && tick >= ticks[next]) {
            is_stopped = true;
            ++next;
            EXPECT_EQ(event.levels & (kStepMask | kEnableMask | bit_of(Signal::spindle)), 0U);
        }
        if ((event.levels & kEnableMask) != 0) is_stopped = false;
        const SignalWord rising = event.levels & ~before & kStepMask;
        EXPECT_TRUE(!is_stopped || rising == 0) << "at tick " << tick;
        before = event.levels;
    }
    EXPECT_GE(next, ticks.size() / 2) << "the others came at rest, where no pin changed";
}

}  // namespace
}  // namespace psicarve::two_process
