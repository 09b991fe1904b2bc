// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/flow_control.hpp"

#include <algorithm>
#include <utility>

#include "hmi/gcode/block_reader.hpp"

namespace psicarve::gcode {
namespace {

constexpr std::size_t kMostSubroutines = 10'000;

bool is_space(char byte) noexcept {
    return byte == ' ' || byte == '\t' || byte == '\r';
}

/// Index of the O that a line begins with, apart from comments, / and the line's number.
std::optional<std::size_t> o_word_in(std::string_view line, bool skips_deleted) noexcept {
    bool is_in_number = false;
    for (std::size_t at = 0; at < line.size(); ++at) {
        const char byte = line[at];
        if (byte == 'o' || byte == 'O') return at;
        if (byte == '(') {
            at = line.find(')', at);
            if (at == std::string_view::npos) return std::nullopt;
            continue;
        }
        if (byte == '/' && skips_deleted) return std::nullopt;
        if (byte == 'n' || byte == 'N') is_in_number = true;
        const bool is_digit = byte >= '0' && byte <= '9';
        if (is_space(byte) || byte == '/' || byte == 'n' || byte == 'N' || (is_in_number && is_digit))
            continue;
        return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace

FlowControl::Fault FlowControl::judge(std::string_view line, std::size_t o_word) {
    OWordReader reader{line, lines_.number(), parameters_};
    OWord word;
    if (auto wrong = reader.read(o_word, true, word)) return wrong;
    return reader.read_arguments(word, true, values_);
}

FlowControl::Outcome FlowControl::run(std::string_view line, std::size_t o_word) {
    has_begun_ = true;
    OWordReader reader{line, lines_.number(), parameters_};
    OWord word;
    if (auto wrong = reader.read(o_word, !is_running(), word)) return wrong;
    return dispatch(reader, word, line);
}

bool FlowControl::pass_over() noexcept {
    if (!calls_.empty()) return false;
    for (Frame& frame : frames_) {
        frame.is_running = false;
        frame.is_over = true;
    }
    return !frames_.empty();
}

FlowControl::Outcome FlowControl::pass(std::string_view line) {
    const auto begin = o_word_in(line, skips_deleted_);
    if (!begin) return Fault{};
    return run(line, *begin);
}

FlowControl::Outcome FlowControl::dispatch(OWordReader& reader, const OWord& word, std::string_view line) {
    switch (word.keyword) {
        case OKeyword::label:
            return enter_label(reader, word);
        case OKeyword::sub:
            return define(reader, word);
        case OKeyword::endsub:
            return end_sub(reader, word);
        case OKeyword::call:
            return call_by_name(reader, word);
        case OKeyword::give_back:
            return give_back(reader, word);
        case OKeyword::if_so:
            return begin_if(reader, word);
        case OKeyword::else_if:
        case OKeyword::else_so:
        case OKeyword::endif:
            return branch(reader, word);
        case OKeyword::while_so:
            if (!match(reader, word, OKeyword::do_so)) return end_do(reader, word);
            return begin_loop(reader, word, line);
        case OKeyword::do_so:
        case OKeyword::repeat:
            return begin_loop(reader, word, line);
        case OKeyword::endwhile:
            return end_loop(reader, word, OKeyword::while_so);
        case OKeyword::endrepeat:
            return end_loop(reader, word, OKeyword::repeat);
        case OKeyword::break_off:
        case OKeyword::go_on:
            return leave_pass(reader, word);
    }
    return Fault{};
}

FlowControl::Fault FlowControl::enter_name(const std::string& name, const Subroutine& subroutine,
                                           std::uint32_t column) {
    const auto known = subroutines_.find(name);
    if (known == subroutines_.end()) {
        if (subroutines_.size() >= kMostSubroutines)
            return Problem{subroutine.line, column, ProblemCode::parameter_many,
                           phrase("more than 10000 subroutines")};
        subroutines_.emplace(name, subroutine);
        return std::nullopt;
    }
    if (known->second.line == subroutine.line) return std::nullopt;
    return Problem{subroutine.line, column, ProblemCode::sub_twice,
                   phrase("o%1 is a subroutine in line %2", name, std::to_string(known->second.line))};
}

FlowControl::Fault FlowControl::define(OWordReader& reader, const OWord& word) {
    if (auto wrong = reader.read_arguments(word, true, values_)) return wrong;
    if (!frames_.empty() || !calls_.empty())
        return reader.problem(word.begin, ProblemCode::o_word_place,
                              phrase("a subroutine within another block"));
    const auto column = static_cast<std::uint32_t>(word.begin + 1);
    if (auto wrong = enter_name(word.name, {lines_.place(), lines_.number(), false}, column)) return wrong;
    Frame frame;
    frame.is_held = true;
    return begin_block(reader, word, std::move(frame));
}

FlowControl::Fault FlowControl::enter_label(const OWordReader& reader, const OWord& word) {
    if (frames_.size() > first_frame())
        return reader.problem(word.begin, ProblemCode::o_word_place,
                              phrase("a number alone begins a subroutine for M98, within another block"));
    return enter_name(word.name, {lines_.place(), lines_.number(), true},
                      static_cast<std::uint32_t>(word.begin + 1));
}

FlowControl::Outcome FlowControl::end_sub(OWordReader& reader, const OWord& word) {
    if (auto wrong = match(reader, word, OKeyword::sub)) return wrong;
    const bool is_called = frames_.back().is_called;
    const bool is_reached = is_called && is_running();
    if (auto wrong = reader.read_arguments(word, !is_reached, values_)) return wrong;
    if (is_called) return leave_call(values_.empty() ? std::nullopt : std::optional{values_.front()});
    lines_.keep_for_good();
    pop_frame();
    return Fault{};
}

FlowControl::Outcome FlowControl::give_back(OWordReader& reader, const OWord& word) {
    const bool is_reached = is_running();
    if (auto wrong = reader.read_arguments(word, !is_reached, values_)) return wrong;
    const std::size_t first = first_frame();
    if (frames_.size() == first || frames_[first].kind != OKeyword::sub)
        return Fault{
            reader.problem(word.begin, ProblemCode::o_word_place, phrase("return outside a subroutine"))};
    if (!is_reached) return Fault{};
    return leave_call(values_.empty() ? std::nullopt : std::optional{values_.front()});
}

FlowControl::Outcome FlowControl::leave_call(std::optional<double> returned) {
    const Call left = calls_.back();
    pop_to(left.first_frame);
    calls_.pop_back();
    left.is_by_number ? parameters_.leave_shared() : parameters_.leave_call(returned);
    if (const auto gone = lines_.go_to(left.back); !gone) return gone.error();
    return Fault{};
}

FlowControl::Outcome FlowControl::call_by_name(OWordReader& reader, const OWord& word) {
    const bool is_reached = is_running();
    if (auto wrong = reader.read_arguments(word, !is_reached, values_)) return wrong;
    if (!is_reached) return Fault{};
    const Subroutine* found = nullptr;
    Call entered;
    entered.line = lines_.number();
    entered.column = static_cast<std::uint32_t>(word.begin + 1);
    auto searched = find(word.name, found);
    if (!searched || *searched) return searched;
    if (found == nullptr || found->is_by_number)
        return Fault{reader.problem(word.begin, ProblemCode::sub_missing,
                                    phrase("the program has no subroutine %1", "o" + word.name))};
    if (calls_.size() >= kMostCalls)
        return Fault{
            reader.problem(word.begin, ProblemCode::too_deep, phrase("100 calls within each other"))};
    entered.back = lines_.place();
    entered.body = found->body;
    entered.first_frame = frames_.size();
    calls_.push_back(entered);
    parameters_.enter_call(values_);
    Frame frame;
    frame.kind = OKeyword::sub;
    frame.name = word.name;
    frame.line = found->line;
    frame.column = 1;
    frame.is_running = true;
    frame.is_called = true;
    frames_.push_back(std::move(frame));
    if (const auto gone = lines_.go_to(entered.body); !gone) return gone.error();
    return Fault{};
}

FlowControl::Outcome FlowControl::call(const CallByNumber& wanted) {
    has_begun_ = true;
    const auto fault = [&](ProblemCode code, Phrase what) {
        return Fault{Problem{wanted.line, wanted.column, code, std::move(what)}};
    };
    const std::string name = std::to_string(wanted.number);
    const Subroutine* found = nullptr;
    auto searched = find(name, found);
    if (!searched || *searched) return searched;
    if (found == nullptr)
        return fault(ProblemCode::sub_missing, phrase("the program has no subroutine %1", "O" + name));
    if (!found->is_by_number)
        return fault(ProblemCode::sub_missing, phrase("o%1 sub is called by o%1 call", name));
    if (wanted.times == 0) return Fault{};
    if (calls_.size() >= kMostCalls)
        return fault(ProblemCode::too_deep, phrase("100 calls within each other"));
    if (!lines_.can_go_to(found->body))
        return fault(ProblemCode::text_too_long, phrase("O%1 has gone by in the stream", name));
    calls_.push_back(
        {lines_.place(), found->body, frames_.size(), true, wanted.times - 1, wanted.line, wanted.column});
    parameters_.enter_shared();
    if (const auto gone = lines_.go_to(found->body); !gone) return gone.error();
    return Fault{};
}

FlowControl::Outcome FlowControl::go_back(std::uint64_t line, std::uint32_t column) {
    has_begun_ = true;
    if (calls_.empty())
        return Fault{Problem{line, column, ProblemCode::endless,
                             phrase("M99 in the main program begins it again for ever")}};
    Call& call = calls_.back();
    if (!call.is_by_number)
        return Fault{Problem{line, column, ProblemCode::o_word_place,
                             phrase("M99 ends what M98 has called, and endsub what call has")}};
    if (call.times_left == 0) return leave_call(std::nullopt);
    --call.times_left;
    pop_to(call.first_frame);
    if (const auto gone = lines_.go_to(call.body); !gone) return gone.error();
    return Fault{};
}

/// A subroutine may stand behind its call: then all that follows is looked through, once.
FlowControl::Outcome FlowControl::find(const std::string& name, const Subroutine*& found) {
    auto known = subroutines_.find(name);
    if (known == subroutines_.end() && !has_looked_ahead_) {
        auto looked = look_ahead();
        if (!looked || *looked) return looked;
        known = subroutines_.find(name);
    }
    found = known == subroutines_.end() ? nullptr : &known->second;
    return Fault{};
}

FlowControl::Outcome FlowControl::look_ahead() {
    has_looked_ahead_ = true;
    const LinePlace here = lines_.place();
    lines_.hold();
    std::string_view line;
    Fault wrong;
    while (!wrong && !lines_.has_overflowed()) {
        const auto has_line = lines_.next(line);
        if (!has_line) return has_line.error();
        if (!*has_line || is_percent_line(line)) break;
        wrong = note_ahead(line);
    }
    lines_.keep_for_good();
    lines_.release();
    if (wrong || lines_.has_overflowed()) return wrong;
    if (const auto gone = lines_.go_to(here); !gone) return gone.error();
    return Fault{};
}

FlowControl::Fault FlowControl::note_ahead(std::string_view line) {
    const auto begin = o_word_in(line, skips_deleted_);
    if (!begin) return std::nullopt;
    OWordReader reader{line, lines_.number(), parameters_};
    OWord word;
    if (reader.read(*begin, true, word) || word.name.empty()) return std::nullopt;
    if (word.keyword != OKeyword::sub && word.keyword != OKeyword::label) return std::nullopt;
    return enter_name(word.name, {lines_.place(), lines_.number(), word.keyword == OKeyword::label},
                      static_cast<std::uint32_t>(*begin + 1));
}

}  // namespace psicarve::gcode
