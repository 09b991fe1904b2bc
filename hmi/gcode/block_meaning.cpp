// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/block_meaning.hpp"

#include <cmath>
#include <utility>

namespace psicarve::gcode {
namespace {

/// Letters that take whole numbers.
constexpr std::string_view kWholeLetters = "DHLNT";

constexpr std::array<std::int8_t, 26> make_axis_of_letter() {
    std::array<std::int8_t, 26> table{};
    table.fill(-1);
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        table[static_cast<std::size_t>(kAxisLetters[axis] - 'A')] = static_cast<std::int8_t>(axis);
    return table;
}
constexpr auto kAxisOfLetter = make_axis_of_letter();

std::string spoken(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

std::string code_name(char letter, int code) {
    if (letter == 'M') return "M" + std::to_string(code);
    std::string name = letter + std::to_string(code / 10);
    if (code % 10 != 0) name += "." + std::to_string(code % 10);
    return name;
}

Problem BlockMeaning::problem(std::uint32_t column, ProblemCode code, Phrase what) const {
    return {line_, column, code, std::move(what)};
}

std::uint32_t BlockMeaning::axis_column() const noexcept {
    std::uint32_t least = 0;
    for (std::size_t axis = 0; axis < kLetterCount; ++axis) {
        if ((axes_ & mask_of(axis)) == 0) continue;
        const std::uint32_t at = column(kAxisLetters[axis]);
        if (least == 0 || at < least) least = at;
    }
    return least == 0 ? first_column_ : least;
}

std::optional<Problem> BlockMeaning::read(const Block& block, Dialect dialect) {
    line_ = block.line();
    codes_.fill(kNoCode);
    given_ = 0;
    taken_ = 0;
    axes_ = 0;
    are_axes_taken_ = false;
    is_empty_ = block.words().empty();
    first_column_ = is_empty_ ? 1 : block.words().front().column;
    for (const Word& word : block.words()) {
        const bool is_code = word.letter == 'G' || word.letter == 'M';
        if (auto wrong = is_code ? read_code(word, dialect) : read_value(word)) return wrong;
    }
    take('N');
    return std::nullopt;
}

std::optional<Problem> BlockMeaning::read_code(const Word& word, Dialect dialect) {
    const bool is_g = word.letter == 'G';
    const double scaled = is_g ? word.value * 10.0 : word.value;
    const double nearest = std::round(scaled);
    const ProblemCode unknown = is_g ? ProblemCode::unknown_g : ProblemCode::unknown_m;
    const bool is_plain = std::abs(scaled - nearest) < 1e-6 && nearest >= 0.0 && nearest < 1000.0;
    if (!is_plain)
        return problem(word.column, unknown,
                       phrase("%1 is not known", std::string{word.letter} + spoken(word.value)));
    int code = static_cast<int>(nearest);
    if (is_g && dialect == Dialect::iso && (code == 700 || code == 710)) code -= 500;
    const CodeEntry entry = is_g ? g_code_entry(code) : m_code_entry(code);
    switch (entry.standing) {
        case CodeStanding::known:
            return enter(word, entry.group, code);
        case CodeStanding::compensation:
            return problem(word.column, ProblemCode::compensation,
                           phrase("%1: cutter compensation is not done", code_name(word.letter, code)));
        case CodeStanding::tool_table:
            return problem(word.column, ProblemCode::tool_table,
                           phrase("%1: there is no tool table", code_name(word.letter, code)));
        case CodeStanding::unknown:
            break;
    }
    return problem(word.column, unknown, phrase("%1 is not known", code_name(word.letter, code)));
}

std::optional<Problem> BlockMeaning::enter(const Word& word, CodeGroup group, int code) {
    int& place = codes_[index_of(group)];
    // G80 only ends a cycle, as the motion beside it does.
    const bool is_end_of_cycle =
        group == CodeGroup::motion && place != kNoCode && code == 800 && place != 800;
    if (is_end_of_cycle) return std::nullopt;
    if (place != kNoCode && !(group == CodeGroup::motion && place == 800 && code != 800))
        return problem(word.column, ProblemCode::group_conflict,
                       phrase("%1 stands beside %2 of its group", code_name(word.letter, code),
                              code_name(word.letter, place)));
    place = code;
    code_columns_[index_of(group)] = word.column;
    return std::nullopt;
}

std::optional<Problem> BlockMeaning::read_value(const Word& word) {
    if (has(word.letter))
        return problem(word.column, ProblemCode::word_repeated,
                       phrase("%1 stands twice in the block", word.letter));
    const bool counts = kWholeLetters.find(word.letter) != std::string_view::npos;
    if (counts && word.value != std::floor(word.value))
        return problem(word.column, ProblemCode::not_whole,
                       phrase("%1 is no whole number", word.letter + spoken(word.value)));
    const bool has_sign = !counts && word.letter != 'F' && word.letter != 'S';
    if (!has_sign && word.value < 0.0)
        return problem(word.column, ProblemCode::out_of_range,
                       phrase("%1 is less than 0", word.letter + spoken(word.value)));
    given_ |= bit_of(word.letter);
    values_[slot_of(word.letter)] = word.value;
    columns_[slot_of(word.letter)] = word.column;
    const std::int8_t axis = kAxisOfLetter[slot_of(word.letter)];
    if (axis >= 0) axes_ = static_cast<AxisMask>(axes_ | mask_of(static_cast<std::size_t>(axis)));
    return std::nullopt;
}

std::optional<Problem> BlockMeaning::left_over() const {
    if (axes_ != 0 && !are_axes_taken_)
        return problem(axis_column(), ProblemCode::axes_unused,
                       phrase("no motion is in force that uses axis words"));
    for (const char letter : std::string_view{"IJKRPQLHD"}) {
        if (has(letter) && (taken_ & bit_of(letter)) == 0)
            return problem(column(letter), ProblemCode::word_unused,
                           phrase("nothing in the block uses %1", letter));
    }
    return std::nullopt;
}

}  // namespace psicarve::gcode
