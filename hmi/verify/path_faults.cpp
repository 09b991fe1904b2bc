// SPDX-License-Identifier: GPL-3.0-or-later
// Part of rule 1: words for its findings, apart from the part that follows the pins.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "hmi/verify/path_rule.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {

void PathRule::report(std::int64_t time_ns, Offence offence) {
    offence.rule = 1;
    offence.time_ns = time_ns;
    log_.describe(std::move(offence), place_);
}

void PathRule::miss(std::int64_t time_ns, const Positions& at) {
    Axis worst = Axis::psi;
    std::int64_t worst_off = 0;
    std::int64_t measured = at[kPsi];
    const auto consider = [&](Axis axis, std::int64_t value) {
        const std::int64_t off = std::abs(value - to_[index_of(axis)]);
        if (off <= worst_off) return;
        worst = axis;
        worst_off = off;
        measured = value;
    };
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const Heading& heading = headings_[h];
        const std::int64_t wanted = to_[index_of(kHeads[h])];
        const std::int64_t closest = heading.closest.value_or(at[index_of(kHeads[h])]);
        consider(kHeads[h], closest);
        if (heading.has_surface)
            note_deviation(heading.surface_layer, geometry_.cell_of(geometry_.direction(h, to_[kPsi])),
                           closest - wanted);
    }
    consider(Axis::y, at[kY]);
    if (const auto alone = near_.only_axis_off()) {
        // All other axes met there: so this one has lost its way.
        worst = *alone;
        worst_off = near_.most_off;
        measured = near_.at[index_of(worst)];
        excuse_link(*alone);
    }
    keep_link();
    if (!is_miss_told_ && log_.count(1, time_ns)) {
        Offence offence = missed_by(worst, measured);
        if (worst_off == 0)
            offence.sentence = "a point was not visited by all axes at one instant: psi went past it";
        report(time_ns, std::move(offence));
    }
    advance();
}

Offence PathRule::missed_by(Axis axis, std::int64_t measured) const {
    Offence offence;
    offence.fault = "point-missed";
    offence.axis = axis;
    offence.measured = static_cast<double>(measured);
    offence.allowed = static_cast<double>(to_[index_of(axis)]);
    offence.bound = Bound::exactly;
    offence.unit = "pulses";
    offence.sentence = "a point was not visited: " + shown_name(axis) + " stood elsewhere";
    return offence;
}

/// The last point was met by all axes but one.
std::optional<Axis> PathRule::axis_short_of_layers_end() const noexcept {
    return step_ + 1 == geometry_.point_count() ? near_.only_axis_off() : std::nullopt;
}

/// Carving goes on beyond a layer that has not been carved.
void PathRule::leave_out(std::int64_t time_ns, std::uint32_t due) {
    if (!log_.count(1, time_ns)) return;
    Offence offence;
    offence.fault = "layers-left-out";
    offence.measured = static_cast<double>(layer_);
    offence.allowed = static_cast<double>(due);
    offence.bound = Bound::at_most;
    offence.unit = "layer";
    offence.sentence = "carving begins with layer " + std::to_string(layer_) + ", but layer " +
                       std::to_string(due) + " is the first that has not been carved";
    report(time_ns, std::move(offence));
}

/// Or beyond points of a layer.
void PathRule::leave_out_points(std::int64_t time_ns, Begin begin, std::uint32_t due) {
    if (!log_.count(1, time_ns)) return;
    Offence offence;
    offence.fault = "points-left-out";
    offence.measured = static_cast<double>(begin.step);
    offence.allowed = static_cast<double>(due);
    offence.bound = Bound::at_most;
    offence.unit = "points";
    offence.sentence = "carving begins behind " + std::to_string(begin.step) + " points of layer " +
                       std::to_string(begin.layer) + ", of which " + std::to_string(due) +
                       " have been carved";
    report(time_ns, std::move(offence));
}

void PathRule::miss_rest_of_layer(std::int64_t time_ns, const Positions& at) {
    const std::uint32_t layer = layer_;
    while (phase_ == Phase::segment && layer_ == layer) miss(time_ns, at);
}

void PathRule::stray(std::int64_t time_ns, std::size_t h, const PathLine::Distance& distance) {
    if (std::exchange(strayed_, true)) return;
    Offence offence;
    if (const auto alone = axis_short_of_layers_end(); alone && *alone != kHeads[h]) {
        // This head is not at fault: another axis missed the layer's last point.
        offence = missed_by(*alone, near_.at[index_of(*alone)]);
        is_miss_told_ = true;
    } else {
        offence.fault = "off-the-line";
        offence.axis = kHeads[h];
        offence.measured = distance.judged_mm;
        offence.allowed = distance.allowed_mm;
        offence.unit = "mm";
        offence.sentence = shown_name(kHeads[h]) + " leaves the straight line to a point";
    }
    offence.time_ns = time_ns;
    retraction_.stray = Stray{std::move(offence), place_, 0};
    if (!is_outward_) keep_retraction();
}

/// The motion was no retraction: the findings on the way count.
void PathRule::keep_retraction() {
    max_line_mm_ = std::max(max_line_mm_, retraction_.max_line_mm);
    max_line_pulses_ = std::max(max_line_pulses_, retraction_.max_line_pulses);
    const auto stray = std::exchange(retraction_, {}).stray;
    if (stray) count(*stray);
}

void PathRule::stray_in_height(std::int64_t time_ns, const Positions& at) {
    const bool is_spiral = geometry_.is_spiral() && layer_ >= geometry_.first_row_layer();
    // Y moves on: the point will not be reached.
    if (!is_spiral && step_ + 1 == geometry_.point_count()) return miss(time_ns, at);
    if (!std::exchange(strayed_, true) && log_.count(1, time_ns)) {
        Offence offence;
        offence.fault = "height";
        offence.axis = Axis::y;
        offence.measured = static_cast<double>(at[kY]);
        offence.allowed = height_line(at[kPsi]).at;
        offence.bound = Bound::exactly;
        offence.unit = "pulses";
        offence.sentence =
            is_spiral ? "Y leaves the straight line to a point" : "Y leaves its layer before the layer's end";
        report(time_ns, std::move(offence));
    }
    if (is_spiral) return;
    const auto layer = layer_at(at);
    if (!layer || *layer != layer_) miss_rest_of_layer(time_ns, at);
}

void PathRule::wrong_layer(std::int64_t time_ns, const Positions& at, std::uint32_t layer) {
    if (!std::exchange(strayed_, true) && log_.count(1, time_ns)) {
        Offence offence;
        offence.fault = "layer-order";
        offence.axis = Axis::y;
        offence.measured = static_cast<double>(at[kY]);
        offence.allowed = static_cast<double>(to_[kY]);
        offence.bound = Bound::exactly;
        offence.unit = "pulses";
        offence.sentence =
            "Y goes to layer " + std::to_string(layer) + " where layer " + std::to_string(layer_) + " is due";
        report(time_ns, std::move(offence));
    }
    if (layer > layer_) {
        aim(layer, 0);
        strayed_ = true;  // the jump is reported
    }
}

void PathRule::touch(std::int64_t time_ns, const Positions& at) {
    for (std::size_t h = 0; h < kHeadCount; ++h) touch_head(h, time_ns, at);
}

/// A tip somewhere off the lines between points: carves, and must not stand deeper than the job's surface
/// there.
void PathRule::touch_head(std::size_t h, std::int64_t time_ns, const Positions& at) {
    const HeadGeometry& head = geometry_.head(h);
    const std::int64_t radius = at[index_of(kHeads[h])];
    const double real_mm = head.real_mm(radius);
    if (real_mm >= geometry_.blank_radius_mm() || is_where_it_ended(h, at)) {
        headings_[h].is_too_deep = false;
        return;
    }
    const std::int64_t direction = geometry_.direction(h, at[kPsi]);
    const auto layer = geometry_.row_at(at[kY] + head.height_offset_pulses, direction);  // of the surface
    const std::uint32_t cell = geometry_.cell_of(direction);
    if (layer) mark(*layer, cell, real_mm);
    const auto wanted_mm = geometry_.floor_mm(h, at[kY], direction);
    if (!wanted_mm) return;
    double floor_mm = *wanted_mm;
    if (direction != geometry_.direction_of(cell)) {
        // Between two points the path may leave the line; psi is known to a pulse.
        const std::int64_t rev = geometry_.rev_pulses();
        const auto before = geometry_.floor_mm(h, at[kY], (direction + rev - 1) % rev);
        const auto after = geometry_.floor_mm(h, at[kY], (direction + 1) % rev);
        floor_mm = std::min({floor_mm, before.value_or(floor_mm), after.value_or(floor_mm)}) -
                   geometry_.tolerance_mm() - 1.0 / head.pulses_per_mm;
    }
    floor_mm = std::min(floor_mm, floor_of_way(h, at, direction).value_or(floor_mm));
    const std::int64_t off = round_to_pulse((real_mm - *wanted_mm) * head.pulses_per_mm);
    const std::int64_t too_deep = round_to_pulse((floor_mm - real_mm) * head.pulses_per_mm);
    if (layer && (off >= 0 || too_deep > 0)) note_deviation(*layer, cell, off);
    const bool told = std::exchange(headings_[h].is_too_deep, too_deep > 0);
    for (Stray& deep : too_deep_in_link_) {
        if (told && deep.offence.axis == kHeads[h]) deep.most_off = std::max(deep.most_off, too_deep);
    }
    if (too_deep <= 0 || told) return;
    Offence offence;
    offence.time_ns = time_ns;
    offence.fault = "too-deep";
    offence.axis = kHeads[h];
    offence.measured = static_cast<double>(radius);
    offence.allowed = static_cast<double>(radius + too_deep);
    offence.bound = Bound::at_least;
    offence.unit = "pulses";
    const auto row = geometry_.row_at(at[kY], direction);
    offence.sentence =
        shown_name(kHeads[h]) + " stands deeper than " +
        (row ? "layer " + std::to_string(geometry_.first_row_layer() + *row) : std::string("the job")) +
        " asks, off the way between two points";
    too_deep_in_link_.push_back({std::move(offence), place_, too_deep});
    if (phase_ != Phase::link || too_deep_in_link_.size() == kMostHeld) keep_link();
}

/// On the way to and between the roughing layers of a spiral, which are level and sliced for themselves. The
/// job's radii for this head at the way's ends are known as well.
std::optional<double> PathRule::floor_of_way(std::size_t h, const Positions& at,
                                             std::int64_t direction) const {
    const bool is_on_way = phase_ == Phase::link || phase_ == Phase::approach;
    if (!geometry_.is_spiral() || !is_on_way || geometry_.first_row_layer() == 0) return std::nullopt;
    const HeadGeometry& head = geometry_.head(h);
    std::vector<JobGeometry::KnownTip> ends;
    const auto add = [&](const Positions& end) {
        if (geometry_.direction(h, end[kPsi]) != direction) return;
        ends.push_back({end[kY] + head.height_offset_pulses, head.real_mm(end[index_of(kHeads[h])])});
    };
    if (phase_ == Phase::link) {
        add(from_);
        add(to_);
    } else {
        add(geometry_.target(geometry_.first_layer(), geometry_.first_step(geometry_.first_layer())));
    }
    return geometry_.least_around(at[kY] + head.height_offset_pulses, direction, ends);
}

/// A head may be a little too deep because the axis that lost its way is, or because its own count is off.
void PathRule::excuse_link(Axis lost) {
    std::erase_if(too_deep_in_link_, [lost](const Stray& deep) {
        const bool is_its_own = lost == Axis::psi || lost == Axis::y || deep.offence.axis == lost;
        return is_its_own && deep.most_off <= kNearPulses;
    });
}

void PathRule::keep_link() {
    for (const Stray& deep : std::exchange(too_deep_in_link_, {})) count(deep);
}

void PathRule::count(const Stray& stray) {
    if (!log_.count(1, stray.offence.time_ns)) return;
    Offence offence = stray.offence;
    offence.rule = 1;
    log_.describe(std::move(offence), stray.place);
}

/// The path led there, at this depth: that was judged on the way.
bool PathRule::is_where_it_ended(std::size_t h, const Positions& at) const noexcept {
    if (phase_ != Phase::approach || !on_path_) return false;
    const Positions& end = *on_path_;
    const std::size_t head = index_of(kHeads[h]);
    return at[kPsi] == end[kPsi] && at[kY] == end[kY] && at[head] >= end[head];
}

void PathRule::end_early(std::int64_t time_ns) {
    const bool has_begun = ended_at_.has_value();
    if (has_begun) time_ns = ended_ns_;
    if (!log_.count(1, time_ns)) return;
    Offence offence;
    offence.fault = has_begun ? "ends-early" : "no-carving";
    offence.measured = static_cast<double>(visited_);
    offence.allowed = static_cast<double>(geometry_.total_points());
    offence.bound = Bound::exactly;
    offence.unit = "points";
    offence.sentence = has_begun ? "the carving ends before the job's last point"
                                 : "nothing was carved: the first point is never reached with the spindle on";
    if (const auto alone = ended_near_.only_axis_off(); has_begun && alone) {
        offence.axis = alone;
        offence.sentence += ", from which " + shown_name(*alone) + " alone stood " +
                            std::to_string(ended_near_.most_off) +
                            (ended_near_.most_off == 1 ? " pulse off" : " pulses off");
    }
    place_ = ended_at_.value_or(CarvePlace{});
    report(time_ns, std::move(offence));
}

}  // namespace psicarve::verify
