// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/profile/calibration_steps.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// The texts in the fields of one step, as typed; empty: not measured.
struct CalibrationTexts {
    std::string diameter;
    std::string counted;
    std::string around;
    std::string up;
    std::string wear;
};
using CalibrationForm = std::array<CalibrationTexts, profile::kCalibrationSteps.size()>;

struct StepOutcome {
    std::optional<Phrase> problem;  ///< why the values are refused
    std::vector<profile::KeyChange> changes;
};
struct CalibrationOutcome {
    profile::ProfileDraft draft;  ///< with all valid values
    std::array<StepOutcome, profile::kCalibrationSteps.size()> steps;
};
/// The profile that the form makes, one step after the other. Accepts a decimal comma, and the minus sign
/// that the window writes.
CalibrationOutcome reckon(const profile::ProfileDraft& opened, const CalibrationForm& form);

/// Why it cannot be written.
std::optional<Phrase> write_lock(const CalibrationOutcome& outcome, const MachineView& machine);
/// Why the core cannot be asked for a head's position by the profile in a file.
std::optional<Phrase> place_lock(const MachineView& machine, const std::string& path, const Profile& on_file,
                                 Axis head);

}  // namespace psicarve::session
