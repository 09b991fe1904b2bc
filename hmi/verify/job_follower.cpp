// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/job_follower.hpp"

#include <cmath>
#include <utility>

#include "hmi/verify/path_offences.hpp"

namespace psicarve::verify {

JobFollower::JobFollower(const JobGeometry& geometry, CarvedSurface& surface, OffenceLog& log)
    : geometry_(geometry),
      log_(log),
      painter_(geometry, surface),
      progress_(geometry),
      findings_(log),
      way_(geometry) {}

void JobFollower::wait_for(CarvePoint begin) {
    aim(begin);
    phase_ = Phase::approach;
    place_ = {};
}

void JobFollower::begin(CarvePoint begin) {
    times_.begin_anew();
    findings_.begin_anew();
    on_path_.reset();
    aim(begin);
    if (begin.step > 1) aim_surface();
}

void JobFollower::end(std::int64_t psi_offset_pulses) {
    findings_.count_depths();
    findings_.forget_retraction();
    if (on_path_) (*on_path_)[kPsi] += psi_offset_pulses;
    phase_ = Phase::approach;
    place_ = {};
}

JobFollower::Kept JobFollower::kept() const {
    return {progress_.kept(), times_, findings_.line_extent(), on_path_};
}

void JobFollower::restore(const Kept& earlier) {
    progress_.restore(earlier.progress);
    times_ = earlier.times;
    findings_.begin_anew();
    findings_.set_line_extent(earlier.line);
    on_path_ = earlier.on_path;
}

std::uint32_t JobFollower::carved_point_of(CarvePoint point) const noexcept {
    return carved_point(geometry_.job().joining(), geometry_.point_count(), point.layer, point.step);
}

/// Makes a point the next one to be visited.
void JobFollower::aim(CarvePoint point) {
    way_.aim(point);
    strayed_ = false;
    is_miss_told_ = false;
    const auto passes = geometry_.job().passes();
    place_ = {point.layer,
              carved_point_of(point),
              passes.size() > 1 ? &passes[geometry_.job().pass_of(point.layer)] : nullptr,
              {}};
    if (point.step <= 1 || geometry_.is_spiral()) aim_surface();
    phase_ = point.step > 0 ? Phase::segment : Phase::link;
}

void JobFollower::aim_surface() {
    painter_.aim(way_.from()[kPsi], way_.point().layer, carved_point_of(way_.point()));
}

void JobFollower::advance() {
    const CarvePoint point = way_.point();
    const JobView& job = geometry_.job();
    if (way_.is_layers_last() && point.layer + 1 == job.pass_end(point.layer)) times_.end_pass();
    if (!way_.is_layers_last()) {
        aim({point.layer, point.step + 1});
    } else if (point.layer + 1 < geometry_.end_layer()) {
        aim({point.layer + 1, job.is_joint(point.layer + 1, 0) ? 1U : 0U});
    } else {
        phase_ = Phase::done;
        place_ = {};
    }
}

void JobFollower::reach(std::int64_t time_ns) {
    findings_.count_depths();
    const std::uint32_t layer = way_.point().layer;
    progress_.count(layer);
    // The next row of a spiral begins here.
    if (way_.is_layers_last() && layer + 1 < geometry_.end_layer() && geometry_.job().is_joint(layer + 1, 0))
        progress_.count(layer + 1);
    times_.arrive(time_ns);
    painter_.reach(way_.to());
    advance();
}

void JobFollower::miss(std::int64_t time_ns, const Positions& at) {
    const Positions& wanted = way_.to();
    for (std::size_t h = 0; h < kHeadCount; ++h)
        painter_.miss(h, wanted[kPsi], way_.closest(h, at) - wanted[index_of(kHeads[h])]);
    if (const auto alone = way_.nearest().only_axis_off()) findings_.excuse_depths(*alone);
    findings_.count_depths();
    if (!is_miss_told_ && log_.count(1, time_ns)) {
        const PointWay::Miss miss = way_.miss(at);
        const auto tell = miss.off == 0 ? point_not_met_at_once : point_missed;
        report(time_ns, tell(miss.axis, miss.measured, wanted[index_of(miss.axis)]));
    }
    advance();
}

std::array<bool, kHeadCount> JobFollower::on_lines(std::int64_t time_ns, const Positions& at) {
    std::array<bool, kHeadCount> is_on{};
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const auto distance = way_.distance(h, at);
        findings_.note_distance(distance, way_.line(h).pulse_across_mm());
        is_on[h] = distance.is_allowed;
        if (!is_on[h]) stray(time_ns, h, distance);
    }
    return is_on;
}

/// The layer's last point was met by all axes but one.
std::optional<Axis> JobFollower::axis_short_of_layers_end() const noexcept {
    return way_.is_layers_last() ? way_.nearest().only_axis_off() : std::nullopt;
}

void JobFollower::stray(std::int64_t time_ns, std::size_t h, const PathLine::Distance& distance) {
    if (std::exchange(strayed_, true)) return;
    Offence offence;
    if (const auto alone = axis_short_of_layers_end(); alone && *alone != kHeads[h]) {
        // This head is not at fault: another axis missed the layer's last point.
        const std::size_t k = index_of(*alone);
        offence = point_missed(*alone, way_.nearest().at[k], way_.to()[k]);
        is_miss_told_ = true;
    } else {
        offence = off_the_line(kHeads[h], distance);
    }
    offence.time_ns = time_ns;
    findings_.stray(std::move(offence), place_);
}

bool JobFollower::is_off_height(const Positions& at) const noexcept {
    const PointWay::HeightLine line = way_.height_line(at[kPsi]);
    return std::abs(static_cast<double>(at[kY]) - line.at) > line.allowed;
}

void JobFollower::stray_in_height(std::int64_t time_ns, const Positions& at) {
    const std::uint32_t carved = way_.point().layer;
    const bool is_spiral = geometry_.is_spiral() && carved >= geometry_.first_row_layer();
    // Y moves on: the point will not be reached.
    if (!is_spiral && way_.is_layers_last()) return miss(time_ns, at);
    if (!std::exchange(strayed_, true) && log_.count(1, time_ns))
        report(time_ns, off_the_height(is_spiral, at[kY], way_.height_line(at[kPsi]).at));
    if (is_spiral) return;
    const auto layer = layer_at(at);
    if (layer == carved) return;
    while (phase_ == Phase::segment && way_.point().layer == carved) miss(time_ns, at);
}

void JobFollower::go_to_wrong_layer(std::int64_t time_ns, const Positions& at, std::uint32_t layer) {
    const std::uint32_t due = way_.point().layer;
    if (!std::exchange(strayed_, true) && log_.count(1, time_ns))
        report(time_ns, wrong_layer(layer, due, at[kY], way_.to()[kY]));
    if (layer > due) {
        aim({layer, 0});
        strayed_ = true;  // the jump is reported
    }
}

std::optional<std::uint32_t> JobFollower::layer_at(const Positions& at) const noexcept {
    if (way_.point().layer < geometry_.first_row_layer()) return std::nullopt;
    const auto row = geometry_.row_at(at[kY], geometry_.direction(0, at[kPsi]));
    if (!row) return std::nullopt;
    return geometry_.first_row_layer() + *row;
}

void JobFollower::follow(std::int64_t time_ns, const Positions& at, bool psi_turned) {
    switch (phase_) {
        case Phase::segment:
            return follow_segment(time_ns, at, psi_turned);
        case Phase::link:
            return follow_link(time_ns, at, psi_turned);
        case Phase::approach:
        case Phase::done:
            return touch(time_ns, at);
    }
}

void JobFollower::follow_segment(std::int64_t time_ns, const Positions& at, bool psi_turned) {
    if (way_.has_only_passed_link(at)) {
        progress_.take_back(way_.point().layer);
        way_.go_back_to_link();
        aim({way_.point().layer, 0});
        return follow_link(time_ns, at, psi_turned);
    }
    times_.leave(time_ns);
    while (phase_ == Phase::segment && way_.beyond(at[kPsi]) > 0) miss(time_ns, at);
    if (phase_ == Phase::segment && is_off_height(at)) {
        stray_in_height(time_ns, at);
        if (phase_ == Phase::segment) return touch(time_ns, at);
    }
    if (phase_ != Phase::segment) return follow(time_ns, at, psi_turned);
    const auto is_on = on_lines(time_ns, at);
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        // A steep line passes below a point's radius where psi stands at the point's angle already.
        if (is_on[h]) {
            painter_.carve(h, at);
        } else {
            touch_head(h, time_ns, at);
        }
    }
    if (is_on[0] && is_on[1]) on_path_ = at;
    if (at == way_.to()) return reach(time_ns);
    way_.note(at);
    if (at[kPsi] == way_.to()[kPsi]) way_.note_radii(at);
}

void JobFollower::follow_link(std::int64_t time_ns, const Positions& at, bool psi_turned) {
    touch(time_ns, at);
    const std::uint32_t due = way_.point().layer;
    // Between two passes the heads are clear of all layers.
    const bool is_between_passes = geometry_.job().begins_pass(due);
    if (at == way_.to()) {
        const Positions from = way_.from();
        reach(time_ns);
        if (is_between_passes) way_.note_link(from);
        return;
    }
    way_.note(at);
    if (const auto layer = layer_at(at); layer && !is_between_passes && *layer != due && *layer + 1 != due)
        go_to_wrong_layer(time_ns, at, *layer);
    if (at[kY] != way_.to()[kY] && way_.nearest().only_axis_off() != Axis::y) return;
    if (at[kPsi] == way_.to()[kPsi]) way_.note_radii(at);
    // Psi that turns at this height: the layer goes on without its first point.
    if (!psi_turned) return;
    const Positions second = geometry_.target(way_.point().layer, 1);
    const std::int64_t way = second[kPsi] - way_.to()[kPsi];
    if ((at[kPsi] - second[kPsi]) * (way > 0 ? 1 : -1) < 0) return;
    miss(time_ns, at);
    if (phase_ == Phase::segment) follow_segment(time_ns, at, psi_turned);
}

void JobFollower::touch(std::int64_t time_ns, const Positions& at) {
    for (std::size_t h = 0; h < kHeadCount; ++h) touch_head(h, time_ns, at);
}

void JobFollower::touch_head(std::size_t h, std::int64_t time_ns, const Positions& at) {
    std::array<Positions, 2> ends;
    std::size_t end_count = 0;
    if (geometry_.is_spiral() && geometry_.first_row_layer() > 0) {
        if (phase_ == Phase::link) {
            ends = {way_.from(), way_.to()};
            end_count = 2;
        } else if (phase_ == Phase::approach) {
            ends[0] =
                geometry_.target(geometry_.first_layer(), geometry_.first_step(geometry_.first_layer()));
            end_count = 1;
        }
    }
    const auto tip = is_where_it_ended(h, at) ? std::nullopt
                                              : tip_depth(geometry_, h, at, std::span(ends).first(end_count));
    if (!tip) {
        findings_.goes_too_deep(h, 0);
        return;
    }
    if (tip->row) painter_.mark(*tip->row, tip->cell, tip->real_mm);
    if (!tip->off_pulses) return;
    const std::int64_t too_deep_pulses = tip->too_deep_pulses;
    if (tip->row && (*tip->off_pulses >= 0 || too_deep_pulses > 0))
        painter_.note_passed(*tip->row, tip->cell, *tip->off_pulses);
    if (!findings_.goes_too_deep(h, too_deep_pulses)) return;
    const auto row = geometry_.row_at(at[kY], geometry_.direction(h, at[kPsi]));
    const auto layer = row ? std::optional(geometry_.first_row_layer() + *row) : std::nullopt;
    Offence offence = too_deep(kHeads[h], at[index_of(kHeads[h])], too_deep_pulses, layer);
    offence.time_ns = time_ns;
    findings_.add_depth(std::move(offence), place_, too_deep_pulses, phase_ == Phase::link);
}

/// The path led there, at this depth: that was judged on the way.
bool JobFollower::is_where_it_ended(std::size_t h, const Positions& at) const noexcept {
    if (phase_ != Phase::approach || !on_path_) return false;
    const Positions& end = *on_path_;
    const std::size_t head = index_of(kHeads[h]);
    return at[kPsi] == end[kPsi] && at[kY] == end[kY] && at[head] >= end[head];
}

void JobFollower::report(std::int64_t time_ns, Offence offence) {
    offence.time_ns = time_ns;
    log_.describe(std::move(offence), place_);
}

}  // namespace psicarve::verify
