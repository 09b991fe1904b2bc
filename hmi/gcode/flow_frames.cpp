// SPDX-License-Identifier: GPL-3.0-or-later
// Branches and loops.
#include <cmath>
#include <utility>

#include "hmi/gcode/flow_control.hpp"

namespace psicarve::gcode {
namespace {

constexpr std::size_t kMostFrames = 100;
constexpr double kMostPasses = 1e9;

std::string written(const std::string& name) {
    return "o" + name;
}

bool is_loop(OKeyword kind) noexcept {
    return kind == OKeyword::do_so || kind == OKeyword::while_so || kind == OKeyword::repeat;
}

/// A name that is calculated is not known where values are not.
bool is_same(const std::string& one, const std::string& other) noexcept {
    return one.empty() || other.empty() || one == other;
}

}  // namespace

bool FlowControl::is_running_below(std::size_t end) const noexcept {
    for (std::size_t i = first_frame(); i < end; ++i)
        if (!frames_[i].is_running) return false;
    return true;
}

void FlowControl::pop_frame() {
    const bool is_held = frames_.back().is_held;
    frames_.pop_back();
    if (is_held) lines_.release();
}

void FlowControl::pop_to(std::size_t count) {
    while (frames_.size() > count) pop_frame();
}

FlowControl::Fault FlowControl::match(const OWordReader& reader, const OWord& word, OKeyword kind) const {
    if (frames_.size() == first_frame() || frames_.back().kind != kind)
        return reader.problem(word.begin, ProblemCode::o_word_unmatched,
                              phrase("%1 without %2 before it", name_of(word.keyword), name_of(kind)));
    if (is_same(frames_.back().name, word.name)) return std::nullopt;
    return reader.problem(word.begin, ProblemCode::o_word_unmatched,
                          phrase("%1 of %2 within %3 of %4", name_of(word.keyword), written(word.name),
                                 name_of(kind), written(frames_.back().name)));
}

FlowControl::Fault FlowControl::begin_block(OWordReader& reader, const OWord& word, Frame frame) {
    if (frames_.size() - first_frame() >= kMostFrames)
        return reader.problem(word.begin, ProblemCode::too_deep, phrase("100 blocks within each other"));
    frame.kind = word.keyword;
    frame.name = word.name;
    frame.line = lines_.number();
    frame.column = static_cast<std::uint32_t>(word.begin + 1);
    frame.body = lines_.place();
    if (frame.is_held) lines_.hold();
    frames_.push_back(std::move(frame));
    return std::nullopt;
}

FlowControl::Fault FlowControl::begin_if(OWordReader& reader, const OWord& word) {
    const bool is_reached = is_running();
    if (auto wrong = reader.read_arguments(word, !is_reached, values_)) return wrong;
    Frame frame;
    frame.is_running = is_reached && values_.front() != 0.0;
    frame.is_over = !is_reached || frame.is_running;
    return begin_block(reader, word, std::move(frame));
}

/// elseif, else, endif.
FlowControl::Fault FlowControl::branch(OWordReader& reader, const OWord& word) {
    if (auto wrong = match(reader, word, OKeyword::if_so)) return wrong;
    Frame& frame = frames_.back();
    const bool is_wanted = !frame.is_over && is_running_below(frames_.size() - 1);
    if (auto wrong = reader.read_arguments(word, !is_wanted, values_)) return wrong;
    if (word.keyword == OKeyword::endif) {
        pop_frame();
        return std::nullopt;
    }
    if (frame.is_last)
        return reader.problem(word.begin, ProblemCode::o_word_unmatched,
                              phrase("%1 behind else", name_of(word.keyword)));
    frame.is_last = word.keyword == OKeyword::else_so;
    frame.is_running = is_wanted && (frame.is_last || values_.front() != 0.0);
    frame.is_over = frame.is_over || frame.is_running;
    return std::nullopt;
}

FlowControl::Fault FlowControl::begin_loop(OWordReader& reader, const OWord& word, std::string_view line) {
    const bool is_reached = is_running();
    if (auto wrong = reader.read_arguments(word, !is_reached, values_)) return wrong;
    Frame frame;
    frame.is_running = is_reached;
    if (word.keyword == OKeyword::while_so) {
        frame.condition = line;
        frame.is_running = is_reached && values_.front() != 0.0;
    }
    if (word.keyword == OKeyword::repeat && is_reached) {
        const double passes = std::round(values_.front());
        if (passes > kMostPasses)
            return reader.problem(word.arguments, ProblemCode::out_of_range,
                                  phrase("more than 1000000000 passes"));
        frame.is_running = passes >= 1.0;
        if (frame.is_running) frame.passes_left = static_cast<std::uint64_t>(passes) - 1;
    }
    frame.is_over = !frame.is_running;
    frame.is_held = frame.is_running;
    return begin_block(reader, word, std::move(frame));
}

Result<bool> FlowControl::is_condition_met(const Frame& frame, Fault& wrong) {
    OWordReader reader{frame.condition, frame.line, parameters_};
    OWord word;
    wrong = reader.read(frame.column - 1, false, word);
    if (!wrong) wrong = reader.read_arguments(word, false, values_);
    return !wrong && values_.front() != 0.0;
}

/// The end of a pass through the loop that was begun last.
FlowControl::Outcome FlowControl::end_pass(bool goes_on) {
    if (!goes_on) {
        pop_frame();
        return Fault{};
    }
    frames_.back().is_running = true;
    if (const auto gone = lines_.go_to(frames_.back().body); !gone) return gone.error();
    return Fault{};
}

FlowControl::Outcome FlowControl::end_do(OWordReader& reader, const OWord& word) {
    const bool is_wanted = !frames_.back().is_over && is_running_below(frames_.size() - 1);
    if (auto wrong = reader.read_arguments(word, !is_wanted, values_)) return wrong;
    return end_pass(is_wanted && values_.front() != 0.0);
}

/// endwhile, endrepeat.
FlowControl::Outcome FlowControl::end_loop(OWordReader& reader, const OWord& word, OKeyword kind) {
    if (auto wrong = match(reader, word, kind)) return wrong;
    if (auto wrong = reader.read_arguments(word, true, values_)) return wrong;
    Frame& frame = frames_.back();
    if (frame.is_over || !is_running_below(frames_.size() - 1)) return end_pass(false);
    if (kind == OKeyword::repeat) {
        const bool goes_on = frame.passes_left > 0;
        if (goes_on) --frame.passes_left;
        return end_pass(goes_on);
    }
    Fault wrong;
    const auto is_met = is_condition_met(frame, wrong);
    if (wrong) return wrong;
    return end_pass(*is_met);
}

/// break, continue.
FlowControl::Fault FlowControl::leave_pass(OWordReader& reader, const OWord& word) {
    if (auto wrong = reader.read_arguments(word, true, values_)) return wrong;
    const bool is_reached = is_running();
    for (std::size_t i = frames_.size(); i-- > first_frame();) {
        Frame& frame = frames_[i];
        if (!is_loop(frame.kind) || !is_same(frame.name, word.name)) continue;
        if (is_reached) frame.is_running = false;
        if (is_reached && word.keyword == OKeyword::break_off) frame.is_over = true;
        return std::nullopt;
    }
    return reader.problem(word.begin, ProblemCode::o_word_unmatched,
                          phrase("%1 outside the loop %2", name_of(word.keyword), written(word.name)));
}

FlowControl::Fault FlowControl::unclosed() const {
    if (frames_.size() > first_frame()) {
        const Frame& frame = frames_.back();
        return Problem{frame.line, frame.column, ProblemCode::o_word_open,
                       phrase("%1 of %2 has no end", name_of(frame.kind), written(frame.name))};
    }
    if (calls_.empty()) return std::nullopt;
    return Problem{calls_.back().line, calls_.back().column, ProblemCode::o_word_open,
                   phrase("the subroutine that M98 calls has no M99")};
}

}  // namespace psicarve::gcode
