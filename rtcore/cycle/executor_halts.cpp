// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/executor.hpp"

namespace psicarve::cycle {

// An end that was found for other marks may be none any more: it is sought anew.
void Executor::rest_behind(std::uint8_t marks) noexcept {
    if (marks == wanted_marks_) return;
    wanted_marks_ = marks;
    line_stop_.want(marks);
    pace_.unbound();
}

// In motion: where the end that is found asks for a brake now, or had asked for one before, is told at once.
void Executor::look_for_line_end() noexcept {
    if (!line_stop_.look(feed_, LineStop::kBlocksPerTick) || !line_stop_.holds(feed_.number())) return;
    const LineStop::Bounds bounds = line_stop_.bounds(feed_.number());
    if (!pace_.bound_now(bounds.begin2, bounds.end2)) line_stop_.seek_next(feed_);
}

void Executor::look_at_rest() noexcept {
    line_stop_.seek(feed_);
    (void)line_stop_.look(feed_, LineStop::kBlocksAtRest);
}

// Before the block at hand is entered.
void Executor::bound_segment() noexcept {
    if (!line_stop_.holds(feed_.number())) return pace_.unbound();
    const LineStop::Bounds bounds = line_stop_.bounds(feed_.number());
    pace_.bound(bounds.begin2, bounds.end2);
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
    return line_stop_.ends_at(feed_.number()) || pace_.is_slowest();
}

void Executor::rest_at_line_end() noexcept {
    rested_marks_ = feed_.take_marks(wanted_marks_);
    line_stop_.forget();
    pace_.unbound();
    slowing_ = true;
    pace_.aim(0.0);
    pace_.rest();
    has_line_ended_ = true;
    starts_again_ = true;
}

}  // namespace psicarve::cycle
