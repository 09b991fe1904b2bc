// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/layers_in_doubt.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "hmi/report/status_json.hpp"
#include "hmi/session/display_text.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

std::uint32_t end_of(const verify::LayerRange& range) noexcept {
    return range.first + range.count;
}

std::uint64_t size_of(std::int64_t pulses) noexcept {
    const auto bits = static_cast<std::uint64_t>(pulses);
    return pulses < 0 ? 0U - bits : bits;
}

}  // namespace

void LayersInDoubt::forget() {
    layers_.clear();
    most_off_pulses_ = 0;
}

bool LayersInDoubt::carved_again(std::uint32_t first, std::uint32_t end) {
    std::vector<verify::LayerRange> left;
    bool has_met = false;
    for (const verify::LayerRange& range : layers_) {
        const bool is_apart = end <= first || end <= range.first || end_of(range) <= first;
        if (is_apart) {
            left.push_back(range);
            continue;
        }
        has_met = true;
        if (range.first < first) left.push_back({range.first, first - range.first});
        if (end < end_of(range)) left.push_back({end, end_of(range) - end});
    }
    layers_ = std::move(left);
    if (layers_.empty()) most_off_pulses_ = 0;
    return has_met;
}

bool LayersInDoubt::take(const CoreStatus& status) {
    // Another core counts anew.
    if (status.alarm_count < taken_) taken_ = 0;
    bool has_new = false;
    for (const AlarmRecord& alarm : report::alarms_of(status, taken_)) {
        const auto lost = report::lost_steps_of(alarm, {});
        if (!lost || !lost->layers || alarm.tick < status.job_start_tick) continue;
        add(*lost->layers);
        most_off_pulses_ = std::max(most_off_pulses_, size_of(lost->off_pulses));
        has_new = true;
    }
    taken_ = status.alarm_count;
    return has_new;
}

void LayersInDoubt::add(const report::LostSteps::Layers& layers) {
    verify::LayerRange added{layers.first, layers.last - layers.first + 1U};
    // Those that it meets become one with it.
    std::erase_if(layers_, [&added](const verify::LayerRange& range) {
        const bool is_apart = range.first > end_of(added) || end_of(range) < added.first;
        if (is_apart) return false;
        const std::uint32_t end = std::max(end_of(range), end_of(added));
        added.first = std::min(range.first, added.first);
        added.count = end - added.first;
        return true;
    });
    layers_.insert(std::ranges::lower_bound(layers_, added.first, {}, &verify::LayerRange::first), added);
}

Phrase doubt_text(const LayersInDoubt& doubt, const report::TableSize& table) {
    if (doubt.layers().empty()) return {};
    std::string amount;
    if (table.pulses_per_rev > 0 && table.reach_mm > 0.0) {
        const double turns =
            static_cast<double>(doubt.most_off_pulses()) / static_cast<double>(table.pulses_per_rev);
        amount = " (≤ " + number_text(turns * 2.0 * kPi * table.reach_mm, 3) + " mm)";
    }
    const verify::LayerRange& first = doubt.layers().front();
    const auto number = [](std::uint64_t layer) { return std::to_string(layer + 1); };
    if (doubt.layers().size() > 1) {
        const std::uint64_t count = std::accumulate(
            doubt.layers().begin(), doubt.layers().end(), std::uint64_t{0},
            [](std::uint64_t sum, const verify::LayerRange& range) { return sum + range.count; });
        return phrase("%1 layers can be wrong, from layer %2 on%3", std::to_string(count),
                      number(first.first), amount);
    }
    if (first.count == 1) return phrase("Layer %1 can be wrong%2", number(first.first), amount);
    return phrase("Layers %1 to %2 can be wrong%3", number(first.first),
                  number(std::uint64_t{first.first} + first.count - 1U), amount);
}

}  // namespace psicarve::session
