// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cli/command_set.hpp"

namespace psicarve::cli {

// One file each, named like the command.
void add_back_off(CommandSet& commands);
void add_calibrate(CommandSet& commands);
void add_carve(CommandSet& commands);
void add_completion(CommandSet& commands);
void add_doctor(CommandSet& commands);
void add_drives_off(CommandSet& commands);
void add_estimate(CommandSet& commands);
void add_estop(CommandSet& commands);
void add_forget(CommandSet& commands);
void add_gcode_check(CommandSet& commands);
void add_gcode_estimate(CommandSet& commands);
void add_gcode_offsets(CommandSet& commands);
void add_gcode_run(CommandSet& commands);
void add_hold(CommandSet& commands);
void add_home(CommandSet& commands);
void add_inspect(CommandSet& commands);
void add_jog(CommandSet& commands);
void add_latency(CommandSet& commands);
void add_log(CommandSet& commands);
void add_move(CommandSet& commands);
void add_override(CommandSet& commands);
void add_pins(CommandSet& commands);
void add_profile_check(CommandSet& commands);
void add_profile_diff(CommandSet& commands);
void add_profile_path(CommandSet& commands);
void add_profile_set(CommandSet& commands);
void add_profile_show(CommandSet& commands);
void add_publish(CommandSet& commands);
void add_replay(CommandSet& commands);
void add_reset_alarm(CommandSet& commands);
void add_reset_height(CommandSet& commands);
void add_resume(CommandSet& commands);
void add_slice(CommandSet& commands);
void add_snapshot_diff(CommandSet& commands);
void add_snapshot_export(CommandSet& commands);
void add_snapshot_info(CommandSet& commands);
void add_snapshot_save(CommandSet& commands);
void add_single(CommandSet& commands);
void add_optional_stop(CommandSet& commands);
void add_spindle(CommandSet& commands);
void add_start(CommandSet& commands);
void add_start_interpolation(CommandSet& commands);
void add_status(CommandSet& commands);
void add_stop(CommandSet& commands);
void add_verify(CommandSet& commands);

}  // namespace psicarve::cli
