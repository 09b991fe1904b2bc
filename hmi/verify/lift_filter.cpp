// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/lift_filter.hpp"

#include <algorithm>

#include "shared/base/units.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::verify {
namespace {

// A core rests for 10 ms before heads that were stopped go out, and before they go on.
constexpr std::int64_t kLeastRest_ns = 9 * kNsPerMs;
// More than any head has pulses on its travel, there and back.
constexpr std::size_t kMostHeld = 1'000'000;

bool is_outside_of(const Positions& at, const Positions& base) noexcept {
    return at[2] == base[2] && at[3] == base[3] && at[0] >= base[0] && at[1] >= base[1];
}

}  // namespace

LiftFilter::LiftFilter(PathRule& path, const Profile& profile) noexcept
    : path_(path), lifts_(profile.job.lifts_on_hold) {
    for (const Axis axis : {Axis::r1, Axis::r2}) {
        const AxisMotion motion = axis_motion(profile, axis);
        heads_[index_of(axis)] = {pulses_from_mm(profile.job.retract_mm, motion.pulses_per_unit),
                                  motion.travel_max_pulses, motion.backlash_pulses};
    }
}

void LiftFilter::begin(const Positions& positions, bool spindle_on) {
    last_ = {0, positions, spindle_on};
    held_.clear();
    path_.begin(positions, spindle_on);
}

bool LiftFilter::goes_on_with_lift(const Instant& instant) const noexcept {
    return instant.spindle_on == base_.spindle_on && is_outside_of(instant.positions, base_.positions) &&
           !is_back() && held_.size() < kMostHeld;
}

// On a straight way from rest both heads have done the same share of it, but for gaps of their screws that
// either had to cross first. Heads that turn back and go out again start anew from wherever they are.
bool LiftFilter::went_together() const noexcept {
    Positions furthest = base_.positions;
    for (const Instant& instant : held_) {
        for (std::size_t k = 0; k < kHeadCount; ++k)
            furthest[k] = std::max(furthest[k], instant.positions[k]);
    }
    double least_share = 0.0;
    double most_share = 1.0;
    for (std::size_t k = 0; k < kHeadCount; ++k) {
        const std::int64_t base = base_.positions[k];
        const Head& head = heads_[k];
        const std::int64_t lift = std::min(head.lift, head.travel_max - base);
        const std::int64_t out = furthest[k] - base;
        if (out > std::max<std::int64_t>(lift, 0)) return false;
        if (lift <= 0) continue;
        const std::int64_t slack = head.backlash + 1;
        const auto share = [&](std::int64_t pulses) {
            return static_cast<double>(pulses) / static_cast<double>(lift);
        };
        least_share = std::max(least_share, share(out - slack));
        most_share = std::min(most_share, share(out + slack));
    }
    return least_share <= most_share;
}

// A stop broke it off on its way back: the heads went out from there, and the spindle has stopped.
bool LiftFilter::ends_within_lift(const Instant& instant) {
    return base_.spindle_on && !instant.spindle_on && is_outside_of(instant.positions, base_.positions) &&
           is_objected_to();
}

bool LiftFilter::is_objected_to() {
    return path_.objects_to([this](PathRule& trial) {
        for (const Instant& instant : held_)
            trial.settle(instant.time_ns, instant.positions, instant.spindle_on);
    });
}

void LiftFilter::settle(std::int64_t time_ns, const Positions& positions, bool spindle_on) {
    if (!lifts_) return path_.settle(time_ns, positions, spindle_on);
    waiting_.push_back({time_ns, positions, spindle_on});
    while (!waiting_.empty()) {
        const Instant instant = waiting_.front();
        waiting_.pop_front();
        take(instant);
    }
}

void LiftFilter::take(const Instant& instant) {
    if (!held_.empty()) {
        if (goes_on_with_lift(instant)) {
            held_.push_back(instant);
            last_ = instant;
            return;
        }
        const bool was_lift = is_back() && instant.time_ns - held_.back().time_ns >= kLeastRest_ns &&
                              went_together() && is_objected_to();
        if (!was_lift && !ends_within_lift(instant)) return look_again(instant);
        held_.clear();
    }
    const bool may_be_lift = instant.time_ns - last_.time_ns >= kLeastRest_ns &&
                             instant.spindle_on == last_.spindle_on && instant.positions != last_.positions &&
                             is_outside_of(instant.positions, last_.positions);
    if (may_be_lift) {
        base_ = last_;
        held_.push_back(instant);
    } else {
        path_.settle(instant.time_ns, instant.positions, instant.spindle_on);
    }
    last_ = instant;
}

// The first pulse was the path's, but a lift may have begun behind it.
void LiftFilter::look_again(const Instant& instant) {
    const Instant first = held_.front();
    path_.settle(first.time_ns, first.positions, first.spindle_on);
    last_ = first;
    waiting_.push_front(instant);
    waiting_.insert(waiting_.begin(), held_.begin() + 1, held_.end());
    held_.clear();
}

void LiftFilter::redefine(std::int64_t time_ns, const Positions& positions) {
    hand_on();
    last_.positions = positions;
    path_.redefine(time_ns, positions);
}

void LiftFilter::finish(std::int64_t time_ns) {
    hand_on();
    path_.finish(time_ns);
}

void LiftFilter::hand_on() {
    for (const Instant& instant : held_) path_.settle(instant.time_ns, instant.positions, instant.spindle_on);
    held_.clear();
}

}  // namespace psicarve::verify
