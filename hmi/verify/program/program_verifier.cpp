// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/program/program_verifier.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "hmi/verify/pin_rules.hpp"
#include "hmi/verify/program/program_rule.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {

struct ProgramVerifier::State {
    State(JudgedProgram program, const Profile& profile)
        : path(std::move(program), profile, log), pins(profile, log, path.place(), path) {}

    OffenceLog log;
    ProgramRule path;
    PinRules pins;
};

ProgramVerifier::ProgramVerifier(JudgedProgram program, const Profile& profile)
    : state_(std::make_unique<State>(std::move(program), profile)) {}
ProgramVerifier::~ProgramVerifier() = default;

Result<void> ProgramVerifier::begin(const TraceStart& start) {
    if (const auto begun = state_->pins.begin(start); !begun) return begun;
    state_->path.begin(start);
    return {};
}

void ProgramVerifier::feed(std::span<const TraceEvent> events) {
    state_->pins.feed(events);
}

ProgramVerifyReport ProgramVerifier::finish() {
    State& s = *state_;
    s.pins.settle();
    s.path.finish(s.pins.instant_ns(), s.pins.levels());
    s.pins.finish();
    ProgramVerifyReport report;
    report.rules = s.log.rules();
    report.pulses = s.pins.pulses();
    report.ways_done = s.path.ways_done();
    report.most_off_mm = s.path.most_off_mm();
    report.run_seconds = s.path.run_seconds();
    report.trace_seconds = seconds_from_ns(s.pins.instant_ns());
    report.events = s.pins.events();
    report.lowered = s.path.lowered();
    report.lowered_seconds = s.path.lowered_seconds();
    report.lowered_count = s.path.lowered_count();
    report.times = s.path.times();
    report.bounds = s.path.bounds();
    report.failure = s.path.failure();
    report.ok = first_offence_of(report.rules) == nullptr && !report.failure;
    return report;
}

nlohmann::ordered_json lowered_json(const std::vector<LoweredFeed>& lowered) {
    auto list = nlohmann::ordered_json::array();
    for (const LoweredFeed& feed : lowered)
        list.push_back({{"first_line", feed.first_line},
                        {"last_line", feed.last_line},
                        {"share", feed.share()},
                        {"asked_seconds", feed.asked_s},
                        {"taken_seconds", feed.taken_s}});
    return list;
}

std::string lowered_text(const std::vector<LoweredFeed>& lowered, std::size_t most) {
    std::string text;
    for (std::size_t n = 0; n < std::min(most, lowered.size()); ++n) {
        const LoweredFeed& feed = lowered[n];
        text += (text.empty() ? "" : ", ") +
                std::string{feed.first_line == feed.last_line ? "line " : "lines "} +
                std::to_string(feed.first_line);
        if (feed.last_line != feed.first_line) text += " to " + std::to_string(feed.last_line);
        // No feed is lowered to a standstill.
        const long long percent = std::llround(100.0 * feed.share());
        text += percent > 99 ? " by over 99 %" : " by " + std::to_string(percent) + " %";
    }
    return text;
}

nlohmann::ordered_json program_report_json(const ProgramVerifyReport& report) {
    nlohmann::ordered_json json;
    json["verified"] = report.ok;
    json["rules"] = rules_json(report.rules);
    for (const Axis axis : kAllAxes)
        json["pulses"][std::string(psicarve::name_of(axis))] = report.pulses[index_of(axis)];
    json["ways_done"] = report.ways_done;
    json["max_line_deviation_mm"] = report.most_off_mm;
    json["run_seconds"] = report.run_seconds;
    json["lowered_seconds"] = report.lowered_seconds;
    json["lowered"] = lowered_json(report.lowered);
    json["trace_seconds"] = report.trace_seconds;
    json["events"] = report.events;
    return json;
}

std::string program_report_text(const ProgramVerifyReport& report) {
    std::string text = report.ok ? "verified: the pins obey rules 1 to 4 and run the program\n"
                                 : "not verified: the pins differ from what the program asks\n";
    text += offences_text(report.rules);
    text += "  " + std::to_string(report.ways_done) + " ways, off by " + shown_number(report.most_off_mm) +
            " mm and 1.5 pulses of an axis at most\n";
    if (!report.lowered.empty())
        text += "  lowered feeds cost " + shown_number(report.lowered_seconds) + " s, most in " +
                lowered_text(report.lowered, 3) + "\n";
    text += "  run in " + shown_number(report.run_seconds) + " s; pulses";
    for (const Axis axis : kAllAxes)
        text += " " + shown_name(axis) + " " + std::to_string(report.pulses[index_of(axis)]);
    return text + "\n";
}

}  // namespace psicarve::verify
