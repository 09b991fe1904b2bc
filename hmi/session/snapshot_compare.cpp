// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/snapshot_compare.hpp"

#include <utility>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/phrase/sentence.hpp"
#include "hmi/report/snapshot_differences.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::session {
namespace {

std::vector<Sentence> names() {
    return {
        {"job", phrase("job")},
        {"status", phrase("status")},
        {"source", phrase("model")},
        {"source_hash", phrase("content of the model's file")},
        {"layers", phrase("layers")},
        {"points", phrase("points")},
        {"psi_sweep_pulses", phrase("turn of the table in a layer [pulses]")},
        {"joining", phrase("joining")},
        {"feed_mm_s", phrase("feed [mm/s]")},
        {"slice report", phrase("report of the slicer")},
        {"profile", phrase("profile")},
        {"profile %1", phrase("profile: %1")},
        {"status %1", phrase("status: %1")},
        {"flight recorder entries", phrase("entries of the flight recorder")},
        {"flight recorder entry %1", phrase("flight recorder, entry %1, counted from 0")},
        {"y_pulses (%1 layers differ, the first of layer %2)",
         phrase("heights: %1 layers differ, the first is layer %2, counted from 0")},
        {"r_left_pulses (%1 points differ, the first of layer %2, point %3)",
         phrase("radii of R1: %1 points differ, the first in layer %2, point %3, counted from 0")},
        {"r_right_pulses (%1 points differ, the first of layer %2, point %3)",
         phrase("radii of R2: %1 points differ, the first in layer %2, point %3, counted from 0")},
    };
}

Phrase value_phrase(const std::string& value) {
    return phrase_for({{"there", phrase("there")}, {"none", phrase("none")}}, value)
        .value_or(phrase("%1", value));
}

Result<std::shared_ptr<const Comparison>> compared(const std::string& path_a, const std::string& path_b) {
    const auto a = load_snapshot(path_a);
    if (!a) return a.error();
    const auto b = load_snapshot(path_b);
    if (!b) return b.error();
    auto comparison = std::make_shared<Comparison>(Comparison{path_a, path_b, {}});
    for (const report::Difference& one : report::differences_between(*a, *b))
        comparison->rows.push_back({difference_phrase(one.what), value_phrase(one.a), value_phrase(one.b)});
    return std::shared_ptr<const Comparison>{std::move(comparison)};
}

}  // namespace

Phrase difference_phrase(const std::string& what) {
    return phrase_for(names(), what).value_or(phrase("%1", what));
}

void SnapshotCompare::compare(const std::string& path_a, const std::string& path_b) {
    if (is_comparing_) return;
    is_comparing_ = true;
    queue_.post([this, path_a, path_b]() -> BackgroundQueue::Finish {
        const auto comparison = compared(path_a, path_b);
        return [this, comparison] {
            is_comparing_ = false;
            if (comparison) {
                done_ = *comparison;
            } else {
                log_.add(Severity::warning, joined(phrase("Compare"), error_phrase(comparison.error())));
            }
        };
    });
}

}  // namespace psicarve::session
