// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/alarm_history.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/alarm_text.hpp"

namespace psicarve::session {
namespace {

using Time = std::chrono::system_clock::time_point;

bool is_same_core(const MachineView& before, const MachineView& after) {
    return before.status && before.core_pid == after.core_pid && before.status->tick <= after.status->tick;
}

/// Nothing where the core's clock is virtual, or the time of the status is not known.
std::optional<Time> time_of(const MachineView& machine, const AlarmRecord& alarm) {
    constexpr double kMostSeconds = 1e9;  // values in the segment may be anything
    const CoreStatus& status = *machine.status;
    if (status.is_virtual_clock != 0 || machine.status_time == Time{} || alarm.tick > status.tick)
        return std::nullopt;
    const std::chrono::duration<double, std::nano> since{static_cast<double>(status.tick - alarm.tick) *
                                                         static_cast<double>(status.period_ns)};
    if (since < since.zero() || since > std::chrono::duration<double>{kMostSeconds}) return std::nullopt;
    return machine.status_time - std::chrono::duration_cast<std::chrono::system_clock::duration>(since);
}

bool is_latched(const MachineView& machine, std::uint64_t number) {
    return number + 1 == machine.status->alarm_count &&
           (machine.state() == MachineState::alarm || machine.state() == MachineState::backing_off);
}

/// The machine in that alarm, as far as it is recorded: an alarm that is over says nothing about switches
/// now.
MachineView in_alarm(const MachineView& machine, std::uint64_t number) {
    MachineView then = machine;
    CoreStatus& status = *then.status;
    const AlarmRecord& alarm = status.alarms[number % kAlarmHistory];
    const bool is_standing = is_latched(machine, number);
    status.alarm_count = number + 1;
    // The status may be a moment older than the list of alarms in it.
    if (is_standing && status.alarm_cause != AlarmCause::none) return then;
    if (!is_standing) {
        status.signals = 0;
        status.is_port_silent = 0;
    }
    status.state = MachineState::alarm;
    status.alarm_cause = alarm.cause;
    status.alarm_axis = alarm.axis;
    return then;
}

Message alarm_message(const MachineView& machine, std::uint64_t number, bool is_of_new_core) {
    const MachineView then = in_alarm(machine, number);
    AlarmText text = alarm_text(then);
    const auto time = time_of(machine, machine.status->alarms[number % kAlarmHistory]);
    Message message{time.value_or(std::chrono::system_clock::now()), Severity::alarm, std::move(text.title),
                    text.steps.empty() ? Phrase{} : text.steps.front()};
    message.cause = std::move(text.detail);
    message.steps = std::move(text.steps);
    message.place = AlarmPlace{machine.core_pid, machine.status->alarms[number % kAlarmHistory].tick};
    if (then.status->alarm_axis < kAxisCount)
        message.axes = axis_letter(static_cast<Axis>(then.status->alarm_axis));
    message.is_standing = is_latched(machine, number);
    const bool is_earlier = time ? *time < machine.watched_since : machine.is_core_of_first_look;
    message.is_from_before = is_of_new_core && is_earlier;
    if (!message.is_from_before) return message;
    message.time = time.value_or(Time{});
    Phrase marked = phrase("Before this window was there: %1");
    marked.inner.push_back(std::move(message.what));
    message.what = std::move(marked);
    return message;
}

}  // namespace

std::vector<Message> fresh_alarms(const MachineView& before, const MachineView& after) {
    const std::uint64_t count = after.status->alarm_count;
    const bool is_same = is_same_core(before, after);
    const std::uint64_t told = is_same ? before.status->alarm_count : 0;
    const std::uint64_t first = std::max(told, count - std::min<std::uint64_t>(count, kAlarmHistory));
    std::vector<Message> alarms;
    for (std::uint64_t number = first; number < count; ++number)
        alarms.push_back(alarm_message(after, number, !is_same));
    return alarms;
}

}  // namespace psicarve::session
