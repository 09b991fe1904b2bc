// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "hmi/verify/verifier.hpp"
#include "tests/hmi/verify/perfect_machine.hpp"

namespace psicarve::verify {

inline VerifyReport verified(const SampleJob& job, const PerfectMachine& machine,
                             const LayerRange& layers = {}) {
    auto sut = Verifier::make(job.view(), job.profile, layers);
    EXPECT_TRUE(sut) << (sut ? "" : sut.error().message);
    EXPECT_TRUE(sut->begin(machine.start).has_value());
    sut->feed(machine.events);
    return sut->finish();
}

inline const Offence& first_of(const VerifyReport& report, int rule) {
    const auto& first = report.rules[static_cast<std::size_t>(rule) - 1].first;
    static const Offence kNone;
    EXPECT_TRUE(first) << "rule " << rule << " found nothing";
    return first ? *first : kNone;
}

}  // namespace psicarve::verify
