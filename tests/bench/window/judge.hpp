// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::context {

/// Holds what was measured against what is promised.
class Judge {
public:
    enum class Verdict : std::uint8_t {
        kept,
        disturbed,  ///< what was over its limit was so by other things than its own work
        broken,
    };

    /// `own`: the processor's time alone.
    void look(double measured, double own, double limit) noexcept {
        if (measured <= limit) return;
        const Verdict found = own <= limit ? Verdict::disturbed : Verdict::broken;
        if (found > verdict_) verdict_ = found;
    }
    Verdict verdict() const noexcept { return verdict_; }

private:
    Verdict verdict_ = Verdict::kept;
};

}  // namespace psicarve::context
