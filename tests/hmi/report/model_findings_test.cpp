// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/model_findings.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/hmi/model/shapes.hpp"

namespace psicarve::report {
namespace {

/// A column on the axis and, from 4 to 8 units high on the side of +x, a block before it.
piece::PlacedModel column_behind_a_block() {
    return {std::make_shared<const model::Mesh>(shapes::Builder{}
                                                    .add(shapes::box({-2, -2, 0}, {2, 2, 10}))
                                                    .add(shapes::box({5, -0.8, 4}, {6, 0.8, 8}))
                                                    .mesh()),
            {},
            2.0,
            3.0,
            0.0};
}

TEST(ModelFindings, TellWhereTheModelHidesPartsOfItselfInDegreesAndMillimetres) {
    const auto sut = find_in_model(column_behind_a_block(), {1, {}});
    ASSERT_TRUE(sut) << sut.error().message;
    EXPECT_EQ(sut->parts.components, 2U);
    EXPECT_EQ(sut->parts.holes, 0U);
    ASSERT_EQ(sut->hidden.hidden_deg.size(), 1U);
    EXPECT_EQ(sut->hidden.hidden_deg[0].from, 350.0);
    EXPECT_EQ(sut->hidden.hidden_deg[0].to, 370.0);
    ASSERT_EQ(sut->hidden.hidden_mm.size(), 1U);
    EXPECT_NEAR(sut->hidden.hidden_mm[0].from, 3.0 + 8.0, 0.11);
    EXPECT_NEAR(sut->hidden.hidden_mm[0].to, 3.0 + 16.0, 0.11);
    EXPECT_TRUE(sut->hidden.open_deg.empty());
    EXPECT_TRUE(sut->hidden.open_mm.empty());
}

TEST(ModelFindings, CanBeCancelled) {
    const auto sut = find_in_model(column_behind_a_block(), {1, [](double) { return false; }});
    ASSERT_FALSE(sut);
    EXPECT_EQ(sut.error().code, ErrorCode::cancelled);
}

TEST(ModelFindings, CountFlawsOnceSomebodyHasCounted) {
    model::MeshFacts facts;
    EXPECT_TRUE(flaws_of(facts, nullptr).empty());
    facts.closed = false;
    facts.degenerate_count = 3;
    EXPECT_EQ(flaws_of(facts, nullptr),
              (std::vector<FlawCount>{{MeshFlaw::holes, 0}, {MeshFlaw::degenerate, 3}}));
    const model::MeshParts parts{2, 1, 1, 4};
    EXPECT_EQ(
        flaws_of(facts, &parts),
        (std::vector<FlawCount>{{MeshFlaw::holes, 4}, {MeshFlaw::inside_out, 1}, {MeshFlaw::degenerate, 3}}));
}

TEST(ModelFindings, NameTheWorstFirst) {
    const auto sut = worst_of({{0, 10, 0.1}, {20, 30, 0.3}, {40, 50, 0.2}}, 2);
    ASSERT_EQ(sut.size(), 2U);
    EXPECT_EQ(sut[0].from, 20.0);
    EXPECT_EQ(sut[1].from, 40.0);
}

TEST(ModelFindings, TellDirectionsThroughZeroAsOnATurntable) {
    EXPECT_EQ(directions_of({350.0, 370.0, 0.5}), (Directions{350.0, 10.0, true}));
    EXPECT_EQ(directions_of({350.0, 360.0, 0.5}), (Directions{350.0, 360.0, false}));
    EXPECT_EQ(directions_of({0.0, 360.0, 0.5}), (Directions{0.0, 360.0, false}));
    EXPECT_EQ(directions_of({40.0, 70.0, 0.5}), (Directions{40.0, 70.0, false}));
}

}  // namespace
}  // namespace psicarve::report
