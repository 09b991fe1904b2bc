// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "hmi/verify/offence_log.hpp"

namespace psicarve::verify {

/// Which attempts' breaches of rule 1 count. Those of attempts that have ended are held back from the log: of
/// the last that began anew, and of all that went on from it. Where nothing follows they count; one that
/// begins anew drops them.
class AttemptLedger {
public:
    /// The log outlives it.
    explicit AttemptLedger(OffenceLog& log) noexcept : log_(log) {}

    /// Of attempts that have ended.
    struct Held {
        std::uint64_t offences = 0;
        std::optional<Offence> first;
    };
    /// Log and what is held at some instant.
    struct Kept {
        RuleResult result;
        Held held;
    };

    void begin_anew();
    /// What the attempts before did wrong counts, too.
    void go_on();
    /// Takes the attempt's breaches out of the log.
    void end();
    /// The same of an attempt that began anew and carved nothing: what those before it did wrong is held with
    /// its own.
    void end_in_vain(const Kept& before);
    /// Nothing follows the last attempt.
    void count_held();

    Kept kept() const { return {log_.result(1), held_}; }
    void restore(const Kept& earlier);

private:
    OffenceLog& log_;
    RuleResult at_begin_;  ///< of the attempt
    Held held_;
};

}  // namespace psicarve::verify
