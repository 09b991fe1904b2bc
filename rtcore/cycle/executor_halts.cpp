// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "rtcore/cycle/executor.hpp"

namespace psicarve::cycle {

// A mark that stays wanted keeps its stop: what is braked for by one switch is not passed because another one
// was turned.
void Executor::rest_behind(std::uint8_t marks) noexcept {
    if (marks == wanted_marks_) return;
    wanted_marks_ = marks;
    bool is_looser = false;
    for (LineStop& stop : line_stops_) {
        if (is_wanted(stop)) continue;
        is_looser = is_looser || stop.holds(feed_.number());
        stop.forget();
    }
    if (!is_looser) return;
    if (const auto bounds = stop_bounds()) return pace_.loosen_bounds(bounds->begin2, bounds->end2);
    pace_.unbound();
}

bool Executor::is_stop_at_hand() const noexcept {
    return line_stops_[0].holds(feed_.number()) || line_stops_[1].holds(feed_.number());
}

// In the block at hand: the lowest of all. Between two brakes lies an allowed one.
std::optional<LineStop::Bounds> Executor::stop_bounds() const noexcept {
    std::optional<LineStop::Bounds> lowest;
    for (const LineStop& stop : line_stops_) {
        if (!stop.holds(feed_.number())) continue;
        const LineStop::Bounds own = stop.bounds(feed_.number());
        lowest =
            lowest ? LineStop::Bounds{std::min(lowest->begin2, own.begin2), std::min(lowest->end2, own.end2)}
                   : own;
    }
    return lowest;
}

void Executor::forget_stops() noexcept {
    for (LineStop& stop : line_stops_) stop.forget();
    pace_.unbound();
}

// In motion: where the end that is found asks for a brake now, or had asked for one before, is told at once.
void Executor::look_for_line_end() noexcept {
    for (LineStop& stop : line_stops_) {
        if (!is_wanted(stop) || !stop.look(feed_, LineStop::kBlocksPerTick) || !stop.holds(feed_.number()))
            continue;
        const LineStop::Bounds bounds = stop.bounds(feed_.number());
        if (!pace_.bound_now(bounds.begin2, bounds.end2)) stop.seek_next(feed_);
    }
}

void Executor::look_at_rest() noexcept {
    for (LineStop& stop : line_stops_) {
        if (!is_wanted(stop)) continue;
        stop.seek(feed_);
        (void)stop.look(feed_, LineStop::kBlocksAtRest);
    }
}

// Before the block at hand is entered.
void Executor::bound_segment() noexcept {
    const auto bounds = stop_bounds();
    if (!bounds) return pace_.unbound();
    pace_.bound(bounds->begin2, bounds->end2);
}

// At rest, of a halt that the plan has for a switch.
bool Executor::is_halt_wanted() noexcept {
    const bool is_wanted = block().marks == 0 || (block().marks & wanted_marks_) != 0;
    feed_.forget_marks();
    return is_wanted;
}

bool Executor::rested_at_mark() noexcept {
    const std::uint8_t marks = feed_.take_marks(wanted_marks_);
    if (marks != 0) rested_marks_ = marks;
    return marks != 0;
}

// An end with which a run ends is none of these: there it rests anyway.
bool Executor::rests_at_line_end() const noexcept {
    if (slowing_ || (block().marks & wanted_marks_) == 0) return false;
    if (feed_.is_last_of_group() && !feed_.goes_on()) return false;
    return line_stops_[0].ends_at(feed_.number()) || line_stops_[1].ends_at(feed_.number()) ||
           pace_.is_slowest();
}

void Executor::rest_at_line_end() noexcept {
    rested_marks_ = feed_.take_marks(wanted_marks_);
    forget_stops();
    slowing_ = true;
    pace_.aim(0.0);
    pace_.rest();
    has_line_ended_ = true;
    starts_again_ = true;
}

}  // namespace psicarve::cycle
