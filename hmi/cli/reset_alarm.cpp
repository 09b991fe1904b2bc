// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/commands.hpp"
#include "hmi/cli/motion_command.hpp"

namespace psicarve::cli {

void add_reset_alarm(CommandSet& commands) {
    constexpr CommandText kResetAlarmText{
        "reset-alarm", "Leave the alarm once its cause is gone",
        "While a limit is still tripped it cannot be left: psicarve back-off AXIS first.",
        "psicarve reset-alarm"};
    commands.add(kResetAlarmText, [](const CommonOptions& common) {
        return motion_body(common, {CommandKind::reset_alarm, {}, {}});
    });
}

}  // namespace psicarve::cli
