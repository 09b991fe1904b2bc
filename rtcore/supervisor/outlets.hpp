// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "rtcore/supervisor/core_parts.hpp"

namespace psicarve::supervisor {

/// A line on standard error, as soon as its reader takes it; the caller does not wait. Beyond some
/// hundred lines that wait they are lost.
void say_later(CoreParts& parts, std::string line);

/// What the tick has told its traces goes on to them, and what went wrong with them is said.
void move_traces(CoreParts& parts);

/// After the last tick. On the real clock a trace that is not taken any more is given up after two seconds.
void finish_traces_in_time(CoreParts& parts);
/// On the virtual clock a trace is whole: it is waited for, unless an order to end came or comes.
void finish_whole_traces(CoreParts& parts);

}  // namespace psicarve::supervisor
