// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/journal_message.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/phrase/message_phrase.hpp"
#include "hmi/session/alarm_text.hpp"
#include "hmi/session/program_phrase.hpp"
#include "shared/wording/message_record.hpp"

namespace psicarve::session {
namespace {

std::string number_of(const JournalFacts& facts, std::string_view name) {
    const auto number = facts.number(name);
    return number ? std::to_string(*number) : "?";
}

/// Counted from 1, as the window does. Empty: there is none.
std::string place_of(const JournalFacts& facts, std::string_view name) {
    const auto number = facts.number(name);
    if (!number || *number < 0 || *number == std::numeric_limits<std::int64_t>::max()) return {};
    return std::to_string(*number + 1);
}

/// Of "r1 y": "R1 Y". Other words stay as they are.
std::string axes_of(std::string_view names) {
    std::string letters;
    while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find(' '));
        names.remove_prefix(std::min(names.size(), name.size() + 1));
        const auto axis = std::ranges::find_if(kAllAxes, [&](Axis one) { return name_of(one) == name; });
        letters += letters.empty() ? "" : " ";
        letters += axis == kAllAxes.end() ? std::string{name} : axis_letter(*axis);
    }
    return letters;
}

Phrase before_phrase(const std::string& before) {
    if (before == "killed") return phrase("The one before was killed or crashed");
    if (before == "in order") return phrase("The one before ended in order");
    if (before == "none") return phrase("It is the first one");
    if (before == "no end")
        return phrase("The one before has no end: killed, crashed, or the computer was switched off");
    if (before == "no end, started again")
        return phrase("The one before has no end, and the computer was started again since");
    return phrase("How the one before ended is not known");
}

void tell_core(const JournalRecord& record, Message& told) {
    const JournalFacts& facts = record.facts;
    if (record.what == "start") {
        told.what = phrase("The core has started: version %1, port %2, process %3", facts.text("version"),
                           facts.text("port"), number_of(facts, "pid"));
        told.cause = before_phrase(facts.text("before"));
        if (facts.text("before") == "killed") told.severity = Severity::warning;
    } else if (record.what == "end") {
        told.what = phrase("The core has ended");
        told.cause = phrase("Machine: %1", facts.text("state"));
    } else if (record.what == "missed ticks") {
        told.what = phrase("%1 ticks missed, %2 since the core started", number_of(facts, "count"),
                           number_of(facts, "total"));
        told.severity = Severity::warning;
    } else if (record.what == "not written") {
        told.what = phrase("%1 records could not be written into the journal", number_of(facts, "count"));
        told.severity = Severity::warning;
    } else {
        told.what = phrase("%1", record.what);
    }
}

/// The cause with this name; none: there is none.
AlarmCause cause_named(std::string_view name) {
    for (std::uint32_t i = 0; i < kAlarmCauseCount; ++i)
        if (name_of(static_cast<AlarmCause>(i)) == name) return static_cast<AlarmCause>(i);
    return AlarmCause::none;
}

/// The machine in that alarm, as far as the journal has it.
MachineView machine_of(const JournalRecord& record) {
    const JournalFacts& facts = record.facts;
    CoreStatus status{};
    status.state = MachineState::alarm;
    status.alarm_cause = cause_named(record.what);
    status.alarm_axis = kNoAxis;
    for (const Axis axis : kAllAxes) {
        if (facts.text("axis") == name_of(axis))
            status.alarm_axis = static_cast<std::uint8_t>(index_of(axis));
        status.position_pulses[index_of(axis)] =
            facts.number(std::string{name_of(axis)} + "_pulses").value_or(0);
    }
    AlarmRecord& alarm = status.alarms[0];
    status.alarm_count = 1;
    alarm.tick = record.tick;
    alarm.cause = status.alarm_cause;
    alarm.axis = static_cast<std::uint8_t>(status.alarm_axis);
    alarm.expected = facts.number("expected").value_or(0);
    alarm.seen = facts.number("seen").value_or(0);
    alarm.first_layer = static_cast<std::uint32_t>(facts.number("first_wrong_layer").value_or(0));
    alarm.layer_count = static_cast<std::uint16_t>(facts.number("wrong_layers").value_or(0));
    MachineView machine;
    machine.life = CoreLife::alive;
    machine.status = status;
    return machine;
}

void tell_alarm(const JournalRecord& record, std::uint32_t core_pid, Message& told) {
    const JournalFacts& facts = record.facts;
    told.severity = Severity::alarm;
    told.axes = axes_of(facts.text("axis"));
    told.place = AlarmPlace{core_pid, record.tick};
    AlarmText text = alarm_text(machine_of(record));
    told.what = std::move(text.title);
    // How many ticks were missed until then is not written down.
    told.cause = cause_named(record.what) == AlarmCause::missed_ticks
                     ? phrase("Ticks were missed; motors may have lost steps.")
                     : std::move(text.detail);
    const std::string layer = place_of(facts, "layer");
    const bool is_of_program = facts.number("line").has_value();
    if (layer.empty() && !is_of_program) return;
    Phrase placed = is_of_program ? phrase("%2 (line %1 of the program)", number_of(facts, "line"))
                                  : phrase("%3 (layer %1, point %2)", layer, place_of(facts, "point"));
    placed.inner.push_back(std::move(told.what));
    told.what = std::move(placed);
}

/// Of an older core, or of a newer version, the words that it wrote.
Phrase reason_of(const JournalFacts& facts, const std::string& name) {
    const auto message = message_from(facts.text("message"), facts.text("arguments"), facts.text("text"));
    if (message) return message_phrase(*message);
    std::string reason = facts.text("reason");
    if (reason.starts_with(name + ": ")) reason.erase(0, name.size() + 2);
    return phrase("%1", reason);
}

/// What the flight recorder had by a name of its own, and commands by theirs.
Phrase command_name(const std::string& name) {
    if (name == "stop") return phrase("Stop");
    if (name == "estop") return phrase("Emergency stop");
    return phrase("Command: %1", name);
}

/// The numbers of a command, or nothing.
std::string numbers_of(const JournalRecord& record) {
    const JournalFacts& facts = record.facts;
    std::string numbers = facts.text("target");
    if (numbers.empty()) numbers = facts.text("value");
    return numbers;
}

void tell_command(const JournalRecord& record, Message& told) {
    const JournalFacts& facts = record.facts;
    told.is_command = true;
    told.axes = axes_of(facts.text("axes").empty() ? facts.text("axis") : facts.text("axes"));
    const std::string numbers = numbers_of(record);
    told.what =
        numbers.empty() ? command_name(record.what) : phrase("Command: %1 (%2)", record.what, numbers);
    const bool is_refused = facts.text("answer") == "refused";
    if (is_refused) told.severity = Severity::warning;
    if (is_refused || !facts.text("reason").empty())
        told.what = joined(std::move(told.what), reason_of(facts, record.what));
    if (facts.number("pid"))
        told.cause = phrase("Asked for by %1, process %2", facts.text("sender"), number_of(facts, "pid"));
}

void tell_job_end(const JournalFacts& facts, Message& told) {
    const std::string how = facts.text("how");
    const std::string layer = place_of(facts, "layer");
    const std::string source = facts.text("source");
    if (how == "done") {
        told.what = phrase("Job done: %1", source);
    } else if (how == "alarm") {
        told.what = phrase("Job ended by an alarm in layer %2: %1", source, layer);
        told.severity = Severity::warning;
    } else {
        told.what = phrase("Job stopped in layer %2: %1", source, layer);
    }
}

/// Of one that broke off the machine was held behind that line until it was stopped.
void tell_program_end(const JournalFacts& facts, Message& told) {
    const std::string how = facts.text("how");
    const std::string line = number_of(facts, "line");
    const bool is_refused = how == "refused";
    if (how == "done") {
        told.what = phrase("Program done, up to line %1", line);
    } else if (how == "alarm") {
        told.what = phrase("Program ended by an alarm in line %1", line);
    } else if (is_refused || how == "feeder lost") {
        told.what = joined(phrase("Program broke off behind line %1", line),
                           is_refused ? reason_of(facts, "program") : phrase("its reader was gone"));
    } else {
        told.what = phrase("Program stopped in line %1", line);
        return;
    }
    if (how != "done") told.severity = Severity::warning;
}

/// A reason that is not known is left out.
void tell_program_hold(const JournalFacts& facts, Message& told) {
    told.what = phrase("Program held in line %1", number_of(facts, "line"));
    const std::string how = facts.text("how");
    for (std::uint8_t n = 1; n < kProgramHoldCount; ++n) {
        const auto hold = static_cast<ProgramHold>(n);
        if (name_of(hold) != how) continue;
        told.what = joined(std::move(told.what), hold_phrase(hold));
        if (is_for_good(hold)) told.severity = Severity::warning;
    }
}

void tell_job_start(const JournalFacts& facts, Message& told) {
    const std::string source = facts.text("source");
    const std::string layer = place_of(facts, "first_layer");
    const std::string point = place_of(facts, "first_point");
    const bool is_dry = facts.number("dry").has_value();
    if (point.empty()) {
        told.what = is_dry ? phrase("Dry run began with layer %2: %1", source, layer)
                           : phrase("Carving began with layer %2: %1", source, layer);
    } else {
        told.what = is_dry ? phrase("Dry run began with layer %2, point %3: %1", source, layer, point)
                           : phrase("Carving began with layer %2, point %3: %1", source, layer, point);
    }
}

void tell_job(const JournalRecord& record, Message& told) {
    const JournalFacts& facts = record.facts;
    if (record.what == "loaded") {
        told.what = phrase("Job loaded: %1, %2 layers of %3 points", facts.text("source"),
                           number_of(facts, "layers"), number_of(facts, "layer_points"));
    } else if (record.what == "refused") {
        told.what = joined(phrase("Job refused"), reason_of(facts, "job"));
        told.severity = Severity::warning;
    } else if (record.what == "started") {
        tell_job_start(facts, told);
    } else if (record.what == "ended") {
        tell_job_end(facts, told);
    } else if (record.what == "program started") {
        told.what = phrase("Program begun");
    } else if (record.what == "program held") {
        tell_program_hold(facts, told);
    } else if (record.what == "program resumed") {
        told.what = phrase("Program goes on in line %1", number_of(facts, "line"));
    } else if (record.what == "program ended") {
        tell_program_end(facts, told);
    } else {
        told.what = phrase("%1", record.what);
    }
}

}  // namespace

Message journal_message(const history::LogEntry& entry, std::uint32_t core_pid) {
    const JournalRecord& record = entry.record;
    Message told{};
    told.time = std::chrono::system_clock::time_point{std::chrono::milliseconds{record.time_ms}};
    told.is_from_before = true;
    told.journal = JournalPlace{record.run, entry.is_simulator};
    if (record.what == "left out") {
        told.what = phrase("%1 more came too fast to be written down", number_of(record.facts, "count"));
        told.severity = record.kind == JournalKind::alarm ? Severity::alarm : Severity::info;
        told.is_command = record.kind == JournalKind::command;
        return told;
    }
    switch (record.kind) {
        case JournalKind::core:
            tell_core(record, told);
            break;
        case JournalKind::alarm:
            tell_alarm(record, core_pid, told);
            break;
        case JournalKind::command:
            tell_command(record, told);
            break;
        case JournalKind::job:
            tell_job(record, told);
            break;
    }
    return told;
}

}  // namespace psicarve::session
