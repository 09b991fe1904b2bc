// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/base/nearest.hpp"

#include <gtest/gtest.h>

namespace psicarve {
namespace {

TEST(EditDistance, CountsEachKindOfMistakeOnce) {
    EXPECT_EQ(edit_distance("layers", "layers"), 0U);
    EXPECT_EQ(edit_distance("layer", "layers"), 1U);
    EXPECT_EQ(edit_distance("layyers", "layers"), 1U);
    EXPECT_EQ(edit_distance("lauers", "layers"), 1U);
    EXPECT_EQ(edit_distance("alyers", "layers"), 1U);
    EXPECT_EQ(edit_distance("", "layers"), 6U);
    EXPECT_EQ(edit_distance("layers", ""), 6U);
}

TEST(Nearest, FindsWhatWasMeant) {
    const std::vector<std::string> names{"slice", "status", "start", "stop", "carve"};
    EXPECT_EQ(nearest("slcie", names), "slice");
    EXPECT_EQ(nearest("stauts", names), "status");
    EXPECT_EQ(nearest("sta", {"status"}), "status");
}

TEST(Nearest, FindsNothingWhenNothingIsNear) {
    EXPECT_EQ(nearest("frobnicate", {"slice", "status"}), std::nullopt);
    EXPECT_EQ(nearest("x", {}), std::nullopt);
}

}  // namespace
}  // namespace psicarve
