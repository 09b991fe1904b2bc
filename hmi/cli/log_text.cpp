// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/log_text.hpp"

#include <pwd.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/log_time.hpp"
#include "hmi/report/status_json.hpp"
#include "hmi/report/utc_text.hpp"
#include "shared/machine/signal.hpp"
#include "shared/record/journal.hpp"

namespace psicarve::cli {
namespace {

constexpr std::size_t kKindWidth = 7;
constexpr std::size_t kMachineWidth = 9;

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text;
}

/// " WORD VALUE", or nothing where there is none.
std::string told(const JournalFacts& facts, std::string_view name, const std::string& before,
                 const std::string& after = "") {
    if (const auto number = facts.number(name)) return before + std::to_string(*number) + after;
    const std::string text = facts.text(name);
    return text.empty() ? text : before + text + after;
}

std::string end_before_text(const std::string& before) {
    if (before == "killed") return "the one before was killed or crashed";
    if (before == "in order") return "the one before ended in order";
    if (before == "none") return "the first one";
    const std::string no_end = "the one before has no end: killed, crashed, or the computer was switched off";
    if (before == "no end") return no_end;
    if (before == "no end, started again") return no_end + "; the computer was started again since";
    return "how the one before ended is not known";
}

std::string core_text(const JournalRecord& record) {
    const JournalFacts& facts = record.facts;
    if (record.what == "start") {
        return "start" + told(facts, "version", ": version ") + told(facts, "port", ", port ") +
               told(facts, "clock", ", ", " clock") + told(facts, "profile", ", profile ") +
               told(facts, "pid", ", pid ") + "; " + end_before_text(facts.text("before"));
    }
    if (record.what == "end")
        return "end" + told(facts, "state", ", the machine ") + told(facts, "cause", ": ");
    if (record.what == "missed ticks")
        return told(facts, "count", "", " ticks missed") + told(facts, "total", ", ", " since the start");
    if (record.what == "not written") return told(facts, "count", "", " records could not be written");
    return record.what;
}

std::string place_text(const JournalFacts& facts) {
    if (!facts.number("points_total")) return {};
    return told(facts, "layer", " at layer ") + told(facts, "point", ", point ") +
           told(facts, "points_done", " (") + told(facts, "points_total", " of ", " points)");
}

std::string tripped_text(const JournalFacts& facts) {
    const auto signals = static_cast<SignalWord>(facts.number("signals").value_or(0));
    if ((signals & kInputMask) == 0) return {};
    return "; tripped: " + report::signals_text(signals, kInputMask);
}

std::string alarm_text(const JournalRecord& record) {
    const JournalFacts& facts = record.facts;
    std::string text = record.what + told(facts, "axis", ", ") + place_text(facts) +
                       told(facts, "line", " at line ", " of the program") +
                       told(facts, "expected", "; expected ", " pulses") + told(facts, "seen", ", seen ") +
                       told(facts, "wrong_layers", "; wrong may be ", " layers") +
                       told(facts, "first_wrong_layer", " from ") + tripped_text(facts) + "; at";
    for (const Axis axis : kAllAxes) {
        const std::string name{name_of(axis)};
        text += told(facts, name + "_pulses", " " + name + " ");
    }
    return text + " pulses";
}

std::string user_text(std::int64_t uid) {
    std::array<char, 4096> room{};
    passwd entry{};
    passwd* found = nullptr;
    const auto user = static_cast<uid_t>(uid);
    if (getpwuid_r(user, &entry, room.data(), room.size(), &found) != 0 || found == nullptr)
        return "user " + std::to_string(uid);
    return entry.pw_name;
}

std::string sender_text(const JournalFacts& facts) {
    if (!facts.number("pid")) return {};
    const auto uid = facts.number("uid");
    return " (" + told(facts, "sender", "", ", ") + told(facts, "pid", "pid ") +
           (uid ? ", " + user_text(*uid) : std::string{}) + ")";
}

std::string command_text(const JournalRecord& record) {
    const JournalFacts& facts = record.facts;
    if (record.what == "left out") return told(facts, "count", "", " more commands came too fast to be kept");
    std::string text = record.what + told(facts, "axes", " ") + told(facts, "axis", " ") +
                       told(facts, "value", " ") + told(facts, "target", " to ") +
                       told(facts, "first_layer", " from layer ") + told(facts, "first_point", ", point ") +
                       told(facts, "layers", ", ", " layers");
    if (facts.number("resumes")) text += " where it stopped";
    if (facts.number("dry")) text += ", dry";
    std::string reason = facts.text("reason");
    if (reason.starts_with(record.what + ": ")) reason.erase(0, record.what.size() + 2);
    return text + told(facts, "answer", ": ") + (reason.empty() ? reason : ", " + reason) +
           sender_text(facts);
}

std::string job_text(const JournalRecord& record) {
    const JournalFacts& facts = record.facts;
    if (record.what == "left out") return told(facts, "count", "", " more came too fast to be kept");
    std::string text = record.what + told(facts, "source", " ") + told(facts, "reason", ": ");
    if (record.what == "loaded") {
        text += told(facts, "layers", ", ", " layers") + told(facts, "layer_points", " of ", " points") +
                told(facts, "checksum", ", job ");
    }
    text += told(facts, "first_layer", " with layer ") + told(facts, "first_point", ", point ") +
            told(facts, "how", ": ") + place_text(facts);
    if (facts.number("dry")) text += ", dry";
    return text;
}

/// "program held: tool change at line 8"
std::string program_text(const JournalRecord& record) {
    const JournalFacts& facts = record.facts;
    std::string text = record.what + told(facts, "number", ", no. ") + told(facts, "how", ": ") +
                       told(facts, "line", " at line ");
    if (facts.number("single")) text += ", single block";
    if (facts.number("optional_stop")) text += ", optional stop";
    const auto waits = facts.number("waits");
    if (waits) text += "; it had to wait for more " + count_text(static_cast<std::uint64_t>(*waits), "time");
    return text + told(facts, "reason", "; ");
}

std::string what_text(const JournalRecord& record) {
    switch (record.kind) {
        case JournalKind::core:
            return core_text(record);
        case JournalKind::alarm:
            return record.what == "left out"
                       ? told(record.facts, "count", "", " more alarms came too fast to be kept")
                       : alarm_text(record);
        case JournalKind::command:
            return command_text(record);
        case JournalKind::job:
            return record.what.starts_with("program ") ? program_text(record) : job_text(record);
    }
    return record.what;
}

std::string on_one_line(std::string text) {
    std::ranges::replace_if(
        text, [](char letter) { return letter == '\n' || letter == '\t'; }, ' ');
    return text;
}

}  // namespace

std::string log_line(const LogEntry& entry) {
    const std::string machine = entry.is_simulator ? "simulator" : "machine";
    return local_time_text(entry.record.time_ms) + "  " +
           padded(std::string{name_of(entry.record.kind)}, kKindWidth) + "  " +
           padded(machine, kMachineWidth) + "  " + on_one_line(what_text(entry.record)) + "\n";
}

nlohmann::ordered_json log_json(const LogEntry& entry) {
    const JournalRecord& record = entry.record;
    nlohmann::ordered_json object{{"time", report::utc_stamp(record.time_ms / 1000)},
                                  {"time_ms", record.time_ms},
                                  {"kind", std::string{name_of(record.kind)}},
                                  {"what", record.what},
                                  {"is_simulator", entry.is_simulator},
                                  {"run", record.run},
                                  {"sequence", record.sequence},
                                  {"tick", record.tick}};
    nlohmann::ordered_json facts = nlohmann::ordered_json::object();
    for (const auto& [name, value] : record.facts.all()) {
        if (const auto* number = std::get_if<std::int64_t>(&value)) {
            facts[name] = *number;
        } else {
            facts[name] = std::get<std::string>(value);
        }
    }
    object["facts"] = facts;
    return object;
}

}  // namespace psicarve::cli
