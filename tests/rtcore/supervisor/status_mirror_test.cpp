// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/status_mirror.hpp"

#include <gtest/gtest.h>

namespace psicarve::supervisor {
namespace {

TEST(StatusMirror, ShowsTheTimeLeftAsTheOverrideStretchesIt) {
    StatusMirror sut{CoreFacts{}};
    cycle::Sample sample{};
    sample.override_percent = 40;
    EXPECT_DOUBLE_EQ(sut.compose(sample, 10.0).seconds_left, 25.0);
    EXPECT_EQ(sut.compose(sample, 10.0).override_percent, 40U);
    EXPECT_LT(sut.compose(sample, -1.0).seconds_left, 0.0) << "unknown stays unknown";
    sample.override_percent = 200;
    EXPECT_DOUBLE_EQ(sut.compose(sample, 10.0).seconds_left, 10.0) << "what the motors leave is not known";
}

}  // namespace
}  // namespace psicarve::supervisor
