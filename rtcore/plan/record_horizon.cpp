// SPDX-License-Identifier: GPL-3.0-or-later
// How a program whose end is not known is planned part by part.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rtcore/plan/record_program.hpp"

namespace psicarve::plan {
namespace {

// Where a curve goes on, its nodes in the way before follow from the one before that, and tubes from ways two
// further on.
constexpr std::size_t kPointsBefore = 6;
}  // namespace

// Plans what does not depend on how the way goes on.
void RecordProgram::go_ahead() {
    look_at_spans();
    if (is_open_) {
        if (const std::size_t rest = next_rest(); rest + 1 < points_.size()) return close_run(rest);
    } else if (const std::size_t rest = plan_up_to_rests(); rest > begin_) {
        return rest_at(rest);
    }
    const std::size_t to = points_.size() - 1 - kTailPoints;
    if (decide_part(to)) return;
    // No curve goes on within the tube: there is a rest where it has come to, or where it would have.
    if (is_open_) return rest_where_decided();
    plan_stretch(begin_, to);
    rest_at(to);
}

/// The next corner that asks for a rest, or the end of what was gathered.
std::size_t RecordProgram::next_rest() const {
    std::size_t i = begin_ + 1;
    while (i + 1 < points_.size() && !corners_[i - 1].is_stop) ++i;
    return i;
}

// A run that has gone on comes to rest in this point.
void RecordProgram::close_run(std::size_t point) {
    CurvePart part;
    if (stretches_->decide(points_, spans_, corners_, {begin_, point, point}, part)) {
        part.lines = lines_of(begin_, point);
        settle(std::move(part));
        end_run();
        points_[point].pulses = speeds_.end_pulses();
        rest_at(point);
    } else {
        rest_where_decided();
    }
    if (points_.size() > 1) look_at_spans();
}

// Its curve has passed the last decided point within the tolerance: from there a straight way leads back to
// the polyline, for a curve might go as far again.
void RecordProgram::rest_where_decided() {
    end_run();
    const bool is_off = points_[begin_].pulses != speeds_.end_pulses();
    points_[begin_].pulses = speeds_.end_pulses();
    // It may stand in the point before now, and between them is no way to look at.
    rest_at(begin_);
    if (!is_off || points_.size() == 1) return;
    if (points_[1].pulses != points_[0].pulses) {
        look_at_spans();
        plan_stretch(0, 1);
    }
    rest_at(1);
}

// The curve as far as this point; the part before it is settled. False: there is none.
bool RecordProgram::decide_part(std::size_t to) {
    CurvePart part;
    if (!stretches_->decide(points_, spans_, corners_, {begin_, to, points_.size() - 1}, part)) return false;
    part.lines = lines_of(begin_, to);
    if (is_open_) {
        settle(std::move(part));
    } else {
        speeds_.hold(std::move(part));
        carries_on_ = false;
    }
    is_open_ = true;
    drop_points(to - kPointsBefore);
    begin_ = kPointsBefore;
    return true;
}

void RecordProgram::settle(CurvePart part) {
    const std::vector<RecordPlace> lines = speeds_.held().lines;
    // Where in the next part it begins does not matter: rapid ways are few.
    const bool feed_follows = std::any_of(part.lines.begin() + 1, part.lines.end(),
                                          [](const RecordPlace& place) { return !place.is_rapid; });
    pieces_.clear();
    speeds_.settle(std::move(part), pieces_);
    add_group(lines, carries_on_ ? cycle::kGoesOn | cycle::kCarriesOn : cycle::kGoesOn, feed_follows);
    carries_on_ = true;
}

void RecordProgram::end_run() {
    const std::vector<RecordPlace> lines = speeds_.held().lines;
    pieces_.clear();
    speeds_.end(pieces_);
    add_group(lines, carries_on_ ? cycle::kCarriesOn : 0);
}

}  // namespace psicarve::plan
