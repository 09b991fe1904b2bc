// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/computer_rows.hpp"

#include <string>

#include "hmi/phrase/finding_phrase.hpp"
#include "shared/computer/realtime_step.hpp"

namespace psicarve::session {
namespace {

using V = ComputerRow::Verdict;

bool has(std::uint32_t mask, RealtimeStep step) {
    return (mask >> static_cast<std::uint32_t>(step) & 1U) != 0;
}

Phrase in_force(const CoreStatus& status, RealtimeStep step) {
    if (step == RealtimeStep::tick_cpu && status.tick_cpu >= 0)
        return phrase("processor %1", std::to_string(status.tick_cpu));
    if (step == RealtimeStep::tick_cpu) return phrase("any processor");
    if (step == RealtimeStep::scheduling)
        return phrase("SCHED_FIFO, priority %1", std::to_string(status.tick_priority));
    return phrase("in force");
}

V verdict_of(doctor::Verdict verdict) {
    if (verdict == doctor::Verdict::ok) return V::good;
    return verdict == doctor::Verdict::warning ? V::warning : V::problem;
}

Phrase said(const std::string& text) {
    return text.empty() ? Phrase{} : phrase("%1", text);
}

}  // namespace

std::vector<ComputerRow> realtime_rows(const CoreStatus& status) {
    std::vector<ComputerRow> rows;
    if (status.is_virtual_clock != 0) return rows;
    for (const RealtimeStep step : kAllRealtimeSteps) {
        ComputerRow row{said(std::string{name_of(step)}), V::good, in_force(status, step), {}};
        if (!has(status.realtime_done, step)) {
            const bool was_asked = has(status.realtime_asked, step);
            row.verdict = V::warning;
            row.seen = was_asked ? phrase("refused") : phrase("not asked for");
            if (was_asked) row.remedy = said(std::string{remedy_of(step)});
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<ComputerRow> finding_rows(const std::vector<doctor::Finding>& findings) {
    std::vector<ComputerRow> rows;
    for (const doctor::Finding& finding : findings) {
        Phrase remedy = finding_phrase(finding.remedy);
        if (!finding.meaning.empty()) remedy = joined(finding_phrase(finding.meaning), std::move(remedy));
        rows.push_back({finding_phrase(finding.name), verdict_of(finding.verdict),
                        finding_phrase(finding.seen), std::move(remedy)});
    }
    return rows;
}

}  // namespace psicarve::session
