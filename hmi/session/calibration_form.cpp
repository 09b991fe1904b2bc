// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/calibration_form.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "hmi/phrase/error_phrase.hpp"

namespace psicarve::session {
namespace {

using profile::CalibrationAnswers;
using profile::ProfileDraft;

constexpr std::string_view kMinus = "\u2212";

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Result<std::optional<double>> number_in(const std::string& field) {
    const std::string typed = trimmed(field);
    if (typed.empty()) return std::optional<double>{};
    std::string text = typed;
    std::replace(text.begin(), text.end(), ',', '.');
    if (text.starts_with(kMinus)) text.replace(0, kMinus.size(), "-");
    if (text.starts_with('+')) text.erase(0, 1);
    double value = 0.0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, value);
    if (error != std::errc{} || end != last || !std::isfinite(value))
        return bad_input("'" + typed + "' is not a number");
    return std::optional{value};
}

Result<CalibrationAnswers> answers_in(const CalibrationTexts& typed) {
    CalibrationAnswers answers;
    const std::pair<const std::string*, std::optional<double>*> fields[] = {
        {&typed.diameter, &answers.diameter_mm},
        {&typed.counted, &answers.counted_mm},
        {&typed.around, &answers.around_mm},
        {&typed.up, &answers.up_mm},
        {&typed.wear, &answers.wear_mm}};
    for (const auto& [text, answer] : fields) {
        const auto number = number_in(*text);
        if (!number) return number.error();
        *answer = *number;
    }
    return answers;
}

std::vector<profile::KeyChange> changes_between(const ProfileDraft& before, const ProfileDraft& after) {
    std::vector<profile::KeyChange> changes;
    const auto& keys = profile_keys();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (before.typed(i) != after.typed(i))
            changes.push_back({keys[i].path, before.typed(i), after.typed(i)});
    }
    return changes;
}

}  // namespace

CalibrationOutcome reckon(const ProfileDraft& opened, const CalibrationForm& form) {
    CalibrationOutcome outcome{opened, {}};
    for (std::size_t i = 0; i < form.size(); ++i) {
        const ProfileDraft before = outcome.draft;
        const auto answers = answers_in(form[i]);
        const auto taken = answers ? take_answers(outcome.draft, profile::kCalibrationSteps[i], *answers)
                                   : Result<void>{answers.error()};
        if (!taken) outcome.steps[i].problem = error_phrase(taken.error());
        outcome.steps[i].changes = changes_between(before, outcome.draft);
    }
    return outcome;
}

std::optional<Phrase> write_lock(const CalibrationOutcome& outcome, const MachineView& machine) {
    for (std::size_t i = 0; i < outcome.steps.size(); ++i) {
        if (outcome.steps[i].problem) return phrase("Write: step %1 cannot be", std::to_string(i + 1));
    }
    if (outcome.draft.changed_count() == 0) return phrase("Write: nothing was measured");
    if (machine.is_heard() && !is_at_rest(machine.state())) return phrase("Write: the machine moves");
    return std::nullopt;
}

std::optional<Phrase> place_lock(const MachineView& machine, const std::string& path, const Profile& on_file,
                                 Axis head) {
    if (machine.life == CoreLife::none) return phrase("No core serves the segment");
    if (!machine.is_heard() || !machine.status) return phrase("The core is silent");
    const auto place =
        profile::counted_place_mm(path, on_file, machine.core_profile_hash, *machine.status, head);
    if (place) return std::nullopt;
    return joined(phrase("Here"), error_phrase(place.error()));
}

}  // namespace psicarve::session
