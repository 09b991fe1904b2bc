// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_stops.hpp"

namespace psicarve::cli {

void StopFinder::take(const gcode::CanonRecord& record) {
    next_.take(record);
    if (record.kind == gcode::CanonKind::dwell) dwell_s_ += record.value;
    const bool is_tool = record.kind == gcode::CanonKind::tool_change;
    if (!is_tool && record.kind != gcode::CanonKind::stop) return;
    const bool is_optional = !is_tool && record.code == 1;
    if (is_optional && !stops_at_optional_) return;
    ++stop_count_;
    if (stops_.size() >= kMostKept) return;
    stops_.push_back({record.line, is_tool             ? "tool change"
                                   : is_optional       ? "optional"
                                   : record.code == 60 ? "pallet"
                                                       : "program"});
}

}  // namespace psicarve::cli
