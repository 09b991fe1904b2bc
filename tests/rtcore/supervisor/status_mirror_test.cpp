// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/status_mirror.hpp"

#include <gtest/gtest.h>

namespace psicarve::supervisor {
namespace {

TEST(StatusMirror, ShowsTheTimeLeftAsTheOverrideStretchesIt) {
    EXPECT_DOUBLE_EQ(10.0 * stretch_of(40), 25.0);
    EXPECT_DOUBLE_EQ(10.0 * stretch_of(100), 10.0);
    EXPECT_DOUBLE_EQ(10.0 * stretch_of(200), 10.0) << "what the motors leave is not known";
}

}  // namespace
}  // namespace psicarve::supervisor
