// SPDX-License-Identifier: GPL-3.0-or-later
// What rule 1 is made of: where carving may begin, how far it is, the way to the next point, what it paints.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "hmi/verify/path/carve_progress.hpp"
#include "hmi/verify/path/carving_begins.hpp"
#include "hmi/verify/path/point_way.hpp"
#include "hmi/verify/path/surface_painter.hpp"
#include "hmi/verify/path/tip_depth.hpp"
#include "tests/hmi/verify/perfect_machine.hpp"

namespace psicarve::verify {
namespace {

constexpr std::uint32_t kPartLayers = 4;
constexpr std::uint32_t kPartPoints = 21;

class PathParts : public testing::Test {
protected:
    static JobGeometry geometry_of(const SampleJob& job, const LayerRange& layers = {}) {
        return JobGeometry::make(job.view(), job.profile, layers).value();
    }

    const SampleJob job_ = wavy_job(Joining::continuous, kPartLayers, kPartPoints);
    const JobGeometry geometry_ = geometry_of(job_);
};

using CarveProgressTest = PathParts;
using CarvingBeginsTest = PathParts;
using PointWayTest = PathParts;
using SurfacePainterTest = PathParts;
using TipDepthTest = PathParts;

void carve_layer(CarveProgress& progress, std::uint32_t layer, std::uint32_t points = kPartPoints) {
    for (std::uint32_t i = 0; i < points; ++i) progress.count(layer);
}

TEST_F(CarveProgressTest, DuesTheFirstLayerThatLacksAPoint) {
    CarveProgress progress(geometry_);
    EXPECT_EQ(progress.due_layer(), 0U);
    carve_layer(progress, 0);
    EXPECT_EQ(progress.due_layer(), 1U);
    carve_layer(progress, 1, kPartPoints - 1);
    EXPECT_EQ(progress.due_layer(), 1U);
    progress.count(1);
    EXPECT_EQ(progress.due_layer(), 2U);
    progress.take_back(1);
    EXPECT_EQ(progress.due_layer(), 1U);
    EXPECT_EQ(progress.points(), 2U * kPartPoints - 1);
    carve_layer(progress, 1, 1);
    carve_layer(progress, 2);
    carve_layer(progress, 3);
    EXPECT_EQ(progress.due_layer(), kPartLayers) << "all is carved";
}

TEST_F(CarveProgressTest, ForgetsWhatIsCarvedAnewAndNoMore) {
    CarveProgress progress(geometry_);
    for (std::uint32_t layer = 0; layer < 3; ++layer) carve_layer(progress, layer);
    const auto kept = progress.kept();
    progress.forget_from({1, 5});
    EXPECT_EQ(progress.points_of(0), kPartPoints);
    EXPECT_EQ(progress.points_of(1), 5U);
    EXPECT_EQ(progress.points_of(2), 0U);
    EXPECT_EQ(progress.points(), kPartPoints + 5U);
    progress.forget_from({1, 9});
    EXPECT_EQ(progress.points_of(1), 5U) << "what lies before was never carved";
    progress.restore(kept);
    EXPECT_EQ(progress.points(), 3U * kPartPoints);
    EXPECT_EQ(progress.points_of(2), kPartPoints);
}

TEST_F(CarveProgressTest, CountsNoPointThatIsLeftOutOnPurpose) {
    const JobGeometry part = geometry_of(job_, {1, 2, 6});
    CarveProgress progress(part);
    EXPECT_EQ(progress.points_of(1), 6U);
    EXPECT_EQ(progress.points(), 0U);
    carve_layer(progress, 1, kPartPoints - 6);
    EXPECT_EQ(progress.due_layer(), 2U);
    EXPECT_EQ(progress.points(), kPartPoints - 6U);
    progress.forget_from({1, 6});
    EXPECT_EQ(progress.points(), 0U);
}

TEST_F(CarvingBeginsTest, FindsALayersFirstPointUpToWholeTurns) {
    CarvingBegins begins(geometry_);
    const CarveProgress progress(geometry_);
    for (std::uint32_t layer = 0; layer < kPartLayers; ++layer) {
        for (const std::int64_t turns : {-2, 0, 3}) {
            Positions at = geometry_.target(layer, 0);
            at[kPsi] += turns * geometry_.rev_pulses();
            EXPECT_EQ(begins.layer_at(at, progress.due_layer()), layer);
            EXPECT_EQ(begins.is_first(at), layer == 0);
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                Positions beside = at;
                ++beside[k];
                EXPECT_EQ(begins.layer_at(beside, progress.due_layer()), std::nullopt) << "axis " << k;
            }
        }
    }
}

TEST_F(CarvingBeginsTest, FindsEveryPointOfALayerButTheLast) {
    CarvingBegins begins(geometry_);
    const CarveProgress progress(geometry_);
    for (std::uint32_t step = 0; step < kPartPoints; ++step) {
        const Positions at = geometry_.target(2, step);
        const auto found = begins.point_at(at, progress.due_layer());
        EXPECT_EQ(found.has_value(), step + 1 < kPartPoints) << "step " << step;
        if (found) {
            EXPECT_EQ(*found, (CarvePoint{2, step}));
        }
        Positions beside = at;
        ++beside[0];
        EXPECT_FALSE(begins.point_at(beside, progress.due_layer())) << "step " << step;
    }
}

TEST_F(CarvingBeginsTest, KnowsHowNearTheFirstPointIs) {
    const CarvingBegins begins(geometry_);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        for (const std::int64_t sign : {-1, 1}) {
            Positions at = geometry_.target(0, 0);
            at[kPsi] += geometry_.rev_pulses();
            at[k] += sign * kNearPulses;
            EXPECT_TRUE(begins.is_near_first(at, kNearPulses)) << "axis " << k;
            at[k] += sign;
            EXPECT_FALSE(begins.is_near_first(at, kNearPulses)) << "axis " << k;
        }
    }
}

TEST_F(PointWayTest, LeadsFromThePointBeforeInTheLayersSense) {
    PointWay way(geometry_);
    way.aim({1, 4});
    way.aim({1, 5});
    EXPECT_EQ(way.from(), geometry_.target(1, 4));
    EXPECT_EQ(way.to(), geometry_.target(1, 5));
    EXPECT_EQ(way.beyond(way.to()[kPsi]), 0);
    EXPECT_LT(way.beyond(way.from()[kPsi]), 0) << "before the point, whichever way the layer turns";
    EXPECT_FALSE(way.is_layers_last());
    way.aim({1, kPartPoints - 1});
    EXPECT_TRUE(way.is_layers_last());
}

TEST_F(PointWayTest, KnowsTheOneAxisThatMissed) {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        PointWay way(geometry_);
        way.aim({0, 3});
        way.aim({0, 4});
        Positions near = way.to();
        near[k] += kNearPulses;
        way.note(way.from());
        way.note(near);
        const PointWay::Miss miss = way.miss(way.from());
        EXPECT_EQ(index_of(miss.axis), k);
        EXPECT_EQ(miss.off, kNearPulses);
        EXPECT_EQ(miss.measured, near[k]);
    }
}

TEST_F(PointWayTest, TakesTheHeadFurthestOffWhereSeveralMissed) {
    PointWay way(geometry_);
    way.aim({0, 3});
    way.aim({0, 4});
    Positions at = way.to();
    at[0] += 3;
    at[1] -= 9;
    way.note(at);
    way.note_radii(at);
    Positions beyond = at;
    beyond[0] += 50;
    const PointWay::Miss miss = way.miss(beyond);
    EXPECT_EQ(miss.axis, Axis::r2);
    EXPECT_EQ(miss.off, 9);
    EXPECT_EQ(way.closest(0, beyond), at[0]) << "as near as it came while psi stood at the point's";
}

TEST_F(PointWayTest, AllAxesThereAtDifferentInstantsIsAMissOfNone) {
    PointWay way(geometry_);
    way.aim({0, 3});
    way.aim({0, 4});
    way.note_radii(way.to());
    EXPECT_EQ(way.miss(way.to()).off, 0);
}

TEST_F(PointWayTest, AtAPasssFirstPointHeadsMayStillGoOut) {
    PointWay way(geometry_);
    way.aim({1, 0});
    const Positions link = way.from();
    way.aim({1, 1});
    Positions out = way.from();
    out[0] += 400;
    EXPECT_FALSE(way.has_only_passed_link(out)) << "no link led there";
    way.note_link(link);
    EXPECT_TRUE(way.has_only_passed_link(out));
    Positions in = way.from();
    in[0] -= 400;
    EXPECT_FALSE(way.has_only_passed_link(in));
    Positions turned = out;
    ++turned[kPsi];
    EXPECT_FALSE(way.has_only_passed_link(turned));
    way.go_back_to_link();
    way.aim({1, 0});
    EXPECT_EQ(way.from(), link);
    EXPECT_EQ(way.to(), geometry_.target(1, 0));
}

TEST_F(SurfacePainterTest, PaintsARowOnlyWhereItsHeadsAre) {
    CarvedSurface surface(geometry_);
    SurfacePainter painter(geometry_, surface);
    painter.aim(geometry_.target(1, 4)[kPsi], 1, 5);
    const Positions point = geometry_.target(1, 5);
    painter.reach(point);
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const std::uint32_t cell = geometry_.cell_of(geometry_.direction(h, point[kPsi]));
        const double real_mm = geometry_.head(h).real_mm(point[index_of(kHeads[h])]);
        EXPECT_FLOAT_EQ(surface.radii_mm(1)[cell], static_cast<float>(real_mm));
        EXPECT_EQ(surface.deviation_pulses(1, cell), 0);
    }
    EXPECT_EQ(surface.uncarved_cells(), kPartLayers * geometry_.direction_count() - 2U);
    painter.miss(0, point[kPsi], -7);
    EXPECT_EQ(surface.deviation_pulses(1, geometry_.cell_of(geometry_.direction(0, point[kPsi]))), -7);
}

TEST_F(SurfacePainterTest, LeavesTheSurfaceAloneOnceItLetGo) {
    CarvedSurface surface(geometry_);
    SurfacePainter painter(geometry_, surface);
    painter.let_go();
    painter.aim(geometry_.target(1, 4)[kPsi], 1, 5);
    painter.reach(geometry_.target(1, 5));
    painter.carve(0, geometry_.target(1, 5));
    painter.mark(0, 0, 1.0);
    painter.make_blank();
    EXPECT_EQ(surface.uncarved_cells(), kPartLayers * geometry_.direction_count());
}

TEST_F(TipDepthTest, IsCountedFromTheSurfaceWhereTheTipStands) {
    const Positions point = geometry_.target(2, 7);
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        for (const std::int64_t off : {-5, 0, 5}) {
            Positions at = point;
            at[index_of(kHeads[h])] += off;
            const auto tip = tip_depth(geometry_, h, at, {});
            ASSERT_TRUE(tip);
            EXPECT_EQ(tip->row, 2U);
            EXPECT_EQ(tip->cell, geometry_.cell_of(geometry_.direction(h, at[kPsi])));
            EXPECT_EQ(tip->off_pulses, off);
            EXPECT_EQ(tip->too_deep_pulses, -off) << "at a point's angle its radius is the floor";
        }
    }
}

TEST_F(TipDepthTest, OutsideTheBlankThereIsNone) {
    Positions at = geometry_.target(2, 7);
    at[0] = static_cast<std::int64_t>(geometry_.blank_radius_mm() * geometry_.head(0).pulses_per_mm) + 1;
    EXPECT_FALSE(tip_depth(geometry_, 0, at, {}));
    EXPECT_TRUE(tip_depth(geometry_, 1, at, {}));
}

}  // namespace
}  // namespace psicarve::verify
