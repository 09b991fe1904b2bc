// SPDX-License-Identifier: GPL-3.0-or-later
// Drilling: G81, G82 with a dwell, G83 in pecks.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hmi/gcode/interpreter.hpp"

namespace psicarve::gcode {
namespace {

/// Source: LinuxCNC 2.9, G83: how far above the last depth the next peck begins.
constexpr double kPeckClearanceMm = 0.254;
/// All but X Y Z.
constexpr AxisMask kOtherLetters = 0x1F8;
constexpr double kMostHoles = 1e5;
constexpr double kMostPecks = 1e5;

}  // namespace

/// In pecks, or repeated.
bool Interpreter::may_be_long() const noexcept {
    return is_cycle(outcome_.motion) && (outcome_.motion == 830 || words_.has('L'));
}

/// All of the block, but what it changes here.
Interpreter::Fault Interpreter::rehearse() const {
    CanonSink* const judge = sink_->rehearsal();
    if (judge == nullptr) return std::nullopt;
    Interpreter rehearsed{*this};
    rehearsed.sink_ = judge;
    return rehearsed.execute();
}

/// Reads the block's words; where the same cycle goes on, earlier ones hold. `modes_.motion` is still the
/// motion before this block.
Interpreter::Fault Interpreter::read_cycle_words() {
    const std::uint32_t column = words_.axis_column();
    const bool goes_on = modes_.motion == outcome_.motion;
    const std::string name = code_name('G', outcome_.motion);
    const char across = kAxisLetters[modes_.plane->across];
    const double scale = modes_.mm_per_unit;
    const auto missing = [&](Phrase what) {
        return fault(column, ProblemCode::word_missing, std::move(what));
    };
    if (!goes_on && !words_.has('R')) return missing(phrase("%1 has no R", name));
    if (!goes_on && !words_.has(across)) return missing(phrase("%1 has no %2, the depth", name, across));
    if (!goes_on && outcome_.motion == 820 && !words_.has('P'))
        return missing(phrase("%1 has no P, the dwell", name));
    if (!goes_on && outcome_.motion == 830 && !words_.has('Q'))
        return missing(phrase("%1 has no Q, the depth of a peck", name));
    if (words_.has('R')) cycle_.clear_mm = words_.value('R') * scale;
    if (words_.has(across)) cycle_.depth_mm = words_.value(across) * scale;
    if (words_.has('P')) cycle_.dwell_s = words_.value('P');
    if (words_.has('Q')) cycle_.peck_mm = words_.value('Q') * scale;
    if (outcome_.motion == 820 && cycle_.dwell_s < 0.0)
        return fault(words_.has('P') ? words_.column('P') : column, ProblemCode::out_of_range,
                     phrase("a dwell of less than 0 s"));
    if (outcome_.motion == 830 && cycle_.peck_mm <= 0.0)
        return fault(words_.has('Q') ? words_.column('Q') : column, ProblemCode::out_of_range,
                     phrase("a peck is more than 0 deep"));
    if (words_.has('L') && (words_.value('L') < 1.0 || words_.value('L') > kMostHoles))
        return fault(words_.column('L'), ProblemCode::out_of_range,
                     phrase("a cycle is done 1 to 100000 times"));
    return std::nullopt;
}

Interpreter::Fault Interpreter::drill() {
    const Plane& plane = *modes_.plane;
    const std::uint32_t column = words_.axis_column();
    if (modes_.feed_mode == FeedMode::inverse_time)
        return fault(column, ProblemCode::cycle_feed_mode, phrase("a cycle while G93 holds"));
    if ((words_.axes() & kOtherLetters) != 0)
        return fault(column, ProblemCode::cycle_rotary, phrase("a cycle moves X, Y and Z alone"));
    if (auto wrong = read_cycle_words()) return wrong;
    if (auto wrong = check_feed()) return wrong;
    const bool steps = modes_.is_incremental;
    const double clear_mm = steps ? cycle_.initial_mm + cycle_.clear_mm : cycle_.clear_mm;
    const double depth_mm = steps ? clear_mm + cycle_.depth_mm : cycle_.depth_mm;
    if (clear_mm < depth_mm && !doubts_.are_of_places())
        return fault(column, ProblemCode::cycle_depth, phrase("R is below the depth of the hole"));
    const double holes = words_.has('L') ? words_.value('L') : 1.0;
    const double pecks = outcome_.motion == 830 ? (clear_mm - depth_mm) / cycle_.peck_mm : 1.0;
    if (holes * pecks > kMostPecks)
        return fault(column, ProblemCode::out_of_range,
                     phrase("a block of more than 100000 holes and pecks"));
    const double retract_mm = modes_.retracts_to_start ? std::max(cycle_.initial_mm, clear_mm) : clear_mm;
    Position at = place_.program;
    if (!steps) note_places(mask_of(plane.across), false);
    // As in LinuxCNC: before every hole that lies above where the first one began.
    if (clear_mm > cycle_.initial_mm) {
        at[plane.across] = clear_mm;
        rapid_to(at);
    }
    // An earlier hole may have ended below this one's R: it rises on the way.
    if (!(at[plane.across] > clear_mm)) at[plane.across] = retract_mm;
    note_places(words_.axes(), false);
    const Position first_end = target();
    const double step_first_mm = steps ? first_end[plane.first] - at[plane.first] : 0.0;
    const double step_second_mm = steps ? first_end[plane.second] - at[plane.second] : 0.0;
    if (!steps) at[plane.first] = first_end[plane.first];
    if (!steps) at[plane.second] = first_end[plane.second];
    for (int hole = 0; hole < static_cast<int>(holes); ++hole) {
        at[plane.first] += step_first_mm;
        at[plane.second] += step_second_mm;
        drill_hole(at, clear_mm, depth_mm, retract_mm);
    }
    return std::nullopt;
}

void Interpreter::drill_hole(Position& at, double clear_mm, double depth_mm, double retract_mm) {
    double& height_mm = at[modes_.plane->across];
    rapid_to(at);
    if (height_mm != clear_mm) {
        height_mm = clear_mm;
        rapid_to(at);
    }
    if (outcome_.motion == 830) {
        for (double peck_mm = clear_mm - cycle_.peck_mm; peck_mm > depth_mm; peck_mm -= cycle_.peck_mm) {
            height_mm = peck_mm;
            feed_to(at);
            height_mm = clear_mm;
            rapid_to(at);
            height_mm = peck_mm + kPeckClearanceMm;
            rapid_to(at);
        }
    }
    height_mm = depth_mm;
    feed_to(at);
    if (outcome_.motion == 820) emit(CanonKind::dwell, 820, cycle_.dwell_s);
    height_mm = retract_mm;
    rapid_to(at);
}

}  // namespace psicarve::gcode
