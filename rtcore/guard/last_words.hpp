// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace psicarve::guard {

/// Says in the segment what became of a core that can say nothing any more: alarm *core lost*, nothing homed,
/// drives and spindle off, if the port has taken that; what it had reached stays. May be said again when the
/// port has. Does nothing when the segment is gone, or another core
/// serves it by now.
void leave_last_words(const std::string& segment_name, const std::string& group, std::uint32_t core_pid,
                      bool is_port_safe);

}  // namespace psicarve::guard
