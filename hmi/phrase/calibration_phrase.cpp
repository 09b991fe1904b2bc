// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/calibration_phrase.hpp"

#include <vector>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/phrase/sentence.hpp"

namespace psicarve::session {
namespace {

std::vector<Sentence> of_a_calibration() {
    return {
        {"'%1' is not a number", phrase("%1 is not a number")},
        {"the diameter of the pin is needed", phrase("the diameter of the pin is needed")},
        {"the diameter of the blank is needed", phrase("the diameter of the blank is needed")},
        {"where %1 stands is needed", phrase("where %1 stands is needed")},
        {"both ways between the marks are needed", phrase("both ways between the marks are needed")},
        {"a pin of %1 mm is not possible; %2 to %3 mm", phrase("no pin has %1 mm; %2 to %3 mm can be")},
        {"a blank of %1 mm is not possible; %2 to %3 mm", phrase("no blank has %1 mm; %2 to %3 mm can be")},
        {"%1 cannot stand at %2 mm; its travel is %3 to %4 mm",
         phrase("%1 cannot stand at %2 mm; its travel is %3 to %4 mm")},
        {"the tip of %1 would stand %2 mm further out than counted; is the pin's diameter %3 mm, and does "
         "the "
         "tip touch it at %4 mm?",
         phrase("the tip of %1 would stand %2 mm further out than counted; is the pin's diameter %3 mm, and "
                "does the tip touch it at %4 mm?")},
        {"marks %1 mm apart on a blank of %2 mm would be %3 degrees; more than %4 is no error of mounting. "
         "Was the table turned by exactly half a turn?",
         phrase("marks %1 mm apart on a blank of %2 mm would be %3°; more than %4° is no error of mounting. "
                "Was the table turned by exactly half a turn?")},
        {"marks %1 mm apart in height; more than %2 mm is no error of mounting. Was Y left alone?",
         phrase("marks %1 mm apart in height; more than %2 mm is no error of mounting. Was Y left alone?")},
        {"a tool does not become %1 mm shorter; 0 to %2 mm, else touch the head off anew",
         phrase("a tool does not become %1 mm shorter; 0 to %2 mm, else touch the head off anew")},
        {"the core runs with another profile than %1; start it with that one",
         phrase("the core runs with another profile than %1; start it with that one")},
        {"the machine is %1; home it, jog %2 to the pin, and let it rest",
         phrase("the machine is %1; home it, jog %2 to the pin, and let it rest")},
    };
}

}  // namespace

std::optional<Phrase> calibration_phrase(const std::string& message) {
    auto found = phrase_for(of_a_calibration(), message);
    if (!found) return std::nullopt;
    for (std::string& argument : found->arguments) {
        for (const Axis axis : kAllAxes) {
            if (argument == name_of(axis)) argument = axis_letter(axis);
        }
    }
    return found;
}

}  // namespace psicarve::session
