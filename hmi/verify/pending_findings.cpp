// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/pending_findings.hpp"

#include <algorithm>
#include <utility>

#include "hmi/verify/path/point_way.hpp"

namespace psicarve::verify {

namespace {

/// Depths kept for one link; further ones count at once.
constexpr std::size_t kMostDepths = 16;

}  // namespace

void LineExtent::note(const PathLine::Distance& distance, double pulse_across_mm) noexcept {
    mm = std::max(mm, distance.mm);
    if (distance.across_mm > pulses * pulse_across_mm) pulses = distance.across_mm / pulse_across_mm;
}

void LineExtent::join(const LineExtent& other) noexcept {
    mm = std::max(mm, other.mm);
    pulses = std::max(pulses, other.pulses);
}

void PendingFindings::set_outward(bool is_outward) {
    const bool was_outward = std::exchange(is_outward_, is_outward);
    if (was_outward && !is_outward) keep_retraction();
}

void PendingFindings::note_distance(const PathLine::Distance& distance, double pulse_across_mm) noexcept {
    (is_outward_ ? retraction_.line : line_).note(distance, pulse_across_mm);
}

void PendingFindings::stray(Offence offence, const CarvePlace& place) {
    retraction_.stray = Finding{std::move(offence), place};
    if (!is_outward_) keep_retraction();
}

void PendingFindings::keep_retraction() {
    const Retraction found = std::exchange(retraction_, {});
    line_.join(found.line);
    if (found.stray) count(*found.stray);
}

bool PendingFindings::goes_too_deep(std::size_t h, std::int64_t too_deep_pulses) noexcept {
    const bool was_too_deep = std::exchange(is_too_deep_[h], too_deep_pulses > 0);
    for (Finding& finding : depths_) {
        if (was_too_deep && finding.offence.axis == kHeads[h])
            finding.most_too_deep = std::max(finding.most_too_deep, too_deep_pulses);
    }
    return too_deep_pulses > 0 && !was_too_deep;
}

void PendingFindings::add_depth(Offence offence, const CarvePlace& place, std::int64_t too_deep_pulses,
                                bool is_on_link) {
    depths_.push_back({std::move(offence), place, too_deep_pulses});
    if (!is_on_link || depths_.size() == kMostDepths) count_depths();
}

void PendingFindings::excuse_depths(Axis lost) {
    std::erase_if(depths_, [lost](const Finding& finding) {
        const bool is_its_own = lost == Axis::psi || lost == Axis::y || finding.offence.axis == lost;
        return is_its_own && finding.most_too_deep <= kNearPulses;
    });
}

void PendingFindings::count_depths() {
    for (const Finding& finding : std::exchange(depths_, {})) count(finding);
}

void PendingFindings::begin_anew() noexcept {
    retraction_ = {};
    depths_.clear();
}

void PendingFindings::count(const Finding& finding) {
    if (log_.count(1, finding.offence.time_ns)) log_.describe(finding.offence, finding.place);
}

}  // namespace psicarve::verify
