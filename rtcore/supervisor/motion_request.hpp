// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/command.hpp"
#include "shared/message/message.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

/// A command as the tick's request, in pulses and ticks; whatever a sender wrote that makes no sense is
/// refused by its error's message. Soft limits are the tick's to judge: only it knows where the axes stand.
Result<cycle::Request> motion_request(const Command& command, cycle::RequestKind kind, const Profile& profile,
                                      bool is_virtual_clock);

/// What is to be said of a jog that is done: a speed that its axes do not have; mostly none.
Message speed_remark(const Command& command, const Profile& profile);

}  // namespace psicarve::supervisor
