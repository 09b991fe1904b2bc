// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/attempt_ledger.hpp"

namespace psicarve::verify {
namespace {

void keep_earlier(std::optional<Offence>& first, const std::optional<Offence>& other) {
    if (other && (!first || other->time_ns < first->time_ns)) first = other;
}

}  // namespace

void AttemptLedger::begin_anew() {
    held_ = {};
    go_on();
}

void AttemptLedger::go_on() {
    at_begin_ = log_.result(1);
}

void AttemptLedger::end() {
    const RuleResult now = log_.result(1);
    held_.offences += now.offences - at_begin_.offences;
    keep_earlier(held_.first, now.first);
    log_.restore(1, at_begin_);
}

void AttemptLedger::end_in_vain(const Kept& before) {
    held_ = before.held;
    end();
}

void AttemptLedger::count_held() {
    RuleResult all = log_.result(1);
    all.offences += held_.offences;
    keep_earlier(all.first, held_.first);
    log_.restore(1, all);
}

void AttemptLedger::restore(const Kept& earlier) {
    log_.restore(1, earlier.result);
    held_ = earlier.held;
}

}  // namespace psicarve::verify
