// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/job_facts.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/display_text.hpp"

namespace psicarve::session {
namespace {

constexpr double kPercent = 100.0;
constexpr double kBytesPerMb = 1e6;

Phrase joining_phrase(Joining joining) {
    switch (joining) {
        case Joining::continuous:
            return phrase("continuous");
        case Joining::zigzag:
            return phrase("zigzag");
        case Joining::spiral:
            return phrase("spiral");
    }
    return {};
}

Phrase count_or_none(const std::optional<std::uint64_t>& count) {
    return count ? phrase("%1", count_text(static_cast<std::int64_t>(*count))) : phrase("–");
}

Phrase size_phrase(const JobFacts& facts, std::uint64_t source_bytes) {
    if (!facts.triangles) return phrase("–");
    const std::string faces = count_text(static_cast<std::int64_t>(*facts.triangles));
    if (source_bytes == 0) return phrase("%1 faces", faces);
    return phrase("%1 MB, %2 faces", number_text(static_cast<double>(source_bytes) / kBytesPerMb, 1), faces);
}

}  // namespace

JobFacts job_facts(const JobView& job) {
    JobFacts facts;
    facts.joining = job.joining();
    const auto report = nlohmann::json::parse(job.report_json(), nullptr, false);
    if (!report.is_object()) return facts;
    const auto count_of = [&report](const char* key) -> std::optional<std::uint64_t> {
        const auto found = report.find(key);
        if (found == report.end() || !found->is_number_unsigned()) return std::nullopt;
        return found->get<std::uint64_t>();
    };
    facts.triangles = count_of("triangles");
    facts.open_points = count_of("open_points");
    if (const auto share = report.find("undercut_share"); share != report.end() && share->is_number())
        facts.undercut_share = share->get<double>();
    return facts;
}

Phrase pass_phrase(const JobView& job, std::optional<std::uint32_t> layer) {
    const auto passes = job.passes();
    if (passes.size() < 2) return {};
    const std::string roughing = std::to_string(passes[passes.size() - 2].number);
    if (!layer || *layer >= job.layer_count()) return phrase("%1 roughing, finishing", roughing);
    const JobPass& pass = passes[job.pass_of(*layer)];
    if (pass.kind == static_cast<std::uint32_t>(PassKind::finishing)) return phrase("finishing pass");
    return phrase("roughing %1 of %2", std::to_string(pass.number), roughing);
}

Phrase bound_phrase(const cam::LeastTime& least) {
    constexpr double kLeastTold = 0.05;
    constexpr std::size_t kMostTold = 2;
    const double total = least.total();
    if (!(total > 0.0)) return phrase("–");
    const auto percent = [total](double seconds) { return number_text(kPercent * seconds / total, 0); };
    std::vector<std::pair<double, Phrase>> bounds;
    bounds.emplace_back(least.feed_seconds, phrase("feed %1 %", percent(least.feed_seconds)));
    for (const Axis axis : kAllAxes) {
        const double seconds = least.axis_seconds[index_of(axis)];
        bounds.emplace_back(seconds, phrase("%1 %2 %", axis_letter(axis), percent(seconds)));
    }
    std::stable_sort(bounds.begin(), bounds.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Phrase> told;
    for (const auto& [seconds, text] : bounds) {
        if (told.size() < kMostTold && seconds >= kLeastTold * total) told.push_back(text);
    }
    return listed(std::move(told));
}

std::vector<FactRow> fact_rows(const JobFacts& facts, std::uint64_t source_bytes) {
    return {{phrase("Source size"), size_phrase(facts, source_bytes)},
            {phrase("Joining"), joining_phrase(facts.joining)},
            {phrase("Undercut"),
             facts.undercut_share
                 ? phrase("%1 % of the surface", number_text(kPercent * *facts.undercut_share, 1))
                 : phrase("–")},
            {phrase("Open points"), count_or_none(facts.open_points)}};
}

}  // namespace psicarve::session
