// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/verify/offence_log.hpp"

namespace psicarve::verify {

/// Which attempts' breaches of rule 1 count: an attempt that has ended is held back from the log until
/// another goes on from it, or nothing follows; one that begins anew drops it.
class AttemptLedger {
public:
    /// The log outlives it.
    explicit AttemptLedger(OffenceLog& log) noexcept : log_(log) {}

    void begin_anew();
    /// What the last attempt did wrong counts, too.
    void go_on();
    /// Takes the attempt's breaches out of the log.
    void end();
    /// Nothing follows the last attempt.
    void count_held();

    /// Log and what is held at some instant.
    struct Kept {
        RuleResult result;
        RuleResult held;
        std::uint64_t held_before = 0;
        bool is_holding = false;
    };
    Kept kept() const { return {log_.result(1), held_, held_before_, is_holding_}; }
    void restore(const Kept& earlier);

private:
    OffenceLog& log_;
    RuleResult at_begin_;            ///< of the attempt
    RuleResult held_;                ///< of the last attempt, which has ended
    std::uint64_t held_before_ = 0;  ///< offences before that attempt
    bool is_holding_ = false;
};

}  // namespace psicarve::verify
