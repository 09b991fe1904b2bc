// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/calibration_talk.hpp"

#include <cstdio>
#include <iostream>
#include <optional>

#include "hmi/cli/number_argument.hpp"
#include "hmi/profile/calibration_steps.hpp"
#include "shared/base/printable.hpp"

namespace psicarve::cli {
namespace {

using Answer = std::optional<double>;

void say(const std::string& text) {
    std::fprintf(stderr, "%s", printable(text).c_str());
}

Result<std::string> ask(const std::string& question) {
    say(question + " ");
    std::string line;
    if (!std::getline(std::cin, line))
        return Error{ErrorCode::machine_refused, "the answers ended; nothing was written"};
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) return std::string{};
    return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

/// Asks until the answer is a number; nothing for an empty line.
Result<Answer> ask_number(const std::string& question) {
    for (;;) {
        const auto line = ask(question);
        if (!line) return line.error();
        if (line->empty()) return Answer{};
        const auto number = number_argument("  not understood", *line);
        if (number) return Answer{*number};
        say(number.error().message + "\n");
    }
}

/// Repeats until the measurement is possible, or is left out. `measure` returns whether there was one.
Result<void> until_possible(const std::function<Result<void>()>& measure) {
    for (;;) {
        const auto done = measure();
        if (done || done.error().code == ErrorCode::machine_refused) return done;
        say("  not possible: " + done.error().message + "\n");
    }
}

using profile::CalibrationAnswers;
using profile::CalibrationStep;

Result<CalibrationAnswers> ask_touch_off(const std::string& name, Axis head, const HeadPlace& place_of) {
    CalibrationAnswers answers;
    const auto diameter = ask_number("Diameter of the pin [mm]; Enter leaves " + name + " as it is:");
    if (!diameter) return diameter.error();
    answers.diameter_mm = *diameter;
    if (!answers.diameter_mm) return answers;
    const auto counted = ask_number("Position of " + name + " as it is shown [mm]; Enter asks the core:");
    if (!counted) return counted.error();
    answers.counted_mm = *counted;
    if (answers.counted_mm) return answers;
    const auto place = place_of(head);
    if (!place) return bad_input(place.error().message);
    answers.counted_mm = *place;
    say("  " + name + " stands at " + std::to_string(*place) + " mm\n");
    return answers;
}

Result<CalibrationAnswers> ask_marks() {
    CalibrationAnswers answers;
    const auto diameter = ask_number("Diameter of the blank there [mm]; Enter leaves R2 as it is:");
    if (!diameter) return diameter.error();
    answers.diameter_mm = *diameter;
    if (!answers.diameter_mm) return answers;
    const auto around =
        ask_number("From R1's mark to R2's along the surface, counter-clockwise from above is + [mm]:");
    if (!around) return around.error();
    answers.around_mm = *around;
    const auto up = ask_number("How much higher R2's mark is, lower is - [mm]:");
    if (!up) return up.error();
    answers.up_mm = *up;
    return answers;
}

Result<CalibrationAnswers> ask_wear(const std::string& name) {
    CalibrationAnswers answers;
    const auto wear =
        ask_number("Wear of the tool of " + name + " since its touch-off [mm]; Enter leaves it as it is:");
    if (!wear) return wear.error();
    answers.wear_mm = *wear;
    return answers;
}

/// The steps before the measurement.
std::string introduction(CalibrationStep step, const std::string& name) {
    switch (step) {
        case CalibrationStep::touch_off_r1:
        case CalibrationStep::touch_off_r2:
            return "\nTouch-off of " + name +
                   ". Put a pin of known diameter on the axis and let the tip of " + name +
                   " just touch it, spindle off\n(psicarve jog " + name + " -0.05, or the window).\n";
        case CalibrationStep::two_marks:
            return "\nTwo marks. On a round blank let R1 make a mark, turn the table by exactly half a turn\n"
                   "(psicarve jog psi 180) with Y left alone, and let R2 make its own.\n";
        case CalibrationStep::wear_r1:
            return "\n";
        case CalibrationStep::wear_r2:
            break;
    }
    return {};
}

Result<CalibrationAnswers> ask_for(CalibrationStep step, const std::string& name, const HeadPlace& place_of) {
    if (step == CalibrationStep::two_marks) return ask_marks();
    if (step == CalibrationStep::wear_r1 || step == CalibrationStep::wear_r2) return ask_wear(name);
    return ask_touch_off(name, head_of(step), place_of);
}

}  // namespace

Result<void> talk_calibration(profile::ProfileDraft& draft, const HeadPlace& place_of) {
    for (const CalibrationStep step : profile::kCalibrationSteps) {
        const std::string name{name_of(head_of(step))};
        say(introduction(step, name));
        const auto taken = until_possible([&]() -> Result<void> {
            const auto answers = ask_for(step, name, place_of);
            if (!answers) return answers.error();
            return take_answers(draft, step, *answers);
        });
        if (!taken) return taken;
    }
    const std::string changes = profile::changes_text(draft);
    if (changes.empty()) return {};
    say("\n" + changes);
    for (;;) {
        const auto line = ask("Write this to " + draft.path() + "? yes or no:");
        if (!line) return line.error();
        if (*line == "yes" || *line == "y") return {};
        if (*line == "no" || *line == "n")
            return Error{ErrorCode::machine_refused, "as you wish; nothing was written"};
    }
}

}  // namespace psicarve::cli
