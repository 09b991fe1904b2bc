// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path_rule.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {

constexpr double kHeightSlackPulses = 1.0;

}  // namespace

PathRule::PathRule(const JobGeometry& geometry, CarvedSurface& surface, OffenceLog& log)
    : geometry_(geometry), surface_(&surface), log_(log), visited_of_(geometry.layer_count(), 0) {
    log_.set_judged(1);
    visited_of_[geometry.first_layer()] = geometry.first_step(geometry.first_layer());
}

void PathRule::begin(const Positions& positions, bool spindle_on) {
    last_ = positions;
    spindle_on_ = spindle_on;
    before_attempt_ = log_.result(1);
    aim(geometry_.first_layer(), geometry_.first_step(geometry_.first_layer()));
    phase_ = Phase::approach;
    place_ = {};
}

double PathRule::carve_seconds() const noexcept {
    return is_complete_ && has_left_ ? seconds_from_ns(arrived_ns_ - left_ns_) : 0.0;
}

std::vector<PassTime> PathRule::pass_times() const {
    const auto passes = geometry_.job().passes();
    std::vector<PassTime> times;
    if (!is_complete_ || passes.size() < 2 || pass_ended_ns_.size() != passes.size()) return times;
    std::int64_t before_ns = left_ns_;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        // Several runs carved to one depth are one pass.
        const bool goes_on = i > 0 && passes[i].number == passes[i - 1].number;
        if (!goes_on) times.push_back({pass_name(passes[i]), 0, 0.0});
        times.back().layers += passes[i].layer_count;
        times.back().seconds += seconds_from_ns(pass_ended_ns_[i] - before_ns);
        before_ns = pass_ended_ns_[i];
    }
    return times;
}

std::int64_t PathRule::forward(std::int64_t psi_pulses) const noexcept {
    return (psi_pulses - to_[kPsi]) * psi_sign_;
}

void PathRule::settle(std::int64_t time_ns, const Positions& positions, bool spindle_on) {
    // Switched off together with the last pulse, the spindle still ran for it.
    const bool ran = spindle_on || spindle_on_;
    if (is_guess_ && visited_ == 0 && ran && is_first_point(positions)) {
        log_.restore(1, before_guess_);
        phase_ = Phase::approach;
    }
    if (phase_ == Phase::done && ran && is_first_point(positions)) end_attempt(time_ns);
    const bool begins = ran && may_begin(positions) && begin_layer(time_ns, positions);
    const bool was_outward = std::exchange(is_outward_, is_outward_from_last(positions));
    if (was_outward && !is_outward_) keep_retraction();
    if (!begins) follow(time_ns, positions, ran);
    last_ = positions;
    if (spindle_on_ && !spindle_on) {
        is_elsewhere_ = false;
        if (phase_ != Phase::approach) end_attempt(time_ns);
    }
    spindle_on_ = spindle_on;
}

void PathRule::follow(std::int64_t time_ns, const Positions& positions, bool spindle_on) {
    Positions at = positions;
    at[kPsi] -= psi_offset_;
    switch (phase_) {
        case Phase::segment:
            return follow_segment(time_ns, at);
        case Phase::link:
            return follow_link(time_ns, at);
        case Phase::approach:
            return follow_approach(time_ns, positions, spindle_on);
        case Phase::done:
            return touch(time_ns, at);
    }
}

bool PathRule::is_outward_from_last(const Positions& positions) const noexcept {
    return positions[kPsi] == last_[kPsi] && positions[kY] == last_[kY] && positions[0] >= last_[0] &&
           positions[1] >= last_[1];
}

/// Makes a point the next one to be visited.
void PathRule::aim(std::uint32_t layer, std::uint32_t step) {
    layer_ = layer;
    step_ = step;
    strayed_ = false;
    is_miss_told_ = false;
    near_ = {};
    if (step != 1) link_from_.reset();
    from_ = to_;
    to_ = geometry_.target(layer, step);
    const std::uint32_t point = carved_point(geometry_.job().joining(), geometry_.point_count(), layer, step);
    const auto passes = geometry_.job().passes();
    place_ = {layer, point, passes.size() > 1 ? &passes[geometry_.job().pass_of(layer)] : nullptr, {}};
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        Heading& heading = headings_[h];
        heading.closest.reset();
        if (step > 0) heading.line = PathLine::between(geometry_, h, from_, to_);
    }
    if (step <= 1 || geometry_.is_spiral()) aim_surface(layer, point);
    if (step > 0) {
        psi_sign_ = to_[kPsi] >= from_[kPsi] ? 1 : -1;
        phase_ = Phase::segment;
        cells_at_psi_ = from_[kPsi] - psi_sign_;  // no cell known yet
    } else {
        phase_ = Phase::link;
    }
}

void PathRule::aim_surface(std::uint32_t layer, std::uint32_t point) {
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        Heading& heading = headings_[h];
        heading.from_layer = heading.surface_layer;
        heading.from_cell = geometry_.cell_of(geometry_.direction(h, from_[kPsi]));
        const auto row = geometry_.row_of_point(h, layer, point);
        heading.has_surface = row.has_value();
        heading.surface_layer = row.value_or(0);
    }
}

void PathRule::advance() {
    if (step_ + 1 == geometry_.point_count() && layer_ + 1 == geometry_.job().pass_end(layer_))
        pass_ended_ns_.push_back(arrived_ns_);
    if (step_ + 1 < geometry_.point_count()) {
        aim(layer_, step_ + 1);
    } else if (layer_ + 1 < geometry_.end_layer()) {
        aim(layer_ + 1, geometry_.job().is_joint(layer_ + 1, 0) ? 1 : 0);
    } else {
        phase_ = Phase::done;
        place_ = {};
        // The layers that follow are not judged.
        is_elsewhere_ = geometry_.end_layer() < geometry_.layer_count();
        if (is_elsewhere_) end_attempt(arrived_ns_);
    }
}

void PathRule::count_point(std::uint32_t layer) {
    ++visited_of_[layer];
    ++visited_;
}

void PathRule::reach(std::int64_t time_ns) {
    keep_link();
    count_point(layer_);
    // The next row of a spiral begins here.
    if (step_ + 1 == geometry_.point_count() && layer_ + 1 < geometry_.end_layer() &&
        geometry_.job().is_joint(layer_ + 1, 0))
        count_point(layer_ + 1);
    arrived_ns_ = time_ns;
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const Heading& heading = headings_[h];
        if (!heading.has_surface) continue;
        const std::uint32_t cell = geometry_.cell_of(geometry_.direction(h, to_[kPsi]));
        const double mm = geometry_.head(h).real_mm(to_[index_of(kHeads[h])]);
        mark(heading.surface_layer, cell, mm);
        note_deviation(heading.surface_layer, cell, 0);
    }
    advance();
}

void PathRule::Nearest::note(const Positions& now, const Positions& wanted) noexcept {
    std::int64_t most = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) most = std::max(most, std::abs(now[k] - wanted[k]));
    if (most > most_off) return;
    unsigned off = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) off |= now[k] != wanted[k] ? 1U << k : 0U;
    if (most == most_off && std::popcount(off) >= std::popcount(axes_off)) return;
    *this = {now, most, off};
}

std::optional<Axis> PathRule::Nearest::only_axis_off() const noexcept {
    if (std::popcount(axes_off) != 1 || most_off > kNearPulses) return {};
    return static_cast<Axis>(std::countr_zero(axes_off));
}

void PathRule::note_closest(const Positions& at) {
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const std::size_t axis = index_of(kHeads[h]);
        auto& closest = headings_[h].closest;
        if (!closest || std::abs(at[axis] - to_[axis]) < std::abs(*closest - to_[axis])) closest = at[axis];
    }
}

/// Which heads are near enough to their straight lines; keeps the largest distances.
PathRule::OnLines PathRule::on_lines(std::int64_t time_ns, const Positions& at) {
    OnLines is_on{};
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const std::size_t axis = index_of(kHeads[h]);
        const PathLine& line = headings_[h].line;
        const auto distance = line.distance(at[kPsi] - from_[kPsi], at[axis] - from_[axis]);
        double& max_mm = is_outward_ ? retraction_.max_line_mm : max_line_mm_;
        double& max_pulses = is_outward_ ? retraction_.max_line_pulses : max_line_pulses_;
        if (distance.mm > max_mm) max_mm = distance.mm;
        if (distance.across_mm > max_pulses * line.pulse_across_mm())
            max_pulses = distance.across_mm / line.pulse_across_mm();
        is_on[h] = distance.is_allowed;
        if (!is_on[h]) stray(time_ns, h, distance);
    }
    return is_on;
}

void PathRule::note_cells(const Positions& at) {
    if (at[kPsi] == cells_at_psi_) return;
    cells_at_psi_ = at[kPsi];
    for (std::size_t h = 0; h < kHeadCount; ++h)
        headings_[h].cell = geometry_.cell_of(geometry_.direction(h, at[kPsi]));
}

/// The tip cuts where it may: there is nothing more to judge.
void PathRule::carve(std::size_t h, const Positions& at) {
    const Heading& heading = headings_[h];
    if (!heading.has_surface) return;
    const double mm = geometry_.head(h).real_mm(at[index_of(kHeads[h])]);
    const bool is_at_from = geometry_.is_spiral() && heading.cell == heading.from_cell;
    mark(is_at_from ? heading.from_layer : heading.surface_layer, heading.cell, mm);
}

PathRule::HeightLine PathRule::height_line(std::int64_t psi_pulses) const noexcept {
    const auto rise = static_cast<double>(to_[kY] - from_[kY]);
    const auto turn = static_cast<double>(to_[kPsi] - from_[kPsi]);
    if (rise == 0.0 || turn == 0.0) return {static_cast<double>(to_[kY]), kHeightSlackPulses};
    const double part = std::clamp(static_cast<double>(psi_pulses - from_[kPsi]) / turn, 0.0, 1.0);
    const double tolerance_pulses = geometry_.tolerance_mm() * geometry_.y_pulses_per_mm();
    // Psi is known to a pulse.
    return {static_cast<double>(from_[kY]) + part * rise,
            tolerance_pulses + kHeightSlackPulses + std::abs(rise / turn)};
}

/// A pass whose first point lies where the heads go out from the pass before: there they were on their way.
bool PathRule::has_only_passed(const Positions& at) const noexcept {
    if (!link_from_ || at[kPsi] != from_[kPsi] || at[kY] != from_[kY]) return false;
    bool is_on_lines = true;
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const std::int64_t outward = at[index_of(kHeads[h])] - from_[index_of(kHeads[h])];
        if (outward < 0) return false;
        is_on_lines = is_on_lines && headings_[h].line.distance(0, outward).is_allowed;
    }
    return !is_on_lines;
}

void PathRule::follow_segment(std::int64_t time_ns, const Positions& at) {
    if (has_only_passed(at)) {
        --visited_of_[layer_];
        --visited_;
        to_ = *link_from_;
        aim(layer_, 0);
        return follow_link(time_ns, at);
    }
    if (!has_left_) {
        has_left_ = true;
        left_ns_ = time_ns;
    }
    while (phase_ == Phase::segment && forward(at[kPsi]) > 0) miss(time_ns, at);
    if (phase_ == Phase::segment) {
        const HeightLine line = height_line(at[kPsi]);
        if (std::abs(static_cast<double>(at[kY]) - line.at) > line.allowed) {
            stray_in_height(time_ns, at);
            if (phase_ == Phase::segment) return touch(time_ns, at);
        }
    }
    if (phase_ == Phase::link) return follow_link(time_ns, at);
    if (phase_ == Phase::done) return touch(time_ns, at);
    note_cells(at);
    const OnLines is_on = on_lines(time_ns, at);
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        // A steep line passes below a point's radius where psi stands at the point's angle already.
        if (is_on[h])
            carve(h, at);
        else
            touch_head(h, time_ns, at);
    }
    if (is_on[0] && is_on[1]) on_path_ = at;
    if (at == to_) return reach(time_ns);
    near_.note(at, to_);
    if (at[kPsi] == to_[kPsi]) note_closest(at);
}

void PathRule::follow_link(std::int64_t time_ns, const Positions& at) {
    touch(time_ns, at);
    // Between two passes the heads are clear of all layers.
    const bool is_between_passes = geometry_.job().begins_pass(layer_);
    if (at == to_) {
        const Positions from = from_;
        reach(time_ns);
        if (is_between_passes) link_from_ = from;
        return;
    }
    near_.note(at, to_);
    if (const auto layer = layer_at(at);
        layer && !is_between_passes && *layer != layer_ && *layer + 1 != layer_)
        wrong_layer(time_ns, at, *layer);
    if (phase_ != Phase::link) return;
    if (at[kY] != to_[kY] && near_.only_axis_off() != Axis::y) return;
    if (at[kPsi] == to_[kPsi]) note_closest(at);
    // Psi that turns at this height: the layer goes on without its first point.
    if (at[kPsi] + psi_offset_ == last_[kPsi]) return;
    const Positions second = geometry_.target(layer_, 1);
    const std::int64_t way = second[kPsi] - to_[kPsi];
    if ((at[kPsi] - second[kPsi]) * (way > 0 ? 1 : -1) < 0) return;
    miss(time_ns, at);
    if (phase_ == Phase::segment) follow_segment(time_ns, at);
}

std::optional<std::uint32_t> PathRule::layer_at(const Positions& at) const noexcept {
    if (layer_ < geometry_.first_row_layer()) return std::nullopt;
    const auto row = geometry_.row_at(at[kY], geometry_.direction(0, at[kPsi]));
    if (!row) return std::nullopt;
    return geometry_.first_row_layer() + *row;
}

bool PathRule::objects_to(const std::function<void(PathRule&)>& tell) const {
    const RuleResult before = log_.result(1);
    PathRule trial = *this;
    trial.surface_ = nullptr;
    tell(trial);
    const bool objected = log_.result(1).offences != before.offences;
    log_.restore(1, before);
    return objected;
}

}  // namespace psicarve::verify
