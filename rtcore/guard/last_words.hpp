// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace psicarve::guard {

/// Writes into the segment what became of a dead core: alarm *core lost*, nothing homed, drives and spindle
/// off, if the port has taken that; the progress stays. May be called again when the port has taken it. Does
/// nothing when the segment is gone, or another core serves it by now.
void leave_last_words(const std::string& segment_name, const std::string& group, std::uint32_t core_pid,
                      bool is_port_safe);

}  // namespace psicarve::guard
