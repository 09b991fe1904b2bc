// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/offsets_change.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "hmi/cli/number_argument.hpp"
#include "shared/base/nearest.hpp"

namespace psicarve::cli {
namespace {

constexpr char kRotation = 'R';
constexpr double kMostOffset = 1e9;

std::string in_capitals(std::string word) {
    for (char& letter : word)
        if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
    return word;
}

Error no_such(const std::string& what, const std::string& word, const std::vector<std::string>& names) {
    std::string text = "gcode offsets: " + what + " '" + word + "'; ";
    if (const auto meant = nearest(in_capitals(word), names)) {
        text += "did you mean '" + *meant + "'?";
    } else {
        text += "one of";
        for (const std::string& name : names) text += " " + name;
    }
    return {ErrorCode::bad_usage, text};
}

std::vector<std::string> system_names() {
    return {gcode::kSystemNames.begin(), gcode::kSystemNames.end()};
}

std::optional<std::size_t> system_of(const std::string& word) {
    const auto found = std::ranges::find(gcode::kSystemNames, in_capitals(word));
    if (found == gcode::kSystemNames.end()) return std::nullopt;
    return static_cast<std::size_t>(found - gcode::kSystemNames.begin());
}

std::string letters_text(const gcode::AxisLetters& letters) {
    std::string text;
    for (std::size_t letter = 0; letter < gcode::kLetterCount; ++letter)
        if ((letters.all() & gcode::mask_of(letter)) != 0)
            text += std::string{gcode::kAxisLetters[letter]} + " ";
    return text + kRotation;
}

/// "X=10".
Result<void> set_value(const std::string& word, const gcode::AxisLetters& letters,
                       gcode::SystemOffset& system) {
    if (word.size() < 2 || word[1] != '=')
        return Error{ErrorCode::bad_usage, "gcode offsets: '" + word + "' is no LETTER=NUMBER, as X=10"};
    const char letter = in_capitals(word.substr(0, 1))[0];
    const std::size_t axis = gcode::kAxisLetters.find(letter);
    const bool moves = axis != std::string_view::npos && (letters.all() & gcode::mask_of(axis)) != 0;
    if (letter != kRotation && !moves)
        return Error{ErrorCode::bad_usage, "gcode offsets: no axis has the letter " + word.substr(0, 1) +
                                               "; the profile's [gcode] has " + letters_text(letters) +
                                               ", the turn"};
    const auto value = number_argument(word.substr(0, 1), word.substr(2));
    if (!value) return value.error();
    if (std::abs(*value) > kMostOffset)
        return Error{ErrorCode::bad_usage, "gcode offsets: " + word + ": beyond 1 000 000 000"};
    (letter == kRotation ? system.rotation_deg : system.origin[axis]) = *value;
    return {};
}

Result<void> set_system(const std::vector<std::string>& words, const gcode::AxisLetters& letters,
                        gcode::KeptOffsets& kept) {
    if (words.size() < 3)
        return Error{ErrorCode::bad_usage,
                     "gcode offsets: set SYSTEM LETTER=NUMBER ..., as set G54 X=10 Z=0"};
    const auto system = system_of(words[1]);
    if (!system) return no_such("no system", words[1], system_names());
    gcode::SystemOffset changed = kept.systems[*system];
    std::string given;
    for (std::size_t n = 2; n < words.size(); ++n) {
        if (const auto set = set_value(words[n], letters, changed); !set) return set;
        const std::string letter = in_capitals(words[n].substr(0, 1));
        if (given.find(letter) != std::string::npos)
            return Error{ErrorCode::bad_usage, "gcode offsets: " + letter + " is given twice"};
        given += letter;
    }
    kept.systems[*system] = changed;
    return {};
}

Result<void> clear(const std::vector<std::string>& words, gcode::KeptOffsets& kept) {
    if (words.size() != 2)
        return Error{ErrorCode::bad_usage, "gcode offsets: clear SYSTEM, G92, G28, G30 or all"};
    const std::string what = in_capitals(words[1]);
    if (clears_all(words)) {
        kept = {};
    } else if (what == "G92") {
        kept.shift = {};
        kept.is_shifted = false;
    } else if (what == "G28" || what == "G30") {
        kept.references[what == "G28" ? 0 : 1].reset();
    } else if (const auto system = system_of(what)) {
        kept.systems[*system] = {};
    } else {
        auto names = system_names();
        names.insert(names.end(), {"G92", "G28", "G30", "all"});
        return no_such("no system", words[1], names);
    }
    return {};
}

}  // namespace

bool clears_all(const std::vector<std::string>& words) {
    return words.size() == 2 && words[0] == "clear" && in_capitals(words[1]) == "ALL";
}

Result<void> change_offsets(const std::vector<std::string>& words, const gcode::AxisLetters& letters,
                            gcode::KeptOffsets& kept) {
    if (words[0] == "set") return set_system(words, letters, kept);
    if (words[0] == "clear") return clear(words, kept);
    const auto meant = nearest(words[0], {"set", "clear"});
    return Error{ErrorCode::bad_usage, "gcode offsets: unknown change '" + words[0] + "'; " +
                                           (meant ? "did you mean '" + *meant + "'?" : "set or clear")};
}

}  // namespace psicarve::cli
