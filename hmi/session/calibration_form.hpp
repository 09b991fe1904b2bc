// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/profile/calibration_steps.hpp"
#include "hmi/session/machine_sight.hpp"

namespace psicarve::session {

/// What stands in the fields of one step, as typed; empty: not measured.
struct CalibrationTexts {
    std::string diameter;
    std::string counted;
    std::string around;
    std::string up;
    std::string wear;
};
using CalibrationForm = std::array<CalibrationTexts, profile::kCalibrationSteps.size()>;

struct StepOutcome {
    std::optional<Phrase> problem;  ///< why it cannot be
    std::vector<profile::KeyChange> changes;
};
struct CalibrationOutcome {
    profile::ProfileDraft draft;  ///< with all that is possible
    std::array<StepOutcome, profile::kCalibrationSteps.size()> steps;
};
/// What the form makes of the profile, one step after the other. A decimal comma is understood, and so is the
/// minus that the window writes.
CalibrationOutcome reckon(const profile::ProfileDraft& opened, const CalibrationForm& form);

/// What stands in the way of writing it.
std::optional<Phrase> write_lock(const CalibrationOutcome& outcome, const MachineSight& machine);
/// What stands in the way of asking the core where a head stands, by the profile in a file.
std::optional<Phrase> place_lock(const MachineSight& machine, const std::string& path, const Profile& on_file,
                                 Axis head);

}  // namespace psicarve::session
