// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/hidden_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/hmi/model/shapes.hpp"

namespace psicarve::slice {
namespace {

std::vector<double> heights() {
    return layer_heights(0.0, 10.0, 20);
}

HiddenParts parts(const model::Mesh& mesh) {
    auto found = hidden_parts(mesh, {}, heights(), {2, {}});
    EXPECT_TRUE(found.has_value());
    return found ? std::move(*found) : HiddenParts{};
}

/// A post about the axis and, from 4 to 7 high, another one beside it, in the directions 350 to 10.
model::Mesh two_posts() {
    return shapes::Builder()
        .add(shapes::box({-2, -2, 0}, {2, 2, 10}))
        .add(shapes::box({5, -0.88, 4}, {6, 0.88, 7}))
        .mesh();
}

TEST(HiddenParts, AreNoneOfABodyThatIsSeenAllRound) {
    const HiddenParts sut = parts(shapes::box({-3, -2, 0}, {3, 2, 10}));
    ASSERT_EQ(sut.sectors.size(), 36U);
    for (const WallCount& sector : sut.sectors) {
        EXPECT_EQ(sector.walls, 200U);
        EXPECT_EQ(sector.hidden + sector.open, 0U);
    }
    EXPECT_TRUE(HiddenParts::runs(sut.layers, &WallCount::hidden_share, 0.01, false).empty());
}

TEST(HiddenParts, AreFoundByDirectionAndHeight) {
    const HiddenParts sut = parts(two_posts());
    // Each ray there meets the outer post's two walls and one of the inner.
    const auto round = HiddenParts::runs(sut.sectors, &WallCount::hidden_share, 0.01, true);
    ASSERT_EQ(round.size(), 1U);
    EXPECT_EQ(round[0].begin, 35U);
    EXPECT_EQ(round[0].end, 37U);
    // In 6 of 20 layers 2 of 3 walls, else none of 1.
    EXPECT_NEAR(round[0].share, 6 * 2 / (6 * 3 + 14 * 1.0), 0.02);
    const auto up = HiddenParts::runs(sut.layers, &WallCount::hidden_share, 0.01, false);
    ASSERT_EQ(up.size(), 1U);
    EXPECT_EQ(up[0].begin, 8U);
    EXPECT_EQ(up[0].end, 14U);
}

TEST(HiddenParts, TellWhereAMeshIsOpen) {
    model::Mesh open = shapes::box({-2, -2, 0}, {2, 2, 10});
    // The wall at x = 2 goes: directions 315 to 45.
    std::erase_if(open.triangles, [](const model::Triangle& facet) {
        return std::all_of(facet.vertices.begin(), facet.vertices.end(),
                           [](const auto& vertex) { return vertex[0] == 2.0F; });
    });
    const HiddenParts sut = parts(open);
    const auto round = HiddenParts::runs(sut.sectors, &WallCount::open_share, 0.0, true);
    ASSERT_EQ(round.size(), 1U);
    EXPECT_EQ(round[0].begin, 31U);
    EXPECT_EQ(round[0].end, 36U + 5U);
    EXPECT_EQ(HiddenParts::runs(sut.layers, &WallCount::open_share, 0.0, false).size(), 1U);
}

TEST(HiddenParts, RunAllRoundOnce) {
    const std::vector<WallCount> all(4, {10, 5, 10, 0});
    const auto round = HiddenParts::runs(all, &WallCount::hidden_share, 0.1, true);
    ASSERT_EQ(round.size(), 1U);
    EXPECT_EQ(round[0].end - round[0].begin, 4U);
}

}  // namespace
}  // namespace psicarve::slice
