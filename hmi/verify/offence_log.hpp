// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "hmi/verify/verify_report.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::verify {

/// The place that the carving has reached, for messages.
struct CarvePlace {
    std::optional<std::uint32_t> layer;
    std::optional<std::uint32_t> point;
    const JobPass* pass = nullptr;      ///< if the job has several
    std::optional<std::uint64_t> line;  ///< of a program
};

/// Counts breaches and keeps the earliest of each rule. Counting is cheap; only a breach that is kept gets
/// words.
class OffenceLog {
public:
    /// Counts one. True when it is the rule's earliest so far: then call describe.
    bool count(int rule, std::int64_t time_ns) noexcept {
        RuleResult& result = rules_[static_cast<std::size_t>(rule) - 1];
        ++result.offences;
        return !result.first || time_ns < result.first->time_ns;
    }
    /// Completes the sentence with the place and time, and keeps it.
    void describe(Offence offence, const CarvePlace& place);

    void set_judged(int rule) noexcept { rules_[static_cast<std::size_t>(rule) - 1].judged = true; }
    const RuleResult& result(int rule) const noexcept { return rules_[static_cast<std::size_t>(rule) - 1]; }
    /// Puts back a rule's earlier result: an attempt at carving does not count.
    void restore(int rule, const RuleResult& earlier) {
        rules_[static_cast<std::size_t>(rule) - 1] = earlier;
    }
    const std::array<RuleResult, kRuleCount>& rules() const noexcept { return rules_; }

private:
    std::array<RuleResult, kRuleCount> rules_;
};

/// "r1" as shown to people: "R1", "psi", "Y".
std::string shown_name(Axis axis);
/// A number without needless digits.
std::string shown_number(double value);

}  // namespace psicarve::verify
