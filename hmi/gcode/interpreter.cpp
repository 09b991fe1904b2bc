// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/interpreter.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hmi/gcode/end_words.hpp"

namespace psicarve::gcode {
namespace {

bool is_drawing_code(double value) noexcept {
    return std::abs(value - 7.1) < 1e-6 || std::abs(value - 12.1) < 1e-6 || std::abs(value - 13.1) < 1e-6;
}

/// Whether G7.1, G12.1 or G13.1 stands in the text, however it is written.
bool names_drawing(std::string_view line) noexcept {
    std::string word;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        const char byte = i < line.size() ? line[i] : '\n';
        if (byte == ' ' || byte == '\t') continue;
        const bool is_number = (byte >= '0' && byte <= '9') || byte == '.';
        if (is_number && !word.empty()) {
            if (byte != '0' || word != "G") word += byte;
            continue;
        }
        if (word == "G7.1" || word == "G12.1" || word == "G13.1") return true;
        word = byte == 'G' || byte == 'g' ? "G" : "";
    }
    return false;
}

}  // namespace

Interpreter::Interpreter(const InterpreterOptions& options, CanonSink& sink, ProblemList& problems)
    : options_(options),
      sink_(&sink),
      problems_(problems),
      offsets_(options.offsets),
      place_{offsets_.to_program(options.start), options.start,
             options.is_start_known ? kAllLetters : AxisMask{0}} {
    for (std::size_t which = 0; which < references_.size(); ++which) {
        const auto& kept = options.offsets.references[which];
        references_[which] = {kept.value_or(options.reference), kept.has_value()};
    }
    place_.start_placed = place_.placed;
    mode_report_.is_wanted = sink.wants_modes();
    if (mode_report_.is_wanted) tell_modes();
}

void Interpreter::run(const Block& block, bool has_doubt) {
    outcome_.jump.code = 0;
    if (course_.has_ended || (block.is_deleted() && options_.skips_deleted)) return;
    doubts_.values = has_doubt && block.has_values();
    Fault wrong = words_.read(block, options_.dialect);
    if (!wrong && words_.is_empty()) return;
    if (!wrong) wrong = judge();
    outcome_.offsets.reset();
    if (!wrong && may_be_long()) {
        wrong = rehearse();
        if (!wrong && !sink_->wants_more()) return;
    }
    if (!wrong) wrong = execute();
    if (!wrong && outcome_.offsets) sink_->set_offsets(*outcome_.offsets);
    if (!wrong) return;
    problems_.add(std::move(*wrong));
    pass_wrong();
    for (const Word& word : block.words()) {
        const int code =
            word.letter == 'G' && word.value >= 10.0 && word.value < 100.0 ? static_cast<int>(word.value) : 0;
        if (code > 0) doubt_modes(static_cast<char>('0' + code / 10), static_cast<char>('0' + code % 10));
        if (word.letter == 'G' && is_drawing_code(word.value)) doubt_drawing();
        // A program that is wrong in its last block has an end all the same.
        if (word.letter == 'M' && (word.value == 2.0 || word.value == 30.0)) course_.has_ended = true;
    }
}

void Interpreter::pass_unreadable(std::string_view line) noexcept {
    pass_wrong();
    doubts_.end = doubts_.end || names_end(line);
    if (names_drawing(line)) doubt_drawing();
    std::size_t read = 0;  // of G and two digits
    char tens = ' ';
    for (const char byte : line) {
        if (byte == ' ' || byte == '\t' || (byte == '0' && read == 1)) continue;
        if (byte == 'G' || byte == 'g') {
            read = 1;
        } else if (read == 1) {
            tens = byte;
            read = 2;
        } else {
            if (read == 2) doubt_modes(tens, byte);
            read = 0;
        }
    }
}

/// By the digits of a G code in a wrong block: G20 G21 G70 G71 G90 G91, also with the letter O in place of 0.
void Interpreter::doubt_modes(char tens, char ones) noexcept {
    if (ones != '0' && ones != '1' && ones != 'O' && ones != 'o') return;
    const char units = modes_.mm_per_unit == 1.0 ? '1' : '0';
    const char distance = modes_.is_incremental ? '1' : '0';
    if ((tens == '2' || tens == '7') && ones != units) doubts_.units = true;
    if (tens == '9' && ones != distance) doubts_.distance = true;
}

void Interpreter::pass_wrong() noexcept {
    doubts_.axes = kAllLetters;
    place_.placed = 0;
    place_.start_placed = 0;
    drawing_.is_doubtful = true;
    doubts_.feed = true;
    doubts_.motion = true;
}

/// It is not known which mode holds: none is judged until a right block says.
void Interpreter::doubt_drawing() noexcept {
    if (!is_drawing(DrawnMode::none)) end_drawing();
    drawing_.is_mode_doubtful = true;
}

void Interpreter::end_without_block(std::uint64_t line) {
    CanonRecord ended;
    ended.line = line;
    ended.column = 1;
    give(ended);
    course_.has_ended = true;
}

Problem Interpreter::fault(std::uint32_t column, ProblemCode code, Phrase what) const {
    return words_.problem(column, code, std::move(what));
}

Interpreter::Fault Interpreter::judge() {
    if (words_.has(CodeGroup::drawing)) return judge_drawing();
    if (auto wrong = judge_motion()) return wrong;
    if (!is_drawing(DrawnMode::none))
        if (auto wrong = judge_drawing_mode()) return wrong;
    if (auto wrong = judge_claims()) return wrong;
    return words_.left_over();
}

/// Decides which code the axis words belong to, and which motion follows.
Interpreter::Fault Interpreter::judge_motion() {
    const int once = words_.code(CodeGroup::once);
    const int motion = words_.code(CodeGroup::motion);
    const bool has_axes = words_.axes() != 0;
    const bool is_length = words_.code(CodeGroup::length) == 431;
    const bool is_claimed = once == 100 || once == 280 || once == 300 || once == 920 || is_length;
    outcome_.motion = motion == 800 ? kNoCode : motion;
    if (is_claimed) {
        const CodeGroup claimant = is_length ? CodeGroup::length : CodeGroup::once;
        // G28 and its like take axis words, given or not.
        if (outcome_.motion != kNoCode && (has_axes || !is_length))
            return fault(words_.column(CodeGroup::motion), ProblemCode::claimed_twice,
                         phrase("%1 and %2 both use axis words", code_name('G', motion),
                                code_name('G', words_.code(claimant))));
        if (!has_axes && (is_length || once == 920))
            return fault(words_.column(claimant), ProblemCode::axes_missing,
                         phrase("%1 has no axis word", code_name('G', words_.code(claimant))));
        words_.take_axes();
        outcome_.motion = kNoCode;
    } else if (motion == kNoCode && (has_axes || has_centre_for_arc())) {
        outcome_.motion = modes_.motion == 800 ? kNoCode : modes_.motion;
        if (doubts_.motion) words_.take_axes();
    }
    if (outcome_.motion != kNoCode) words_.take_axes();
    if (once != 530 || drawing_.is_mode_doubtful) return std::nullopt;
    if (outcome_.motion != 0 && outcome_.motion != 10 && !doubts_.motion)
        return fault(words_.column(CodeGroup::once), ProblemCode::g53_motion,
                     phrase("G53 without a straight motion"));
    const int distance = words_.code(CodeGroup::distance);
    if (distance == 910 || (distance == kNoCode && modes_.is_incremental && !doubts_.distance))
        return fault(words_.column(CodeGroup::once), ProblemCode::g53_incremental,
                     phrase("G53 while G91 holds"));
    return std::nullopt;
}

/// After an arc a new centre alone suffices.
bool Interpreter::has_centre_for_arc() const noexcept {
    return (modes_.motion == 20 || modes_.motion == 30) &&
           (words_.has('I') || words_.has('J') || words_.has('K'));
}

/// Decides which code the other words belong to; P may belong to one code only.
Interpreter::Fault Interpreter::judge_claims() {
    const int once = words_.code(CodeGroup::once);
    const int outputs = words_.code(CodeGroup::outputs);
    const bool is_arc = outcome_.motion == 20 || outcome_.motion == 30;
    const bool calls = words_.code(CodeGroup::stop) == 98;
    int claims = 0;
    if (calls) words_.take('L');
    if (is_arc)
        for (const char letter : {'I', 'J', 'K', 'R'}) words_.take(letter);
    if (is_cycle(outcome_.motion))
        for (const char letter : {'R', 'L'}) words_.take(letter);
    if (outcome_.motion == 830 || words_.code(CodeGroup::path) == 640) words_.take('Q');
    if (once == 100)
        for (const char letter : {'L', 'R'}) words_.take(letter);
    if (outputs == 66)
        for (const char letter : {'L', 'Q'}) words_.take(letter);
    for (const bool claims_p :
         {is_arc, outcome_.motion == 820, once == 40, once == 100, outputs != kNoCode, calls,
          words_.code(CodeGroup::path) == 640, words_.code(CodeGroup::overrides) >= 50})
        claims += claims_p ? 1 : 0;
    if (claims > 0) words_.take('P');
    if (claims > 1 && words_.has('P'))
        return fault(words_.column('P'), ProblemCode::claimed_twice, phrase("two codes of the block use P"));
    if ((doubts_.motion && words_.code(CodeGroup::motion) == kNoCode) || drawing_.is_mode_doubtful)
        for (const char letter : {'I', 'J', 'K', 'R', 'P', 'Q', 'L'}) words_.take(letter);
    return std::nullopt;
}

Interpreter::Fault Interpreter::execute() {
    outcome_.is_too_far = false;
    mode_report_.is_changing = mode_report_.is_wanted && may_change_modes();
    mode_report_.is_owed = mode_report_.is_owed || mode_report_.is_changing;
    if (words_.has(CodeGroup::drawing)) return set_drawing();
    set_units();
    if (auto wrong = set_feed()) return wrong;
    if (words_.has('S')) {
        modes_.spindle_rpm = words_.value('S');
        emit(CanonKind::speed, 0, modes_.spindle_rpm);
    }
    if (auto wrong = set_outputs()) return wrong;
    set_tool();
    set_spindle();
    if (auto wrong = set_switches()) return wrong;
    if (auto wrong = dwell()) return wrong;
    set_plane();
    if (auto wrong = set_length()) return wrong;
    set_system();
    if (auto wrong = set_path()) return wrong;
    set_distances();
    if (auto wrong = do_once()) return wrong;
    if (auto wrong = move()) return wrong;
    if (outcome_.is_too_far)
        return fault(words_.axis_column(), ProblemCode::out_of_range,
                     phrase("a place beyond 1 000 000 000 mm"));
    return stop();
}

CanonRecord Interpreter::record(CanonKind kind) const {
    CanonRecord made;
    made.kind = kind;
    made.line = words_.line();
    made.column = words_.first_column();
    return made;
}

void Interpreter::emit(CanonKind kind, int code, double value) {
    CanonRecord made = record(kind);
    made.code = code;
    made.value = value;
    if (kind == CanonKind::path) drawing_.tolerance_mm = value;
    const bool is_rest = kind == CanonKind::stop || kind == CanonKind::tool_change;
    if (is_rest || (kind == CanonKind::dwell && value > 0.0)) ++course_.actions;
    give(made);
}

void Interpreter::refresh_program() noexcept {
    place_.program = offsets_.to_program(place_.machine);
}

}  // namespace psicarve::gcode
