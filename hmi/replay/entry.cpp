// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/entry.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/profile/pin_rows.hpp"
#include "hmi/session/program_phrase.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::replay {
namespace {

using session::phrase;
using session::Phrase;
using session::Severity;

// A file is not trusted: numbers without a name are shown as numbers.
template <typename Name>
std::string named(std::uint16_t code, std::uint32_t count, Name name) {
    return code < count ? std::string{name(code)} : std::to_string(code);
}
std::string command_name(const FlightRecord& record) {
    return named(record.code, kCommandKindCount,
                 [](std::uint16_t code) { return name_of(static_cast<CommandKind>(code)); });
}
std::string state_name(const FlightRecord& record) {
    return named(record.code, kMachineStateCount,
                 [](std::uint16_t code) { return name_of(static_cast<MachineState>(code)); });
}
std::string cause_name(const FlightRecord& record) {
    return named(record.code, kAlarmCauseCount,
                 [](std::uint16_t code) { return name_of(static_cast<AlarmCause>(code)); });
}
std::string axis_name(const FlightRecord& record) {
    return record.axis < kAxisCount ? session::axis_letter(static_cast<Axis>(record.axis)) : "";
}

void tell_command(const FlightRecord& record, Entry& entry) {
    const bool is_refused = record.answer == static_cast<std::uint32_t>(AnswerKind::refused);
    entry.is_major = true;
    if (is_refused) {
        entry.severity = Severity::warning;
        entry.what = phrase("Refused: %1", command_name(record));
    } else if (static_cast<CommandKind>(record.code) == CommandKind::override) {
        entry.what = phrase("Feed override %1 %", std::to_string(record.value));
    } else if (static_cast<CommandKind>(record.code) == CommandKind::rapid_override) {
        entry.what = phrase("Override of rapids %1 %", std::to_string(record.value));
    } else if (static_cast<CommandKind>(record.code) == CommandKind::single) {
        entry.what = record.value != 0 ? phrase("Single block on") : phrase("Single block off");
    } else if (static_cast<CommandKind>(record.code) == CommandKind::optional_stop) {
        entry.what = record.value != 0 ? phrase("Optional stop on") : phrase("Optional stop off");
    } else {
        entry.what = phrase("Command: %1", command_name(record));
    }
}

Phrase held_phrase(const std::string& line, ProgramHold hold) {
    Phrase held = phrase("Program held in line %1", line);
    Phrase why = session::hold_phrase(hold);
    return why.is_empty() ? held : session::joined(std::move(held), std::move(why));
}

Phrase ended_phrase(const std::string& line, ProgramEnding ending) {
    if (ending == ProgramEnding::done) return phrase("Program done, up to line %1", line);
    return ending == ProgramEnding::alarm ? phrase("Program ended by an alarm in line %1", line)
                                          : phrase("Program stopped in line %1", line);
}

/// Each block of a program in single block would be a mark: those are entries alone, as its lines are.
void tell_program(const FlightRecord& record, Entry& entry) {
    const std::string line = std::to_string(record.value);
    const std::uint8_t detail = program_detail_of(record);
    const auto hold = static_cast<ProgramHold>(detail);
    const auto ending = static_cast<ProgramEnding>(detail);
    entry.is_major = true;
    switch (program_event_of(record)) {
        case ProgramEvent::begun:
            entry.what = phrase("Program begun");
            return;
        case ProgramEvent::held:
            entry.what = held_phrase(line, hold);
            entry.is_major = hold != ProgramHold::single;
            if (is_for_good(hold)) entry.severity = Severity::warning;
            return;
        case ProgramEvent::ended:
            entry.what = ended_phrase(line, ending);
            if (ending == ProgramEnding::alarm) entry.severity = Severity::warning;
            return;
        case ProgramEvent::resumed:
            entry.what = phrase("Program goes on in line %1", line);
            break;
        case ProgramEvent::stopping:
            entry.what = phrase("Program slows down to a stop in line %1", line);
            break;
        case ProgramEvent::line:
            entry.what = phrase("Program, line %1", line);
            break;
        default:
            entry.what = phrase("Entry of kind %1", std::to_string(static_cast<unsigned>(record.kind)));
            break;
    }
    entry.is_major = false;
}

void tell_input(const FlightRecord& record, Entry& entry) {
    std::vector<Phrase> closed;
    for (std::size_t k = kFirstInput; k < kFirstSwitchedOutput; ++k) {
        const auto signal = static_cast<Signal>(k);
        if ((record.signals & bit_of(signal)) == 0) continue;
        closed.push_back(session::name_of_signal(signal));
    }
    entry.what = closed.empty() ? phrase("Inputs: none active") : phrase("Inputs active: %1");
    if (!closed.empty()) entry.what.inner.push_back(session::listed(std::move(closed)));
}

}  // namespace

Entry entry_of(const FlightRecord& record, std::int64_t time_ns) {
    Entry entry;
    entry.time_ns = time_ns;
    switch (record.kind) {
        case RecordKind::command:
            tell_command(record, entry);
            break;
        case RecordKind::stop:
            entry.what = phrase("Stop asked for");
            entry.is_major = true;
            break;
        case RecordKind::emergency_stop:
            entry.what = phrase("Emergency stop asked for");
            entry.severity = Severity::warning;
            entry.is_major = true;
            break;
        case RecordKind::input_edge:
            tell_input(record, entry);
            break;
        case RecordKind::state_change:
            entry.what = phrase("Machine: %1", state_name(record));
            break;
        case RecordKind::alarm:
            entry.severity = Severity::alarm;
            entry.what = record.axis < kAxisCount
                             ? phrase("Alarm: %1 of %2", cause_name(record), axis_name(record))
                             : phrase("Alarm: %1", cause_name(record));
            entry.is_major = true;
            break;
        case RecordKind::job:
            entry.what = phrase("Job no. %1 accepted", std::to_string(record.value));
            entry.is_major = true;
            break;
        case RecordKind::home_latch:
            entry.what = phrase("%1 found its sensor", axis_name(record));
            break;
        case RecordKind::gap:
            entry.severity = Severity::warning;
            entry.what = phrase("%1 ticks missed", std::to_string(record.value));
            entry.is_major = true;
            break;
        case RecordKind::failure:
            entry.severity = Severity::warning;
            entry.what = phrase("The core found: %1", cause_name(record));
            entry.is_major = true;
            break;
        case RecordKind::order:
            entry.what = phrase("Part of the next command");
            break;
        case RecordKind::jog_end:
            entry.what = phrase("Jog ends");
            break;
        case RecordKind::program:
            tell_program(record, entry);
            break;
        default:
            entry.what = phrase("Entry of kind %1", std::to_string(static_cast<unsigned>(record.kind)));
            break;
    }
    return entry;
}

std::vector<Entry> entries_of(const std::vector<TraceIndex::PinChange>& changes) {
    constexpr SignalWord kDrives = kEnableMask;
    std::vector<Entry> entries;
    const auto add = [&](const TraceIndex::PinChange& change, Severity severity, Phrase what) {
        entries.push_back({change.time_ns, severity, std::move(what), true});
    };
    for (const TraceIndex::PinChange& change : changes) {
        if (change.is_definition) {
            add(change, Severity::info, phrase("Homing: positions defined"));
            continue;
        }
        const SignalWord changed = change.before ^ change.after;
        const bool was_on = (change.before & kDrives) != 0;
        if (const bool is_on = (change.after & kDrives) != 0; is_on != was_on)
            add(change, Severity::info, is_on ? phrase("Drives switched on") : phrase("Drives switched off"));
        if ((changed & bit_of(Signal::spindle)) != 0) {
            const bool is_on = (change.after & bit_of(Signal::spindle)) != 0;
            add(change, Severity::info, is_on ? phrase("Spindle on") : phrase("Spindle off"));
        }
        for (std::size_t k = kFirstSwitchedOutput; k < kSignalCount; ++k) {
            const auto output = static_cast<Signal>(k);
            if ((changed & bit_of(output)) == 0) continue;
            Phrase what =
                (change.after & bit_of(output)) != 0 ? phrase("Switched on: %1") : phrase("Switched off: %1");
            what.inner.push_back(session::name_of_signal(output));
            add(change, Severity::info, std::move(what));
        }
        for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
            const SignalWord bit = bit_of(sensor_of(axis));
            if ((changed & bit) == 0) continue;
            const char* const letter = session::axis_letter(axis);
            add(change, Severity::info,
                (change.after & bit) != 0 ? phrase("Limit switch %1 closed", letter)
                                          : phrase("Limit switch %1 open", letter));
        }
        if ((changed & bit_of(Signal::estop)) != 0) {
            const bool is_pressed = (change.after & bit_of(Signal::estop)) != 0;
            add(change, is_pressed ? Severity::alarm : Severity::info,
                is_pressed ? phrase("Emergency stop switch pressed")
                           : phrase("Emergency stop switch released"));
        }
    }
    return entries;
}

int entry_at(const std::vector<Entry>& entries, std::int64_t time_ns) noexcept {
    const auto later = std::upper_bound(
        entries.begin(), entries.end(), time_ns,
        [](std::int64_t wanted_ns, const Entry& entry) { return wanted_ns < entry.time_ns; });
    return static_cast<int>(later - entries.begin()) - 1;
}

int next_entry(const std::vector<Entry>& entries, std::int64_t time_ns) noexcept {
    const int next = entry_at(entries, time_ns) + 1;
    return next < static_cast<int>(entries.size()) ? next : -1;
}

int entry_before(const std::vector<Entry>& entries, std::int64_t time_ns) noexcept {
    const auto first = std::lower_bound(
        entries.begin(), entries.end(), time_ns,
        [](const Entry& entry, std::int64_t wanted_ns) { return entry.time_ns < wanted_ns; });
    return static_cast<int>(first - entries.begin()) - 1;
}

}  // namespace psicarve::replay
