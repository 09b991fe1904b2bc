// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/profile_phrase.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "hmi/phrase/sentence.hpp"

namespace psicarve::session {
namespace {

/// Of one value. Those that begin with what was typed last: they fit much.
std::vector<Phrase> of_a_value() {
    return {
        phrase("this is no number; enter %1 <= value <= %2"),
        phrase("this is no whole number; enter %1 <= value <= %2"),
        phrase("these are no two numbers; enter them as 0.0 ... 60.0"),
        phrase("it has a character that is none to print; remove it"),
        phrase("a text of %1 bytes; give %2 to %3 bytes"),
        phrase("a control character in the text; remove it"),
        phrase("unknown key; did you mean %1?"),
        phrase("unknown key; see profile show for all keys"),
        phrase("the profile is %1 bytes long; the most is %2"),
        phrase("this is not TOML: %1; correct the line"),
        phrase("%1 is no number to work with; give a finite one"),
        phrase("%1 is impossible; give a value from %2 to %3"),
    };
}

std::vector<Phrase> of_axes() {
    return {
        phrase("the travel from %1 to %2 mm is empty or reversed; give the lowest position first"),
        phrase("%1 mm lies outside the travel of %2 to %3 mm by more than the %4 mm of overtravel; give a "
               "position that the axis can reach"),
        phrase("%1 mm as the max sensor's edge leaves nothing of the travel of %2 to %3 mm; put it at the "
               "travel's upper end, or correct %4"),
        phrase("%1 mm as the min sensor's edge leaves nothing of the travel of %2 to %3 mm; put it at the "
               "travel's lower end, or correct %4"),
        phrase("%1 mm is out of the reach of head %2; lower it, or widen %3"),
        phrase("%1 is above the axis' top speed of %2; lower it, or raise %3"),
        phrase("%1 mm is more than the tips are apart with both heads out, %2 mm; lower it"),
        phrase("%1 is odd, so half a revolution is no whole number of pulses; give an even number"),
        phrase("%1 is half a revolution of %2 pulses or more, so lost steps would never be noticed; lower "
               "it"),
    };
}

std::vector<Phrase> of_ticks() {
    return {
        phrase("axis %1 would need %2 pulses/s, but the two-timer schedule allows %3 pulses/s; lower it to "
               "%4, or shorten tick.io_us"),
        phrase("axis %1 would need %2 pulses/s, but the tick and the pulse times allow %3 pulses/s; lower it "
               "to %4, or shorten tick.period_us, port.step_high_ns or port.step_low_ns"),
        phrase("a pulse, its gap and the writes take %1 us, more than a tick of %2 us; lengthen "
               "tick.period_us, shorten port.step_high_ns or port.step_low_ns, or set port.pulses = "
               "\"over-ticks\""),
        phrase("%1 us are too short for a pulse and its gap, which take %2 us in ticks; lengthen it, or "
               "shorten tick.period_us"),
        phrase("%1 us is no whole number of periods of %2 us; give a multiple of tick.period_us"),
        phrase("%1 us is longer than the %2 us from pulse to pulse; shorten it, or lengthen tick.io_us"),
    };
}

std::vector<Phrase> of_blank_and_tool() {
    return {
        phrase("the table's axis would be outside a blank of radius %1 mm; set blank.radius_mm, or a lesser "
               "offset"),
        phrase("is counted from the blank's surface, and nobody knows where that is; set blank.radius_mm"),
        phrase("%1 mm is more than the tool is wide, %2 mm; set it lower, or to 0"),
    };
}

std::vector<Phrase> of_pins() {
    return {
        phrase("an output cannot be on pin %1, which is an input; use pin 1 to 9, 14, 16 or 17"),
        phrase("an input cannot be on pin %1, which is an output; use pin 10 to 13 or 15"),
        phrase("is not wired, so axis %1 cannot move; give its pin"),
        phrase("is not wired, but %1 = %2 needs it; give its pin, or set %3 = \"none\""),
        phrase("%1 and %2 share pin %3: what homing looks for would be an emergency stop; give one of them "
               "another pin, or 0"),
        phrase("%1 and %2 are both on output pin %3; give one of them another pin (only enables may share)"),
        phrase("%1 and %2 share pin %3, one active high and one active low; give both the same sign"),
    };
}

std::vector<Phrase> plain_problems() {
    std::vector<Phrase> all;
    for (const auto& some : {of_blank_and_tool(), of_pins(), of_ticks(), of_axes(), of_a_value()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

/// What stands in a file.
std::vector<Phrase> kinds_of_value() {
    return {phrase("a table"),        phrase("an array"),      phrase("a string"),
            phrase("a whole number"), phrase("true or false"), phrase("a number with a fraction"),
            phrase("a date or time"), phrase("a number"),      phrase("an array of two numbers")};
}

/// The words themselves are the same in all languages: a file has them.
std::vector<Phrase> choices() {
    return {phrase("high or low"),
            phrase("single or two-timer"),
            phrase("lookahead or angle"),
            phrase("continuous, zigzag or spiral"),
            phrase("point, ball, flat or vee"),
            phrase("over-ticks or within-tick"),
            phrase("lift or stay"),
            phrase("machine or turning"),
            phrase("own or follow"),
            phrase("axes or surface"),
            phrase("path or stepwise"),
            phrase("shortest or written"),
            phrase("min, max or none"),
            phrase("index or none")};
}

Phrase kind_or_choice(const std::string& text) {
    if (auto found = phrase_for(as_said(kinds_of_value()), text)) return *found;
    return phrase_for(as_said(choices()), text).value_or(phrase("%1", text));
}

/// Its last `count` arguments are kinds of value or choices, and stand there as phrases.
Phrase with_kinds(Phrase found, std::size_t count) {
    for (std::size_t i = found.arguments.size() - count; i < found.arguments.size(); ++i)
        found.inner.push_back(kind_or_choice(found.arguments[i]));
    found.arguments.resize(found.arguments.size() - count);
    return found;
}

std::vector<Phrase> problems_with_kinds() {
    return {phrase("%1 where the table [%2] is expected; put its keys below [%3]"),
            phrase("%1 where %2 is expected; correct the value"), phrase("%1 is not possible here; give %2")};
}

std::optional<Phrase> kind_problem(const std::string& problem) {
    const std::vector<Sentence> said = as_said(problems_with_kinds());
    if (auto found = phrase_for({said[0]}, problem)) {
        // What is found stands behind the names.
        Phrase shown = phrase("%3 where the table [%1] is expected; put its keys below [%2]");
        shown.arguments = {found->arguments[1], found->arguments[2]};
        shown.inner = {kind_or_choice(found->arguments[0])};
        return shown;
    }
    if (auto found = phrase_for({said[1]}, problem)) return with_kinds(std::move(*found), 2);
    if (auto found = phrase_for({said[2]}, problem)) return with_kinds(std::move(*found), 1);
    return std::nullopt;
}

std::optional<Phrase> known_problem(const std::string& problem) {
    if (auto found = phrase_for(as_said(plain_problems()), problem)) return found;
    return kind_problem(problem);
}

/// "job.feed_mm_s: 0 mm/s is impossible; ...", or without a key.
std::optional<Phrase> problem_of_a_key(const std::string& text) {
    const std::size_t end = text.find(": ");
    auto found = end == std::string::npos ? std::nullopt : known_problem(text.substr(end + 2));
    if (found) return joined(phrase("%1", text.substr(0, end)), std::move(*found));
    return known_problem(text);
}

/// "m.toml:2: job.feed_mm_s: ...".
std::optional<Phrase> problem_of_a_file(const std::string& message) {
    for (std::size_t end = message.find(": "); end != std::string::npos; end = message.find(": ", end + 1)) {
        const std::size_t colon = message.rfind(':', end - 1);
        if (end == 0 || colon == std::string::npos || colon + 1 == end) continue;
        const std::string line = message.substr(colon + 1, end - colon - 1);
        if (line.find_first_not_of("0123456789") != std::string::npos) continue;
        if (auto found = problem_of_a_key(message.substr(end + 2))) {
            return Phrase{
                "%1: %2: %3",
                {},
                {phrase("%1", message.substr(0, colon)), phrase("line %1", line), std::move(*found)}};
        }
    }
    return std::nullopt;
}

std::optional<Phrase> draft_error(const std::string& message) {
    const std::vector<Sentence> said = as_said(
        {phrase("the built-in profile has no file: save it under a name"),
         phrase("%1: somebody has changed this file since it was opened; save under another name, or open it "
                "again and lose these changes"),
         phrase("%1: it would not say what is shown here; open it again"),
         phrase("%1: line %2: %3 has no place: a table of that name stands here; rename it"),
         phrase("%1: line %2: %3 has no place: a value of that name stands here; rename it"),
         phrase("%1: line %2: %3 cannot be set as this is written; give its table a header, [%4], and each "
                "key a line below it")});
    return phrase_for(said, message);
}

}  // namespace

Phrase profile_problem_phrase(const std::string& problem) {
    return known_problem(problem).value_or(phrase("%1", problem));
}

std::optional<Phrase> profile_error_phrase(const std::string& message) {
    if (auto found = problem_of_a_file(message)) return found;
    if (auto found = draft_error(message)) return found;
    return problem_of_a_key(message);
}

std::vector<std::string> known_profile_problems() {
    std::vector<std::string> all;
    for (const auto& some : {plain_problems(), problems_with_kinds(), kinds_of_value(), choices()})
        for (const Phrase& one : some) all.emplace_back(one.english);
    return all;
}

}  // namespace psicarve::session
