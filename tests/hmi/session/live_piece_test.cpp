// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/live_piece.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <thread>

#include "hmi/piece/expected_piece.hpp"
#include "hmi/scene/stock_scene.hpp"
#include "shared/base/units.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::session {
namespace {

constexpr std::uint32_t kPieceLayers = 60;
constexpr std::uint32_t kPiecePoints = 61;
// The reference takes so many steps between two points. LivePiece's own thread has no part in that.
const int kTruthParts = test::kIsThreadSanitized && !test::is_long_run() ? 20 : 60;

/// A job whose heads go once round, layer by layer, told as a core on the real clock tells it.
class LivePieces : public ::testing::Test {
protected:
    LivePieces() {
        profile_.tool = {ToolShape::ball, 3.0};
        profile_.r2.tip_offset_mm = 0.4;
        profile_.head_r2_angle_error_deg = 1.5;
        make();
    }
    void make(std::uint32_t layers = kPieceLayers) {
        auto made = cam::prepare_blob(
            job_blob_from_table(two_process::lobed_job(layers, kPiecePoints, profile_)), profile_, "lobed");
        ASSERT_TRUE(made) << made.error().message;
        job_ = std::make_shared<const cam::PreparedJob>(std::move(*made));
        auto record = CarvingRecord::make(job_);
        ASSERT_TRUE(record);
        record_ = std::move(*record);
        sut_ = std::make_unique<LivePiece>(job_, record_->geometry());
    }
    const verify::JobGeometry& geometry() const { return record_->geometry(); }
    /// Every so many parts of the way between two points.
    template <typename Take>
    void go_layer(std::uint32_t layer, int parts, const Take& take) const {
        for (std::uint32_t step = 0; step + 1 < kPiecePoints; ++step) {
            const auto from = geometry().target(layer, step);
            const auto to = geometry().target(layer, step + 1);
            for (int part = 0; part <= parts; ++part) {
                verify::Positions at{};
                for (std::size_t axis = 0; axis < kAxisCount; ++axis)
                    at[axis] = from[axis] + (to[axis] - from[axis]) * part / parts;
                take(at);
            }
        }
    }
    void tell_layer(std::uint32_t layer, int parts = 7) {
        go_layer(layer, parts, [this](const verify::Positions& at) {
            const IncrementEntry entry{0, static_cast<std::int32_t>(at[0]), static_cast<std::int32_t>(at[1]),
                                       at[2], at[3]};
            record_->take(entry);
            sut_->take(entry);
        });
    }
    void look(std::uint32_t layers, bool has_lost = false) {
        sut_->look({std::uint64_t{layers} * kPiecePoints, has_lost});
    }
    void carve(std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t layer = first; layer < end; ++layer) {
            tell_layer(layer);
            look(layer + 1);
        }
    }
    /// Whether the end leaves uncut what is left. Of several tries: where the computer is busy with something
    /// else, the lane may be through before the end comes.
    template <typename Begin>
    bool ends_in_the_middle(const Begin& begin, std::size_t columns = piece::kViewColumns) {
        sut_ = std::make_unique<LivePiece>(job_, geometry(), columns);
        begin();
        sut_->finish();
        const std::size_t all = sut_->places_cut()->load();
        EXPECT_GT(all, 100U);
        for (int attempt = 0; attempt < 40; ++attempt) {
            sut_ = std::make_unique<LivePiece>(job_, geometry(), columns);
            const auto places = sut_->places_cut();
            begin();
            while (places->load() == 0) std::this_thread::yield();
            sut_.reset();
            if (places->load() < all) return true;
        }
        return false;
    }
    const piece::StockMap& shown() {
        sut_->finish();
        sut_->front().take_changed_rows();
        return sut_->front().shown();
    }
    /// What the piece's own code makes of every place that the axes came through.
    piece::StockMap truth(std::uint32_t first, std::uint32_t end) const {
        piece::StockMap stock = piece::view_blank_of(geometry(), profile_, piece::kViewColumns);
        piece::PieceCarver carver(geometry(), profile_, stock);
        for (std::uint32_t layer = first; layer < end; ++layer) {
            go_layer(layer, kTruthParts, [&](const verify::Positions& at) { carver.settle(at, true); });
            carver.settle({}, false);
        }
        carver.finish();
        return stock;
    }
    /// How much the cells differ: at most, and on average over all cells [of a cell's height].
    struct Apart {
        double most = 0.0;
        double mean = 0.0;
    };
    static Apart apart(const piece::StockMap& a, const piece::StockMap& b) {
        EXPECT_EQ(a.row_count(), b.row_count());
        Apart apart;
        for (std::size_t row = 0; row < a.row_count(); ++row) {
            for (std::size_t column = 0; column < a.column_count(); ++column) {
                const double off = std::abs(a.row(row)[column] - b.row(row)[column]) / a.row_mm();
                apart.most = std::max(apart.most, off);
                apart.mean += off / static_cast<double>(a.row_count() * a.column_count());
            }
        }
        return apart;
    }
    void expect_same(const piece::StockMap& a, const piece::StockMap& b) {
        const Apart off = apart(a, b);
        EXPECT_LT(off.most, 0.5);
        EXPECT_LT(off.mean, 0.03);
        EXPECT_GT(a.removed_mm3(), 0.0);
    }

    Profile profile_;
    std::shared_ptr<const cam::PreparedJob> job_;
    std::unique_ptr<CarvingRecord> record_;
    std::unique_ptr<LivePiece> sut_;
};

TEST_F(LivePieces, LeaveWhatThePiecesOwnCodeLeavesOfEveryTool) {
    const ToolProfile tools[] = {{ToolShape::ball, 3.0}, {ToolShape::flat, 2.0}, {ToolShape::vee, 3.0, 60.0}};
    for (const ToolProfile& tool : tools) {
        // All are cut by the same threads.
        if (test::kIsThreadSanitized && !test::is_long_run() && tool.shape != ToolShape::ball) continue;
        SCOPED_TRACE(tool::name_of(tool));
        profile_.tool = tool;
        ASSERT_NO_FATAL_FAILURE(make());
        look(0);
        carve(0, kPieceLayers);
        expect_same(shown(), truth(0, kPieceLayers));
        EXPECT_EQ(sut_->skipped_layers(), 0U);
        EXPECT_EQ(sut_->waiting(), 0U);
    }
}

TEST_F(LivePieces, StandWhereTheBlankStands) {
    profile_.blank.radius_mm = 13.0;
    profile_.blank.height_mm = 6.0;
    profile_.blank.offset_x_mm = 1.0;
    ASSERT_NO_FATAL_FAILURE(make());
    EXPECT_NEAR(shown().row(0)[0], 14.0F, 1e-3);
    EXPECT_NEAR(shown().row(0)[shown().column_count() / 2], 12.0F, 1e-3);
    EXPECT_NEAR(shown().bottom_mm() + shown().row_mm() * static_cast<double>(shown().row_count()), 6.0, 1e-6);
    look(0);
    carve(0, kPieceLayers);
    expect_same(shown(), truth(0, kPieceLayers));
}

TEST_F(LivePieces, AreCutAsPlannedWhereIncrementsWereLost) {
    // So small that what was lost between two layers would stand there as a rib.
    profile_.tool.diameter_mm = 0.6;
    ASSERT_NO_FATAL_FAILURE(make());
    look(0);
    carve(0, 5);
    tell_layer(50);
    look(51, true);
    const auto early = shown();
    look(52);
    carve(52, kPieceLayers);
    expect_same(shown(), truth(0, kPieceLayers));
    expect_same(early, truth(0, 51));
}

TEST_F(LivePieces, HaveWhatWasCarvedBeforeAnybodyLooked) {
    sut_->look({30 * kPiecePoints + 20, false});
    const double half = shown().removed_mm3();
    EXPECT_GT(half, truth(0, 30).removed_mm3());
    EXPECT_LT(half, truth(0, 31).removed_mm3());
    carve(31, kPieceLayers);
    expect_same(shown(), truth(0, kPieceLayers));
}

TEST_F(LivePieces, DoNotFollowWithoutEnd) {
    look(0);
    for (std::uint32_t layer = 0; layer < 20; ++layer) tell_layer(layer, 600);
    look(20);
    EXPECT_LT(sut_->waiting(), LivePiece::kMostWaiting);
    EXPECT_EQ(sut_->skipped_layers(), 20U);
    look(20);
    carve(20, kPieceLayers);
    expect_same(shown(), truth(0, kPieceLayers));
    EXPECT_EQ(sut_->layers_to_come(), 0U);
}

TEST_F(LivePieces, EndInTheMiddleOfALayerThatIsCutAsPlanned) {
    // So fine that one layer takes much longer than a thread takes to wake up.
    profile_.tool.diameter_mm = 1.0;
    ASSERT_NO_FATAL_FAILURE(make());
    EXPECT_TRUE(ends_in_the_middle([this] { sut_->look({kPiecePoints, false}); }, 2'500));
}

TEST_F(LivePieces, EndInTheMiddleOfIncrements) {
    const auto carve_a_layer = [this] {
        look(0);
        tell_layer(0, 100);
        look(1);
    };
    EXPECT_TRUE(ends_in_the_middle(carve_a_layer, 2'500));
}

TEST_F(LivePieces, EndWhileMuchIsToBeCut) {
    EXPECT_TRUE(ends_in_the_middle([this] {
        sut_->look({std::uint64_t{kPieceLayers} * kPiecePoints, false});
        for (std::uint32_t layer = 0; layer < 5; ++layer) tell_layer(layer, 100);
        look(kPieceLayers);
    }));
}

TEST_F(LivePieces, AreDrawnAsTheyAre) {
    constexpr std::uint32_t kDoneRgb = 0xAAAAAA;
    constexpr std::uint32_t kBlankRgb = 0x555555;
    look(0);
    StockScene scene{*record_, sut_->front(), {1000, 1000, 4, kDoneRgb, kBlankRgb}};
    const auto count = [&](std::uint32_t rgb) {
        const auto& colours = scene.scene()->vertex_rgb;
        return std::count(colours.begin(), colours.end(), rgb);
    };
    EXPECT_EQ(count(kDoneRgb), 0);
    carve(0, 10);
    sut_->finish();
    std::size_t changed = 0;
    for (const VertexRange& range : scene.update(*record_)) changed += range.count;
    EXPECT_GT(changed, 0U);
    EXPECT_LT(changed, scene.scene()->vertices.size() * 9 / 10) << "the upper rows are the blank's";
    EXPECT_TRUE(scene.update(*record_).empty());
    EXPECT_GT(count(kDoneRgb), 0);
    EXPECT_GT(count(kBlankRgb), 0);
    const piece::StockMap& stock = sut_->front().shown();
    for (std::size_t row = 0; row < stock.row_count(); ++row) {
        for (std::size_t column = 0; column < stock.column_count(); column += 17) {
            const auto& vertex = scene.scene()->vertices[row * stock.column_count() + column];
            ASSERT_NEAR(std::hypot(vertex[0], vertex[1]), stock.row(row)[column], 1e-4);
        }
    }
    const StockScene anew{*record_, sut_->front(), {1000, 1000, 4, kDoneRgb, kBlankRgb}};
    EXPECT_EQ(anew.scene()->vertices, scene.scene()->vertices);
    EXPECT_EQ(anew.scene()->vertex_rgb, scene.scene()->vertex_rgb);
    // What can be wrong has the colour of that, and loses it again.
    constexpr std::uint32_t kDoubtRgb = 0xDD0000;
    CarvedScenePlan plan{1000, 1000, 4, kDoneRgb, kBlankRgb};
    plan.doubt_rgb = kDoubtRgb;
    StockScene doubted{*record_, sut_->front(), plan};
    const auto in_doubt = [&] {
        const auto& colours = doubted.scene()->vertex_rgb;
        return std::count(colours.begin(), colours.end(), kDoubtRgb);
    };
    doubted.update(*record_);
    constexpr verify::LayerRange kRange{3, 2};
    record_->set_doubt(std::span{&kRange, 1});
    EXPECT_FALSE(doubted.update(*record_).empty());
    EXPECT_GT(in_doubt(), 0);
    EXPECT_LT(in_doubt(), count(kDoneRgb) / 2);
    record_->set_doubt({});
    EXPECT_FALSE(doubted.update(*record_).empty());
    EXPECT_EQ(in_doubt(), 0);
    // A tip that touches stands on what it has left.
    const auto pose = record_->pose(geometry().target(9, 0), scene.middle_mm());
    const double height_mm = pose.heads[0].height_mm + scene.middle_mm();
    EXPECT_NEAR(height_mm, 1.0 + 0.03 * 9, 0.01);
}

}  // namespace
}  // namespace psicarve::session
