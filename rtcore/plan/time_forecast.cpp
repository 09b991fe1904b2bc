// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/time_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <utility>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/block_list.hpp"
#include "rtcore/plan/carving.hpp"
#include "rtcore/plan/path.hpp"
#include "rtcore/plan/tick_times.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

// Of a whole job. More say little more; fewer where that would be more than every fourth layer, but then so
// many: a few layers are soon planned, and may have nothing in common.
constexpr std::uint32_t kMostSamples = 16;
constexpr std::uint32_t kFewSamples = 8;
constexpr std::uint32_t kLayersASample = 4;

/// In [begin, end): amid it for 0, from there on by the golden ratio, in step with no period.
std::uint32_t somewhere(std::uint32_t begin, std::uint32_t end, std::uint32_t i) {
    constexpr std::uint32_t kGolden = 0x9E3779B9;  // of 2^32
    const std::uint32_t place = kGolden * i + (std::uint32_t{1} << 31U);
    return begin + static_cast<std::uint32_t>((std::uint64_t{place} * (end - begin)) >> 32U);
}

/// Straight from point to point at full speed, or at the feed.
double least_seconds(const MachineLimits& limits, const Pulses4& from, const Pulses4& to) {
    double seconds = 0.0;
    std::array<double, kAxisCount> way_mm{};
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const auto way = static_cast<double>(std::abs(to[k] - from[k]));
        way_mm[k] = way / limits.axes[k].pulses_per_unit;
        seconds = std::max({seconds, way / limits.axes[k].speed_pps, way / limits.max_iterations_per_s});
    }
    const std::array<double, 2> radius_mm = greatest_radii_mm(limits, from, to);
    const double turn_rad = rad_from_pulses(to[kPsi] - from[kPsi], limits.pulses_per_rev);
    for (std::size_t head = 0; head < kHeads; ++head) {
        if (limits.outside.holds(head, from[head], to[head])) continue;
        const double around_mm = radius_mm[head] * turn_rad;
        const double way2_mm2 = around_mm * around_mm + way_mm[head] * way_mm[head] + way_mm[kY] * way_mm[kY];
        seconds = std::max(seconds, std::sqrt(way2_mm2) / limits.feed_mm_s);
    }
    return seconds;
}

}  // namespace

TimeForecast::TimeForecast(const MachineLimits& limits, std::shared_ptr<const JobView> job)
    : limits_(limits_of_job(limits, *job)), job_(std::move(job)) {
    const auto passes = static_cast<std::uint32_t>(job_->passes().size());
    for (std::uint32_t pass = 0; pass < passes; ++pass) choose_samples(pass);
    samples_to_add_ = samples_.size() / 2;
    way_s_.reserve(job_->layer_count());
    cut_s_.reserve(job_->layer_count());
}

// One somewhere in each of as many equal stretches of the pass: evenly spaced ones would all be alike where
// layers come back as often, as with ribs or threads. At both ends, where a body differs most from its rest,
// amid the stretch. Of a spiral, rows that are planned at once.
void TimeForecast::choose_samples(std::uint32_t pass) {
    const JobPass& layers = job_->passes()[pass];
    const std::uint32_t at_once = layers_at_once(*job_, layers.first_layer);
    const std::uint32_t parts = (layers.layer_count + at_once - 1) / at_once;
    const auto of_pass = [&](std::uint32_t samples) {
        const std::uint64_t all = std::uint64_t{samples} * layers.layer_count;
        return static_cast<std::uint32_t>((all + job_->layer_count() - 1) / job_->layer_count());
    };
    const std::uint32_t few = std::max(of_pass(kFewSamples), parts / kLayersASample);
    const std::uint32_t count = std::min({of_pass(kMostSamples), few, parts});
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto begin = static_cast<std::uint32_t>(std::uint64_t{i} * parts / count);
        const auto end = static_cast<std::uint32_t>((i + 1ULL) * parts / count);
        samples_.push_back(
            sample_from(layers.first_layer + somewhere(begin, end, i + 1 < count ? i : 0) * at_once));
    }
}

TimeForecast::Sample TimeForecast::sample_from(std::uint32_t layer) const {
    const std::uint32_t end = std::min(layer + layers_at_once(*job_, layer), job_->pass_end(layer));
    return {job_->pass_of(layer), {layer, end}};
}

bool TimeForecast::next() {
    const auto layer = static_cast<std::uint32_t>(cut_s_.size());
    if (layer < job_->layer_count()) {
        way_s_.push_back(way_seconds(layer));
        cut_s_.push_back(cut_seconds(layer));
        return true;
    }
    if (next_sample_ < samples_.size()) {
        Sample& sample = samples_[next_sample_++];
        sample.ratio = planned_ratio(sample.layers);
        return true;
    }
    return add_sample();
}

// Amid the two between which most is in doubt: somewhere there layers may change at once.
bool TimeForecast::add_sample() {
    if (samples_to_add_ == 0) return false;
    --samples_to_add_;
    double greatest_s = 0.0;
    std::size_t place = 0;
    for (std::size_t i = 1; i < samples_.size(); ++i) {
        const double doubt_s = doubt_seconds(samples_[i - 1], samples_[i]);
        if (doubt_s <= greatest_s) continue;
        greatest_s = doubt_s;
        place = i;
    }
    if (place == 0) return false;
    const std::uint32_t begin = samples_[place - 1].layers.end;
    const std::uint32_t at_once = layers_at_once(*job_, begin);
    const std::uint32_t parts = (samples_[place].layers.first - begin) / at_once;
    Sample sample = sample_from(begin + parts / 2 * at_once);
    sample.ratio = planned_ratio(sample.layers);
    samples_.insert(samples_.begin() + static_cast<std::ptrdiff_t>(place), sample);
    ++next_sample_;
    return true;
}

double TimeForecast::doubt_seconds(const Sample& before, const Sample& after) const {
    if (before.pass != after.pass) return 0.0;
    return std::abs(after.ratio - before.ratio) * least_seconds_of({before.layers.end, after.layers.first});
}

double TimeForecast::least_seconds_of(const LayerSpan& layers) const {
    return std::accumulate(cut_s_.begin() + layers.first, cut_s_.begin() + layers.end, 0.0);
}

double TimeForecast::way_seconds(std::uint32_t layer) const {
    if (layer == 0 || job_->is_joint(layer, 0)) return 0.0;
    const Pulses4 from = pulses_at(*job_, layer - 1, job_->point_count() - 1);
    BlockList list(limits_);
    if (job_->begins_pass(layer)) {
        add_way_between_passes(list, limits_, *job_, from, layer);
    } else {
        add_link(list, limits_, from, pulses_at(*job_, layer, 0), layer, 0);
    }
    return TickTimes(limits_).seconds_of(list.blocks());
}

double TimeForecast::cut_seconds(std::uint32_t layer) const {
    double seconds = 0.0;
    Pulses4 from = pulses_at(*job_, layer, 0);
    for (std::uint32_t step = 1; step < job_->point_count(); ++step) {
        const Pulses4 to = pulses_at(*job_, layer, step);
        seconds += least_seconds(limits_, from, to);
        from = to;
    }
    return seconds;
}

double TimeForecast::planned_ratio(const LayerSpan& layers) const {
    const auto program = carving_of(limits_, job_, layers);
    cycle::MotionBlock block{};
    while (program->next(block)) {
    }
    const double least_s = least_seconds_of(layers);
    return least_s > 0.0 ? program->planned().seconds / least_s : 1.0;
}

std::vector<double> TimeForecast::layer_ends_seconds() const {
    std::vector<double> ends;
    double seconds = 0.0;
    for (std::uint32_t layer = 0; layer < job_->layer_count(); ++layer) {
        seconds += way_s_[layer] + cut_s_[layer] * ratio_of(layer);
        ends.push_back(seconds);
    }
    return ends;
}

// A sample's is that of all its layers; between two of its pass in proportion.
double TimeForecast::ratio_of(std::uint32_t layer) const {
    const std::uint32_t pass = job_->pass_of(layer);
    const auto first_of = [](const Sample& sample) { return sample.layers.first; };
    const auto after = std::ranges::upper_bound(samples_, layer, {}, first_of);
    const bool has_after = after != samples_.end() && after->pass == pass;
    const bool has_before = after != samples_.begin() && std::prev(after)->pass == pass;
    if (!has_before) return after->ratio;
    const Sample& before = *std::prev(after);
    if (!has_after || layer < before.layers.end) return before.ratio;
    const std::uint32_t last = before.layers.end - 1;
    const double share = static_cast<double>(layer - last) / static_cast<double>(after->layers.first - last);
    return before.ratio + share * (after->ratio - before.ratio);
}

}  // namespace psicarve::plan
