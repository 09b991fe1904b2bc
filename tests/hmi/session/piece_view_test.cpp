// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/piece_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "hmi/scene/colour_map.hpp"

namespace psicarve::session {
namespace {

constexpr std::size_t kPieceRows = 6;
constexpr std::size_t kPieceRound = 16;
constexpr double kPulse_mm = 0.01;
constexpr std::uint32_t kNeutral = 0x123456;
constexpr std::uint32_t kUncut = 0x654321;

PieceScenePlan fine_plan() {
    PieceScenePlan plan;
    plan.neutral_rgb = kNeutral;
    plan.blank_rgb = kUncut;
    return plan;
}

/// A blank of 10 mm; rows 1 to 4 are carved to 8 mm.
piece::JobPiece carved_piece() {
    piece::JobPiece piece{piece::StockMap{10.0, 0.0, 0.5, kPieceRows, kPieceRound}, {1, 2, 3, 4}, {}};
    for (const std::size_t row : piece.rows) std::ranges::fill(piece.piece.row(row), 8.0F);
    return piece;
}

piece::JobPiece compared_piece() {
    piece::JobPiece piece = carved_piece();
    piece.deviation.emplace();
    piece.deviation->column_count = kPieceRound;
    piece.deviation->distance_mm.assign(piece.rows.size() * kPieceRound, 0.0F);
    piece.deviation->place_count = piece.deviation->distance_mm.size();
    return piece;
}

float& distance_at(piece::JobPiece& piece, std::size_t carved_row, std::size_t column) {
    return piece.deviation->distance_mm[carved_row * kPieceRound + column];
}

std::vector<std::string> english_of(const PieceView& seen) {
    std::vector<std::string> lines;
    for (const Phrase& line : piece_lines(seen)) lines.push_back(in_english(line));
    return lines;
}

TEST(PieceView, IsBlueWhereItIsTooDeepBrownWhereMaterialIsLeftAndNeutralWithinAPulse) {
    piece::JobPiece piece = compared_piece();
    distance_at(piece, 0, 3) = 0.04F;
    distance_at(piece, 1, 5) = -0.04F;
    distance_at(piece, 2, 7) = 0.01F;
    const PieceView sut = look_at_piece(piece, kPulse_mm, fine_plan());
    EXPECT_DOUBLE_EQ(sut.reach_mm, 8.0 * kPulse_mm) << "never finer than eight pulses";
    const MeshScene& scene = *sut.scene;
    ASSERT_EQ(scene.vertex_rgb.size(), kPieceRows * kPieceRound + 1);
    EXPECT_EQ(scene.vertex_rgb[0], kUncut) << "below the first layer stands the blank";
    EXPECT_EQ(scene.vertex_rgb[1 * kPieceRound], kNeutral);
    EXPECT_EQ(scene.vertex_rgb[1 * kPieceRound + 3], vik(0.75));
    EXPECT_EQ(scene.vertex_rgb[2 * kPieceRound + 5], vik(0.25));
    EXPECT_EQ(scene.vertex_rgb[3 * kPieceRound + 7], kNeutral) << "a pulse is as near as it gets";
    EXPECT_EQ(scene.vertex_rgb[5 * kPieceRound], kUncut);
    EXPECT_NEAR(sut.within_pulse_share, 1.0 - 2.0 / (4.0 * kPieceRound), 1e-12);
    EXPECT_TRUE(sut.has_model);
    EXPECT_TRUE(sut.deviation->distance_mm.empty()) << "the scene has them";
}

TEST(PieceView, StandsInTheMiddleOfItsBlankAsHighAsThat) {
    const PieceView sut = look_at_piece(carved_piece(), kPulse_mm, fine_plan());
    const MeshScene& scene = *sut.scene;
    EXPECT_EQ(scene.size, (std::array<double, 3>{20.0, 20.0, 3.0}));
    EXPECT_NEAR(scene.vertices[0][0], 10.0, 1e-6);
    EXPECT_NEAR(scene.vertices[0][2], -1.25, 1e-6);
    EXPECT_NEAR(scene.vertices[1 * kPieceRound + 4][1], 8.0, 1e-5);
    EXPECT_NEAR(scene.vertices.back()[2], 1.25, 1e-6);
    EXPECT_EQ(scene.facets.size(), 2 * (kPieceRows - 1) * kPieceRound + kPieceRound);
    EXPECT_LT(scene.coarse_facets.size(), scene.facets.size());
    EXPECT_FALSE(scene.coarse_facets.empty());
}

TEST(PieceView, LosesNoBadCellWhereItIsDrawnCoarser) {
    piece::JobPiece piece = compared_piece();
    distance_at(piece, 1, 1) = -0.08F;
    PieceScenePlan plan = fine_plan();
    plan.most_round = kPieceRound / 2;
    plan.most_up = kPieceRows / 2;
    const PieceView sut = look_at_piece(piece, kPulse_mm, plan);
    ASSERT_EQ(sut.scene->vertex_rgb.size(), kPieceRows / 2 * kPieceRound / 2 + 1);
    EXPECT_EQ(std::ranges::count(sut.scene->vertex_rgb, vik(0.0)), 1);
}

TEST(PieceView, IsColouredAsFarAsAllButAFewPlacesGo) {
    piece::JobPiece piece = compared_piece();
    std::ranges::fill(piece.deviation->distance_mm, 0.3141F);
    distance_at(piece, 1, 1) = 9.0F;
    piece.deviation->distance_mm.resize(1000, 0.3141F);
    const PieceView sut = look_at_piece(piece, kPulse_mm, fine_plan());
    EXPECT_NEAR(sut.reach_mm, 0.32, 1e-9);
}

TEST(PieceView, TellsItsFacts) {
    piece::JobPiece piece = compared_piece();
    distance_at(piece, 0, 0) = 0.5F;
    PieceView sut = look_at_piece(piece, kPulse_mm, fine_plan());
    EXPECT_EQ(english_of(sut)[0], "Nowhere too deep");
    sut.deviation->gouge = {0.0123, 0.001, 123.44, 4.5};
    sut.deviation->leftover = {1.25, 0.0345, 359.9, 10.0};
    EXPECT_EQ(english_of(sut),
              (std::vector<std::string>{
                  "Too deep by 0.012 mm at most, at 123.4°, 4.50 mm high",
                  "Left over 1.250 mm at most, at 359.9°, 10.00 mm high; 0.0345 mm on average",
                  "Within a pulse 98.4 % of the surface, removed 0.2 cm³"}));
    sut.draft_allowance_mm = 0.05;
    EXPECT_EQ(english_of(sut).front(), "Draft, of samples of the model: tips are kept 0.050 mm further out");
    for (const std::string& line : english_of(sut))
        EXPECT_EQ(line.find("too deep"), std::string::npos) << "of the samples, not of the job: " << line;
}

TEST(PieceView, WithoutAModelIsColouredByRadiusAndSaysThatItIsNotCompared) {
    piece::JobPiece piece = carved_piece();
    piece.piece.row(2)[3] = 6.5F;
    const PieceView sut = look_at_piece(piece, kPulse_mm, fine_plan());
    EXPECT_FALSE(sut.has_model);
    EXPECT_EQ(sut.least_mm, 6.0);
    EXPECT_EQ(sut.most_mm, 8.0);
    EXPECT_EQ(sut.scene->vertex_rgb[1 * kPieceRound], viridis(1.0));
    EXPECT_EQ(sut.scene->vertex_rgb[2 * kPieceRound + 3], viridis(0.25));
    EXPECT_EQ(english_of(sut)[0], "Opened without its model: there is nothing to compare the piece with");
    EXPECT_GT(sut.removed_mm3, 200.0);
}

// A point cuts nothing between two of its layers.
TEST(PieceView, LeavesOutRowsBetweenTheLayersOfAPoint) {
    piece::JobPiece piece = compared_piece();
    piece.rows = {1, 4};
    piece.deviation->distance_mm.resize(2 * kPieceRound);
    const PieceView sut = look_at_piece(piece, kPulse_mm, fine_plan());
    EXPECT_EQ(sut.scene->vertex_rgb.size(), 4 * kPieceRound + 1);
    EXPECT_EQ(std::ranges::count(sut.scene->vertex_rgb, kUncut), 2 * kPieceRound + 1);
}

TEST(PieceView, OfAJobWhoseLayersLieOutsideTheBlankIsTheBlank) {
    piece::JobPiece piece{piece::StockMap{10.0, 0.0, 0.5, kPieceRows, kPieceRound}, {}, {}};
    const PieceView sut = look_at_piece(piece, kPulse_mm, fine_plan());
    EXPECT_EQ(std::ranges::count(sut.scene->vertex_rgb, kUncut), kPieceRows * kPieceRound + 1);
    EXPECT_LT(sut.least_mm, sut.most_mm);
}

TEST(PieceChoice, IsTheJobsElseADraftWhereOneTellsAnything) {
    EXPECT_EQ(piece_choice(true, true, true, ToolShape::point).source, PieceSource::job);
    EXPECT_EQ(piece_choice(true, false, false, ToolShape::ball).source, PieceSource::job);
    EXPECT_EQ(piece_choice(false, true, false, ToolShape::ball).source, PieceSource::draft);
    for (const PieceChoice& sut : {piece_choice(false, false, false, ToolShape::ball),
                                   piece_choice(false, true, true, ToolShape::ball),
                                   piece_choice(false, true, false, ToolShape::point)}) {
        EXPECT_EQ(sut.source, PieceSource::none);
        EXPECT_FALSE(sut.reason.is_empty());
    }
}

}  // namespace
}  // namespace psicarve::session
