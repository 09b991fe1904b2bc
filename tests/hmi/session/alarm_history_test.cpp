// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/alarm_history.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "hmi/session/alarm_bell.hpp"
#include "hmi/session/log_file.hpp"
#include "hmi/session/status_line.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::system_clock;
using S = MachineState;

const Clock::time_point kNoon{std::chrono::hours{500'000}};
constexpr std::uint64_t kTicksPerSecond = 20'000;

/// Looked at since noon, and heard ten seconds later, a minute after the core began.
MachineView with_alarms(const std::vector<AlarmRecord>& alarms, S state = S::ready) {
    MachineView machine = test::machine_in(state);
    machine.watched_since = kNoon;
    machine.status_time = kNoon + 10s;
    machine.status->tick = 60 * kTicksPerSecond;
    for (const AlarmRecord& alarm : alarms)
        machine.status->alarms[machine.status->alarm_count++ % kAlarmHistory] = alarm;
    return machine;
}

AlarmRecord alarm_of(Axis axis, std::uint64_t second) {
    return {
        second * kTicksPerSecond, AlarmCause::limit, static_cast<std::uint8_t>(index_of(axis)), 0, 0, 0, 0};
}

TEST(AlarmHistory, IsToldOfACoreThatIsHeardForTheFirstTime) {
    const MachineView machine =
        with_alarms({alarm_of(Axis::r2, 5), {20 * kTicksPerSecond, AlarmCause::steps_lost, 2, 0, 0, 7, 9}});
    const auto told = changes_between(MachineView{}, machine);
    ASSERT_EQ(told.size(), 3U);
    EXPECT_EQ(in_english(told[0].what),
              "Before this window was there: Limit switch R2 closed (outer end, pin 11)");
    EXPECT_EQ(in_english(told[0].remedy), "Clear switch R2, or Back off, until its lamp goes out");
    EXPECT_EQ(told[0].axes, "R2");
    EXPECT_EQ(told[0].severity, Severity::alarm);
    EXPECT_EQ(told[0].time, kNoon - 45s);
    EXPECT_TRUE(told[0].is_from_before);
    EXPECT_EQ(in_english(told[1].what), "Before this window was there: The table has lost steps");
    EXPECT_EQ(told[1].time, kNoon - 30s);
    EXPECT_EQ(in_english(told[2].what), "Core found, process 42");
}

TEST(AlarmHistory, HasTheAlarmThatIsLatchedAndTheLastEightAlone) {
    std::vector<AlarmRecord> alarms;
    for (std::uint64_t second = 1; second <= 11; ++second) alarms.push_back(alarm_of(Axis::r1, second));
    const auto told = fresh_alarms(MachineView{}, with_alarms(alarms, S::alarm));
    ASSERT_EQ(told.size(), kAlarmHistory);
    EXPECT_EQ(told.front().time, kNoon + 10s - 56s);
    EXPECT_EQ(told.back().time, kNoon + 10s - 49s);
    for (const Message& message : told) EXPECT_TRUE(message.is_from_before);
}

TEST(AlarmHistory, IsToldOnceOfACore) {
    const MachineView before = with_alarms({alarm_of(Axis::r2, 5)});
    EXPECT_TRUE(fresh_alarms(before, before).empty());
    MachineView silent = before;
    silent.life = CoreLife::silent;
    EXPECT_TRUE(fresh_alarms(silent, before).empty()) << "heard again";
    MachineView gone = before;
    gone.life = CoreLife::none;
    EXPECT_TRUE(fresh_alarms(gone, before).empty()) << "its segment was attached again";
    MachineView other = before;
    other.core_pid = 43;
    EXPECT_EQ(fresh_alarms(gone, other).size(), 1U) << "another core";
    other.core_pid = 42;
    other.status->tick -= 1;
    EXPECT_EQ(fresh_alarms(gone, other).size(), 1U) << "another core with the same number";
}

TEST(AlarmHistory, TellsAsNewsWhatCameWhileSomebodyWatched) {
    const MachineView before = with_alarms({alarm_of(Axis::r2, 5)});
    MachineView silent = before;
    silent.life = CoreLife::silent;
    const MachineView after = with_alarms({alarm_of(Axis::r2, 5), alarm_of(Axis::y, 55)}, S::alarm);
    for (const MachineView& last : {before, silent}) {
        const auto told = fresh_alarms(last, after);
        ASSERT_EQ(told.size(), 1U);
        EXPECT_FALSE(told[0].is_from_before);
        EXPECT_EQ(in_english(told[0].what), "Limit switch Y closed (lower end, pin 10)");
        EXPECT_EQ(told[0].time, kNoon + 5s);
    }
    // A core that began while the window was there.
    const auto told = fresh_alarms(MachineView{}, with_alarms({alarm_of(Axis::y, 51)}));
    ASSERT_EQ(told.size(), 1U);
    EXPECT_FALSE(told[0].is_from_before);
}

TEST(AlarmHistory, OfAVirtualClockHasNoTime) {
    MachineView machine = with_alarms({alarm_of(Axis::r2, 5)});
    machine.status->is_virtual_clock = 1;
    machine.is_core_of_first_look = true;
    const auto told = fresh_alarms(MachineView{}, machine);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_TRUE(told[0].is_from_before);
    EXPECT_EQ(told[0].time, Clock::time_point{});
    EXPECT_TRUE(log_line(told[0]).starts_with("(time not known)")) << log_line(told[0]);
    machine = with_alarms({{~std::uint64_t{0}, AlarmCause::limit, 250, 0, 0, 0, 0}});
    machine.is_core_of_first_look = true;
    EXPECT_EQ(fresh_alarms(MachineView{}, machine).at(0).time, Clock::time_point{})
        << "nonsense of a segment";
}

TEST(AlarmHistory, WithoutATimeIsNewsOfACoreThatCameLater) {
    MachineView machine = with_alarms({alarm_of(Axis::r2, 5)}, S::alarm);
    machine.status->is_virtual_clock = 1;
    machine.is_core_of_first_look = false;
    const auto earliest = Clock::now();
    const auto told = fresh_alarms(MachineView{}, machine);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_FALSE(told[0].is_from_before);
    EXPECT_EQ(in_english(told[0].what), "Limit switch R2 closed (outer end, pin 11)");
    EXPECT_GE(told[0].time, earliest) << "when it was seen";
}

TEST(AlarmHistory, KnowsWhichAlarmStillStands) {
    const std::vector<AlarmRecord> alarms{alarm_of(Axis::r1, 5), alarm_of(Axis::r2, 6)};
    const auto standing = [&](S state) {
        std::vector<bool> all;
        for (const Message& alarm : fresh_alarms(MachineView{}, with_alarms(alarms, state)))
            all.push_back(alarm.is_standing);
        return all;
    };
    EXPECT_EQ(standing(S::alarm), (std::vector<bool>{false, true}));
    EXPECT_EQ(standing(S::backing_off), (std::vector<bool>{false, true}));
    EXPECT_EQ(standing(S::ready), (std::vector<bool>{false, false}));
}

TEST(AlarmHistory, IsToldOnceWhenAnAxisHasBackedOff) {
    const MachineView alarm = with_alarms({alarm_of(Axis::r2, 55)}, S::alarm);
    const MachineView backing_off = with_alarms({alarm_of(Axis::r2, 55)}, S::backing_off);
    for (const Message& message : changes_between(backing_off, alarm))
        EXPECT_NE(message.severity, Severity::alarm) << in_english(message.what);
}

TEST(StatusLine, LeavesOutWhatIsFromBefore) {
    MessageLog log;
    StatusLine sut;
    for (Message& message : fresh_alarms(MachineView{}, with_alarms({alarm_of(Axis::r2, 5)})))
        log.add(std::move(message));
    EXPECT_FALSE(sut.look(log, StatusLine::Clock::time_point{}));
    EXPECT_FALSE(sut.shown().has_value());
}

class Bell : public ::testing::Test {
protected:
    int rung(std::vector<Message> messages) {
        rung_ = 0;
        for (Message& message : messages) log_.add(std::move(message));
        sut_.poll(log_);
        sut_.poll(log_);
        return rung_;
    }
    static std::vector<Message> alarms(std::size_t count) {
        return std::vector<Message>(count, Message{kNoon, Severity::alarm, phrase("Emergency stop"), {}});
    }

    int rung_ = 0;
    MessageLog log_;
    AlarmBell sut_{[this] { ++rung_; }};
};

TEST_F(Bell, RingsOnceForWhateverAlarmsAreNew) {
    EXPECT_EQ(rung({}), 0);
    EXPECT_EQ(rung(alarms(1)), 1);
    EXPECT_EQ(rung(alarms(3)), 1);
    EXPECT_EQ(rung({Message{kNoon, Severity::warning, phrase("The core has ended"), {}}}), 0);
}

TEST_F(Bell, IsSilentAboutWhatIsFromBefore) {
    EXPECT_EQ(rung(fresh_alarms(MachineView{}, with_alarms({alarm_of(Axis::r2, 5)}, S::alarm))), 0);
    const MachineView before = with_alarms({});
    EXPECT_EQ(rung(fresh_alarms(before, with_alarms({alarm_of(Axis::r2, 55)}, S::alarm))), 1);
}

TEST_F(Bell, IsSilentWhileItIsOff) {
    sut_.set_on(false);
    EXPECT_EQ(rung(alarms(1)), 0);
    sut_.set_on(true);
    EXPECT_EQ(rung({}), 0) << "for good";
    EXPECT_EQ(rung(alarms(1)), 1);
}

}  // namespace
}  // namespace psicarve::session
