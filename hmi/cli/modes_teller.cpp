// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/modes_teller.hpp"

#include <cstring>

namespace psicarve::cli {
namespace {

/// Nothing is better than what held elsewhere.
ProgramModes unknown_modes() noexcept {
    ProgramModes none{};
    none.g_codes.fill(-1);
    none.m_codes.fill(-1);
    return none;
}

}  // namespace

void ModesTeller::follow(const ProgramReport& report) {
    // Until it runs the status is that of the program before.
    const bool is_ours = report.status.program == writer_.program();
    auto known = trail_.at(is_ours ? report.status.sequence : 0);
    // Of a way that the trail has forgotten.
    if (known && is_ours && known->line == 0) known->line = report.status.line;
    const ProgramModes now = known.value_or(unknown_modes());
    if (has_told_ && std::memcmp(&now, &told_, sizeof now) == 0) return;
    writer_.tell(now);
    told_ = now;
    has_told_ = true;
}

}  // namespace psicarve::cli
