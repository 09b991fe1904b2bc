// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/scene/carved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>

#include "hmi/scene/colour_map.hpp"
#include "shared/base/units.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::session {
namespace {

constexpr std::uint32_t kLayers = 6;
constexpr std::uint32_t kPoints = 21;
constexpr std::uint32_t kDone = 0xAAAAAA;
constexpr std::uint32_t kBlank = 0x555555;

class Carving : public ::testing::Test {
protected:
    Carving() {
        const Profile profile;
        auto made = cam::prepare_blob(job_blob_from_table(two_process::lobed_job(kLayers, kPoints)), profile,
                                      "lobed");
        EXPECT_TRUE(made);
        job_ = std::make_shared<const cam::PreparedJob>(std::move(*made));
        auto record = CarvingRecord::make(job_);
        EXPECT_TRUE(record);
        sut_ = std::move(*record);
    }
    /// As the core reports a layer's points.
    void carve(std::uint32_t layer) {
        for (std::uint32_t point = 0; point < kPoints; ++point) {
            sut_->take({0, job_->view.r_left_pulses(layer)[point], job_->view.r_right_pulses(layer)[point],
                        job_->view.psi_pulses(layer, point), job_->view.y_pulses(layer, point)});
        }
    }
    CarvedScenePlan plan(std::size_t most_round = 1000, std::size_t most_up = 1000) const {
        return {most_round, most_up, 4, kDone, kBlank};
    }
    std::size_t done_vertices() const {
        const auto scene = CarvedScene{*sut_, plan()}.scene();
        return static_cast<std::size_t>(
            std::count(scene->vertex_rgb.begin(), scene->vertex_rgb.end(), kDone));
    }
    static constexpr std::size_t kCellsOfLayer = 2 * (kPoints - 1);

    std::shared_ptr<const cam::PreparedJob> job_;
    std::unique_ptr<CarvingRecord> sut_;
};

TEST_F(Carving, ShowsWhatTheCoreReportedAndNothingElse) {
    EXPECT_EQ(done_vertices(), 0U);
    const auto before = sut_->edition();
    carve(0);
    EXPECT_GT(sut_->edition(), before);
    EXPECT_EQ(done_vertices(), kCellsOfLayer);
    carve(1);
    EXPECT_EQ(done_vertices(), 2 * kCellsOfLayer);
    sut_->take_as_planned(2);
    EXPECT_EQ(sut_->planned_layers(), 0U);
}

TEST_F(Carving, MeasuresHowFarTheHeadsWereFromTheJob) {
    carve(0);
    const std::int32_t at_point = job_->view.r_left_pulses(1)[4];
    const auto entry = [&](std::int32_t off_pulses) {
        return IncrementEntry{0, at_point + off_pulses, 100'000, job_->view.psi_pulses(1, 4),
                              job_->view.y_pulses(1, 4)};
    };
    const auto cell = sut_->geometry().cell_of(sut_->geometry().direction(0, job_->view.psi_pulses(1, 4)));
    sut_->take(entry(30));
    // Less what the path's tolerance and a pulse of psi may be.
    EXPECT_GT(sut_->deviation_pulses(1, cell), 5);
    EXPECT_LT(sut_->deviation_pulses(1, cell), 30);
    sut_->take(entry(-60));
    const std::int32_t deep = sut_->deviation_pulses(1, cell);
    EXPECT_LT(deep, -35);
    EXPECT_GT(deep, -60);
    sut_->take(entry(0));  // the deepest stays
    EXPECT_EQ(sut_->deviation_pulses(1, cell), deep);
    for (std::uint32_t each = 0; each < kCellsOfLayer; ++each) EXPECT_EQ(sut_->deviation_pulses(0, each), 0);
    sut_->take_as_planned(3);
    EXPECT_EQ(sut_->deviation_pulses(2, cell), 0);  // it was not seen
    CarvedScenePlan by_deviation = plan();
    by_deviation.colouring = Colouring::deviation;
    const auto colours = CarvedScene{*sut_, by_deviation}.scene()->vertex_rgb;
    EXPECT_EQ(std::count(colours.begin(), colours.end(), vik(0.0)), 1);  // too deep, beyond the scale
    CarvedScenePlan by_radius = plan();
    by_radius.colouring = Colouring::radius;
    by_radius.most_mm = 100.0;
    const auto radius = static_cast<double>(sut_->surface().radii_mm(0)[0]);
    EXPECT_EQ(CarvedScene(*sut_, by_radius).scene()->vertex_rgb[0], viridis(radius / 100.0));
}

TEST_F(Carving, TakesFromTheJobWhatNobodySaw) {
    carve(0);
    sut_->take_as_planned(4);
    EXPECT_EQ(done_vertices(), 4 * kCellsOfLayer);
    EXPECT_EQ(sut_->planned_layers(), 3U);
    sut_->take_as_planned(1000);
    EXPECT_EQ(sut_->planned_layers(), kLayers - 1);
}

TEST_F(Carving, GoesOnWithALongPlanFromCallToCall) {
    sut_->take_as_planned(4, 2 * kCellsOfLayer);
    EXPECT_EQ(done_vertices(), 2 * kCellsOfLayer);
    sut_->take_as_planned(4, 1);  // never none
    EXPECT_EQ(done_vertices(), 3 * kCellsOfLayer);
    sut_->take_as_planned(4);
    EXPECT_EQ(done_vertices(), 4 * kCellsOfLayer);
}

TEST_F(Carving, TurnsThePartUntilR1StandsLeft) {
    const std::int64_t y_pulses = job_->view.layer_heights_pulses()[0];
    verify::Positions positions{};
    positions[index_of(Axis::r1)] = 400 * 12;
    positions[index_of(Axis::r2)] = 400 * 15;
    positions[index_of(Axis::psi)] = 6400 / 4;
    positions[index_of(Axis::y)] = y_pulses;
    const MachinePose pose = sut_->pose(positions, 0.5 * (sut_->bottom_mm() + sut_->top_mm()));
    EXPECT_NEAR(pose.heads[0].direction_rad, kPi, 1e-9);
    EXPECT_NEAR(std::cos(pose.heads[1].direction_rad), 1.0, 1e-9);
    EXPECT_NEAR(pose.heads[0].radius_mm, 12.0, 1e-9);
    EXPECT_NEAR(pose.heads[1].radius_mm, 15.0, 1e-9);
    EXPECT_LT(pose.heads[0].height_mm, 0.0);
    // A quarter turn of the table: what R1 works on stands at a quarter of the workpiece.
    EXPECT_NEAR(pose.part_turn_rad, kPi / 2.0, 1e-9);
}

TEST_F(Carving, DrawsNoMoreCellsThanAsked) {
    const auto scene = CarvedScene{*sut_, plan(10, 3)}.scene();
    EXPECT_EQ(scene->vertices.size(), 10U * 3U + 1U);
    EXPECT_EQ(scene->facets.size(), 2U * 10U * 2U + 10U);
    // Columns 0, 4, 8 and the seam; the lowest row and the highest.
    EXPECT_EQ(scene->coarse_facets.size(), 3U * 2U + 3U);
    EXPECT_EQ(scene->vertex_rgb.size(), scene->vertices.size());
}

TEST_F(Carving, ShowsWhatIsCarvedAndInDoubtWhateverTheColouring) {
    constexpr std::uint32_t kDoubt = 0xDD0000;
    constexpr verify::LayerRange kRange{1, 2};
    carve(0);
    carve(1);
    for (const Colouring colouring : {Colouring::done, Colouring::radius, Colouring::deviation}) {
        CarvedScenePlan coloured = plan();
        coloured.doubt_rgb = kDoubt;
        coloured.colouring = colouring;
        CarvedScene scene{*sut_, coloured};
        scene.update(*sut_);
        const auto doubtful = [&] {
            const auto& rgb = scene.scene()->vertex_rgb;
            return std::count(rgb.begin(), rgb.end(), kDoubt);
        };
        EXPECT_EQ(doubtful(), 0);
        const auto before = sut_->edition();
        sut_->set_doubt(std::span{&kRange, 1});
        EXPECT_GT(sut_->edition(), before);
        const std::vector<VertexRange> wanted{{0, kLayers * kCellsOfLayer}};
        EXPECT_EQ(scene.update(*sut_), wanted);
        EXPECT_EQ(doubtful(), std::ptrdiff_t{kCellsOfLayer}) << "layer 2 is not carved yet";
        EXPECT_EQ(scene.scene()->vertex_rgb[kCellsOfLayer], kDoubt);
        sut_->set_doubt({});
        EXPECT_EQ(scene.update(*sut_), wanted);
        EXPECT_EQ(doubtful(), 0);
    }
    // Of rows that stand for several layers each, those that one of these is among.
    carve(3);
    carve(4);
    carve(5);
    constexpr verify::LayerRange kBetween{3, 1};
    sut_->set_doubt(std::span{&kBetween, 1});
    CarvedScenePlan few = plan(1000, 3);  // of layers 0, 2 and 5
    few.doubt_rgb = kDoubt;
    const CarvedScene scene{*sut_, few};
    const auto& rgb = scene.scene()->vertex_rgb;
    EXPECT_EQ(std::count(rgb.begin(), rgb.end(), kDoubt), 0) << "layer 2, which the row shows, is not carved";
    carve(2);
    const CarvedScene carved{*sut_, few};
    const auto& rgb_carved = carved.scene()->vertex_rgb;
    EXPECT_EQ(std::count(rgb_carved.begin(), rgb_carved.end(), kDoubt), std::ptrdiff_t{kCellsOfLayer});
    EXPECT_EQ(rgb_carved[kCellsOfLayer], kDoubt);
    constexpr verify::LayerRange kBeyond{kLayers + 5, ~0U};
    sut_->set_doubt(std::span{&kBeyond, 1});
    for (std::uint32_t layer = 0; layer < kLayers; ++layer) EXPECT_FALSE(sut_->is_in_doubt(layer));
}

/// Layers 0 and 1 of roughing stand at the heights of rows 0 and 4 of six.
TEST(CarvingOfPasses, DoubtsTheRowsAboutALayerOfRoughing) {
    JobTable table = two_process::lobed_job(2 + kLayers, kPoints);
    for (std::uint32_t row = 0; row < kLayers; ++row)
        table.layer_height_pulses[2 + row] = 1000 + 100 * std::int64_t{row};
    table.layer_height_pulses[0] = 1000;
    table.layer_height_pulses[1] = 1400;
    table.passes = {{static_cast<std::uint32_t>(PassKind::roughing), 1, 0, 2, 0.3, 2.0, 30.0},
                    {static_cast<std::uint32_t>(PassKind::finishing), 1, 2, kLayers, 0.0, 2.0, 30.0}};
    auto made = cam::prepare_blob(job_blob_from_table(table), Profile{}, "rough");
    ASSERT_TRUE(made) << made.error().message;
    auto record = CarvingRecord::make(std::make_shared<const cam::PreparedJob>(std::move(*made)));
    ASSERT_TRUE(record);
    const auto doubted = [&](verify::LayerRange range) {
        (*record)->set_doubt(std::span{&range, 1});
        std::string rows;
        for (std::uint32_t row = 0; row < kLayers; ++row) {
            if ((*record)->is_in_doubt(row)) rows += std::to_string(row);
        }
        return rows;
    };
    EXPECT_EQ(doubted({0, 1}), "012") << "up to the middle";
    EXPECT_EQ(doubted({1, 1}), "2345") << "and from there on";
    EXPECT_EQ(doubted({0, 2}), "012345");
    EXPECT_EQ(doubted({1, 2}), "02345") << "the last of one pass and the first of the next";
    EXPECT_EQ(doubted({3, 2}), "12");
    EXPECT_EQ(doubted({7, 9}), "5");
}

TEST_F(Carving, MakesOnlyThoseRowsAnewThatWereCarved) {
    CarvedScene scene{*sut_, plan()};
    scene.update(*sut_);
    EXPECT_TRUE(scene.update(*sut_).empty());
    carve(1);
    carve(2);
    carve(4);
    const std::vector<VertexRange> wanted{{kCellsOfLayer, 2 * kCellsOfLayer},
                                          {4 * kCellsOfLayer, kCellsOfLayer}};
    EXPECT_EQ(scene.update(*sut_), wanted);
    EXPECT_EQ(scene.scene()->vertex_rgb[2 * kCellsOfLayer], kDone);
    EXPECT_EQ(scene.scene()->vertex_rgb[3 * kCellsOfLayer], kBlank);
    EXPECT_EQ(scene.scene()->vertices, CarvedScene(*sut_, plan()).scene()->vertices);
    EXPECT_TRUE(scene.update(*sut_).empty());
}

}  // namespace
}  // namespace psicarve::session
