// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/modes_teller.hpp"

#include <array>
#include <bit>
#include <cstdint>

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
    using Words = std::array<std::uint64_t, sizeof now / sizeof(std::uint64_t)>;
    if (has_told_ && std::bit_cast<Words>(now) == std::bit_cast<Words>(told_)) return;
    writer_.tell(now);
    told_ = now;
    has_told_ = true;
}

}  // namespace psicarve::cli
