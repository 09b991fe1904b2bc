// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/verify_report.hpp"

#include <nlohmann/json.hpp>

#include "hmi/verify/offence_log.hpp"

namespace psicarve::verify {

namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

const char* name_of(Bound bound) {
    return bound == Bound::at_most ? "at-most" : bound == Bound::at_least ? "at-least" : "exactly";
}

Json offence_json(const Offence& offence) {
    Json json;
    json["rule"] = offence.rule;
    json["fault"] = offence.fault;
    json["axis"] = offence.axis ? Json(std::string(psicarve::name_of(*offence.axis))) : Json(nullptr);
    json["time_ns"] = offence.time_ns;
    json["layer"] = or_null(offence.layer);
    json["point"] = or_null(offence.point);
    json["measured"] = offence.measured;
    json["allowed"] = offence.allowed;
    json["bound"] = name_of(offence.bound);
    json["unit"] = offence.unit;
    if (offence.line) json["line"] = *offence.line;
    if (!offence.pass.empty()) json["pass"] = offence.pass;
    json["sentence"] = offence.sentence;
    return json;
}

std::string layers_text(const VerifyReport& report) {
    if (report.is_whole_job) return {};
    const std::uint32_t last = report.first_layer + report.layer_count - 1;
    if (last == report.first_layer) return " in layer " + std::to_string(last);
    return " in layers " + std::to_string(report.first_layer) + " to " + std::to_string(last);
}

std::string carved_text(const VerifyReport& report) {
    if (report.carve_seconds == 0.0) return "nothing was carved";
    return (report.is_complete ? "carved in " : "carved for ") + shown_number(report.carve_seconds) + " s";
}

}  // namespace

std::string judged_text(const VerifyReport& report) {
    std::string text = layers_text(report);
    if (report.first_point)
        text += ", from point " + std::to_string(*report.first_point) + " of layer " +
                std::to_string(report.first_layer) + " on";
    return report.is_cut ? text + ", up to where it was recorded" : text;
}

Json rules_json(const RuleResults& results) {
    Json rules = Json::array();
    for (std::size_t r = 0; r < kRuleCount; ++r) {
        const RuleResult& result = results[r];
        Json rule;
        rule["rule"] = r + 1;
        rule["ok"] = result.judged ? Json(result.offences == 0) : Json(nullptr);
        rule["offences"] = result.offences;
        rule["first"] = result.first ? offence_json(*result.first) : Json(nullptr);
        rules.push_back(rule);
    }
    return rules;
}

const Offence* first_offence_of(const RuleResults& rules) noexcept {
    const Offence* earliest = nullptr;
    for (const RuleResult& rule : rules) {
        if (rule.first && (earliest == nullptr || rule.first->time_ns < earliest->time_ns))
            earliest = &*rule.first;
    }
    return earliest;
}

std::string offences_text(const RuleResults& rules) {
    std::string text;
    for (const RuleResult& result : rules) {
        if (!result.first) continue;
        text += "  " + result.first->sentence;
        if (result.offences > 1) text += " (the first of " + std::to_string(result.offences) + ")";
        text += "\n";
    }
    return text;
}

std::string report_json(const VerifyReport& report) {
    Json json;
    json["verified"] = report.ok;
    json["rules"] = rules_json(report.rules);
    for (const Axis axis : kAllAxes)
        json["pulses"][std::string(psicarve::name_of(axis))] = report.pulses[index_of(axis)];
    json["points_visited"] = report.points_visited;
    json["points_total"] = report.points_total;
    json["first_layer"] = report.first_layer;
    json["layers"] = report.layer_count;
    if (report.first_point) json["first_point"] = *report.first_point;
    if (report.is_cut) json["cut_short"] = true;
    if (report.is_dry) json["dry_run"] = true;
    json["max_deviation_pulses"] = report.max_deviation_pulses;
    json["uncarved_cells"] = report.uncarved_cells;
    json["max_line_deviation_mm"] = report.max_line_deviation_mm;
    json["max_line_deviation_pulses"] = report.max_line_deviation_pulses;
    json["carve_seconds"] = report.carve_seconds > 0.0 ? Json(report.carve_seconds) : Json(nullptr);
    json["trace_seconds"] = report.trace_seconds;
    json["events"] = report.events;
    for (const PassTime& pass : report.passes)
        json["passes"].push_back({{"pass", pass.name}, {"layers", pass.layers}, {"seconds", pass.seconds}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string report_text(const VerifyReport& report) {
    const char* const obeyed = report.is_dry   ? "verified: a dry run, whose pins obey rules 2 to 4\n"
                               : report.is_cut ? "verified: the pins obey rules 1 to 4 as far as they go\n"
                                               : "verified: the pins obey rules 1 to 4 and carve the job\n";
    std::string text = report.ok ? obeyed : "not verified: the pins differ from what the job asks\n";
    text += offences_text(report.rules);
    text += "  points " + std::to_string(report.points_visited) + " of " +
            std::to_string(report.points_total) + judged_text(report) + ", largest deviation " +
            std::to_string(report.max_deviation_pulses) + " pulses at points, " +
            shown_number(report.max_line_deviation_mm) + " mm between them\n";
    if (report.uncarved_cells > 0)
        text +=
            "  " + std::to_string(report.uncarved_cells) + " cells of the surface were reached by no tip\n";
    for (const PassTime& pass : report.passes)
        text += "  " + pass.name + ": " + std::to_string(pass.layers) + " layers in " +
                shown_number(pass.seconds) + " s\n";
    text += "  " + carved_text(report) + "; pulses";
    for (const Axis axis : kAllAxes)
        text += " " + shown_name(axis) + " " + std::to_string(report.pulses[index_of(axis)]);
    return text + "\n";
}

}  // namespace psicarve::verify
