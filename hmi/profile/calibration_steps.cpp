// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/calibration_steps.hpp"

#include "hmi/profile/calibration.hpp"
#include "shared/base/units.hpp"

namespace psicarve::profile {
namespace {

Result<void> take_touch_off(ProfileDraft& draft, Axis head, const CalibrationAnswers& answers) {
    if (!answers.diameter_mm && !answers.counted_mm) return {};
    if (!answers.diameter_mm) return bad_input("the diameter of the pin is needed");
    if (!answers.counted_mm) {
        return bad_input("where " + std::string{name_of(head)} + " stands is needed");
    }
    return touch_off(draft, head, *answers.diameter_mm, *answers.counted_mm);
}

Result<void> take_marks(ProfileDraft& draft, const CalibrationAnswers& answers) {
    if (!answers.diameter_mm && !answers.around_mm && !answers.up_mm) return {};
    if (!answers.diameter_mm) return bad_input("the diameter of the blank is needed");
    if (!answers.around_mm || !answers.up_mm) return bad_input("both ways between the marks are needed");
    return two_marks(draft, *answers.diameter_mm, *answers.around_mm, *answers.up_mm);
}

}  // namespace

Result<void> take_answers(ProfileDraft& draft, CalibrationStep step, const CalibrationAnswers& answers) {
    switch (step) {
        case CalibrationStep::touch_off_r1:
        case CalibrationStep::touch_off_r2:
            return take_touch_off(draft, head_of(step), answers);
        case CalibrationStep::two_marks:
            return take_marks(draft, answers);
        case CalibrationStep::wear_r1:
        case CalibrationStep::wear_r2:
            break;
    }
    if (!answers.wear_mm) return {};
    return tool_wear(draft, head_of(step), *answers.wear_mm);
}

Result<double> counted_place_mm(const std::string& path, const Profile& on_file,
                                std::uint64_t core_profile_hash, const CoreStatus& status, Axis head) {
    const auto refused = [](const std::string& text) { return Error{ErrorCode::machine_refused, text}; };
    if (core_profile_hash != profile_hash(on_file))
        return refused("the core runs with another profile than " + path + "; start it with that one");
    if (status.state != MachineState::ready) {
        return refused("the machine is " + std::string{name_of(status.state)} + "; home it, jog " +
                       std::string{name_of(head)} + " to the pin, and let it rest");
    }
    return mm_from_pulses(status.position_pulses[index_of(head)], axis_motion(on_file, head).pulses_per_unit);
}

std::vector<KeyChange> changes_of(const ProfileDraft& draft) {
    std::vector<KeyChange> changes;
    const auto& keys = profile_keys();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (draft.is_changed(i)) changes.push_back({keys[i].path, draft.saved(i), draft.typed(i)});
    }
    return changes;
}

std::string changes_text(const ProfileDraft& draft) {
    std::string text;
    for (const KeyChange& change : changes_of(draft))
        text += change.key + ": " + change.from + " -> " + change.to + "\n";
    return text;
}

}  // namespace psicarve::profile
