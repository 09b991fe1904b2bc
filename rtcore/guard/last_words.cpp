// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/guard/last_words.hpp"

#include <algorithm>
#include <iterator>

#include "shared/computer/event.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::guard {
namespace {

void note_alarm(SegmentHeader& header, CoreStatus& status) {
    FlightRecord record{};
    record.tick = status.tick;
    record.kind = RecordKind::alarm;
    record.code = static_cast<std::uint16_t>(AlarmCause::core_lost);
    record.axis = kNoAxis;
    record.signals = status.signals;
    std::copy(std::begin(status.position_pulses), std::end(status.position_pulses), record.position_pulses);
    append_to_ring(header.recorder, record);
    AlarmRecord& alarm = status.alarms[status.alarm_count % kAlarmHistory];
    alarm = AlarmRecord{};
    alarm.tick = status.tick;
    alarm.cause = AlarmCause::core_lost;
    alarm.axis = kNoAxis;
    ++status.alarm_count;
}

}  // namespace

void leave_last_words(const std::string& segment_name, const std::string& group, std::uint32_t core_pid,
                      bool is_port_safe) {
    auto segment = Segment::attach(segment_name, group);
    if (!segment) return;
    SegmentHeader& header = segment->header();
    // The lock went with the core. A core that has taken it since has cleared the old status.
    if (header.core.pid.load() != core_pid || segment->core_pid()) return;
    // A core that died while it wrote leaves a record that no reader accepts: use its words all the same.
    CoreStatus status = load_words<CoreStatus>(header.status.words);
    const bool is_told = status.alarm_cause == AlarmCause::core_lost;
    status.state = MachineState::alarm;
    status.alarm_cause = AlarmCause::core_lost;
    status.alarm_axis = kNoAxis;
    status.homed_mask = 0;
    status.is_port_silent = is_port_safe ? 0 : 1;
    if (is_port_safe) status.signals &= kInputMask;
    status.seconds_left = -1.0;
    ++status.heartbeat;
    if (!is_told) note_alarm(header, status);
    write_record(header.status, status);
    event_signal(header.status_changed);
}

}  // namespace psicarve::guard
