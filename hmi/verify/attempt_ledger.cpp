// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/attempt_ledger.hpp"

namespace psicarve::verify {
namespace {

void add(RuleResult& all, const RuleResult& held, std::uint64_t held_before) {
    all.offences += held.offences - held_before;
    if (held.first && (!all.first || held.first->time_ns < all.first->time_ns)) all.first = held.first;
}

}  // namespace

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

void AttemptLedger::end_in_vain(const Kept& before) {
    end();
    if (before.is_holding) add(held_, before.held, before.held_before);
}

void AttemptLedger::count_held() {
    if (!is_holding_) return;
    RuleResult all = log_.result(1);
    add(all, held_, held_before_);
    log_.restore(1, all);
}

void AttemptLedger::restore(const Kept& earlier) {
    log_.restore(1, earlier.result);
    held_ = earlier.held;
    held_before_ = earlier.held_before;
    is_holding_ = earlier.is_holding;
}

}  // namespace psicarve::verify
