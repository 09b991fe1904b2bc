// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hmi/profile/profile_draft.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::profile {

// What the terminal's and the window's calibration have in common.

/// In the order in which they are asked: later ones rely on earlier ones.
enum class CalibrationStep : std::uint8_t { touch_off_r1, touch_off_r2, two_marks, wear_r1, wear_r2 };
inline constexpr std::array kCalibrationSteps{CalibrationStep::touch_off_r1, CalibrationStep::touch_off_r2,
                                              CalibrationStep::two_marks, CalibrationStep::wear_r1,
                                              CalibrationStep::wear_r2};

/// The head that a step measures; two_marks: R2, which is set by R1.
constexpr Axis head_of(CalibrationStep step) noexcept {
    return step == CalibrationStep::touch_off_r1 || step == CalibrationStep::wear_r1 ? Axis::r1 : Axis::r2;
}

/// The measurements that a step asks for; nothing: no answer.
struct CalibrationAnswers {
    std::optional<double> diameter_mm;  ///< of the pin, or of the blank with the two marks
    std::optional<double> counted_mm;   ///< touch-off: where the head is counted to stand
    std::optional<double> around_mm;    ///< two marks, as for two_marks()
    std::optional<double> up_mm;
    std::optional<double> wear_mm;
};

/// Puts the measurements into the draft; a step without answers leaves it. Errors: bad_input when an answer
/// is missing or impossible; the draft stays as it is.
Result<void> take_answers(ProfileDraft& draft, CalibrationStep step, const CalibrationAnswers& answers);

/// The position at which a core counts a head [mm], by the profile in a file. Requires a core that uses this
/// very profile and is homed and at rest. Errors: machine_refused.
Result<double> counted_place_mm(const std::string& path, const Profile& on_file,
                                std::uint64_t core_profile_hash, const CoreStatus& status, Axis head);

struct KeyChange {
    std::string key;
    std::string from;
    std::string to;
};
/// What the draft changes, in the order of the keys.
std::vector<KeyChange> changes_of(const ProfileDraft& draft);
/// "axis.r1.tip_offset_mm: 0.0 -> 0.125", a line for each of them; empty: none.
std::string changes_text(const ProfileDraft& draft);

}  // namespace psicarve::profile
