// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/attempt_ledger.hpp"

namespace psicarve::verify {

void AttemptLedger::begin_anew() {
    at_begin_ = log_.result(1);
    is_holding_ = false;
}

void AttemptLedger::go_on() {
    count_held();
    begin_anew();
}

void AttemptLedger::end() {
    held_ = log_.result(1);
    held_before_ = at_begin_.offences;
    is_holding_ = true;
    log_.restore(1, at_begin_);
}

void AttemptLedger::count_held() {
    if (!is_holding_) return;
    RuleResult all = log_.result(1);
    all.offences += held_.offences - held_before_;
    if (held_.first && (!all.first || held_.first->time_ns < all.first->time_ns)) all.first = held_.first;
    log_.restore(1, all);
}

void AttemptLedger::restore(const Kept& earlier) {
    log_.restore(1, earlier.result);
    held_ = earlier.held;
    held_before_ = earlier.held_before;
    is_holding_ = earlier.is_holding;
}

}  // namespace psicarve::verify
