// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_ready.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "hmi/cli/job_source.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/gcode/axis_letters.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {

Result<Profile> profile_of_core(const machine::MachineLink& link, const CommonOptions& common) {
    auto profile = chosen_profile(common);
    if (!profile) return profile;
    if (link.segment().header().core_profile_hash.load() == profile_hash(*profile)) return profile;
    const std::string path = chosen_profile_path(common);
    return Error{ErrorCode::machine_refused, "the core has another profile than " +
                                                 (path.empty() ? "the built-in one" : path) +
                                                 "; name the one that it was started with: --profile FILE"};
}

Result<void> require_ready(const CoreStatus& status) {
    if (status.state == MachineState::ready) return {};
    if (status.state == MachineState::off)
        return error_from(ErrorCode::machine_refused, message_of(MessageId::not_homed));
    if (status.state == MachineState::alarm) return machine::alarm_error(status);
    return error_from(ErrorCode::machine_refused,
                      message_of(MessageId::busy_for_a_job, argument_of(status.state)));
}

Result<void> require_heads_alike(const Profile& profile, const CoreStatus& status) {
    const gcode::AxisLetters letters{profile.gcode};
    if (letters.letter_of(Axis::r1) != letters.letter_of(Axis::r2)) return {};
    const auto place = [&](Axis axis) {
        return static_cast<double>(status.position_pulses[index_of(axis)]) /
               axis_motion(profile, axis).pulses_per_unit;
    };
    const double pulse_mm = 1.0 / std::min(axis_motion(profile, Axis::r1).pulses_per_unit,
                                           axis_motion(profile, Axis::r2).pulses_per_unit);
    if (std::abs(place(Axis::r1) - place(Axis::r2)) <= pulse_mm) return {};
    return Error{
        ErrorCode::machine_refused,
        "r2 follows r1 (profile: gcode.second_head), and they stand at different radii; bring them to "
        "one radius: psicarve move"};
}

}  // namespace psicarve::cli
