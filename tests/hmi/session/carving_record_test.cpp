// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/carving_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

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
    std::size_t done_facets() const {
        const MeshScene scene = sut_->scene(1000, 1000, kDone, kBlank);
        return static_cast<std::size_t>(std::count(scene.facet_rgb.begin(), scene.facet_rgb.end(), kDone));
    }
    static constexpr std::size_t kFacetsOfLayer = 2 * 2 * (kPoints - 1);

    std::shared_ptr<const cam::PreparedJob> job_;
    std::unique_ptr<CarvingRecord> sut_;
};

TEST_F(Carving, ShowsWhatTheCoreReportedAndNothingElse) {
    EXPECT_EQ(done_facets(), 0U);
    EXPECT_FALSE(sut_->tip(0));
    const auto before = sut_->edition();
    carve(0);
    EXPECT_GT(sut_->edition(), before);
    EXPECT_EQ(done_facets(), kFacetsOfLayer);
    carve(1);
    EXPECT_EQ(done_facets(), 2 * kFacetsOfLayer);
    sut_->take_as_planned(2);
    EXPECT_EQ(sut_->planned_layers(), 0U);
}

TEST_F(Carving, TakesFromTheJobWhatNobodySaw) {
    carve(0);
    sut_->take_as_planned(4);
    EXPECT_EQ(done_facets(), 4 * kFacetsOfLayer);
    EXPECT_EQ(sut_->planned_layers(), 3U);
    sut_->take_as_planned(1000);
    EXPECT_EQ(sut_->planned_layers(), kLayers - 1);
    sut_->start_anew();
    EXPECT_EQ(done_facets(), 0U);
    EXPECT_EQ(sut_->planned_layers(), 0U);
}

TEST_F(Carving, KnowsWhereTheTipsAreOnTheWorkpiece) {
    sut_->take({0, 400 * 12, 400 * 15, 6400 / 4, job_->view.layer_heights_pulses()[0]});
    const auto r1 = sut_->tip(0);
    const auto r2 = sut_->tip(1);
    ASSERT_TRUE(r1 && r2);
    EXPECT_NEAR((*r1)[0], 0.0, 1e-9);
    EXPECT_NEAR((*r1)[1], 12.0, 1e-9);
    EXPECT_NEAR((*r2)[1], -15.0, 1e-9);
    EXPECT_LT((*r1)[2], 0.0);
}

TEST_F(Carving, DrawsNoMoreCellsThanAsked) {
    const MeshScene scene = sut_->scene(10, 3, kDone, kBlank);
    EXPECT_EQ(scene.vertices.size(), 10U * 3U + 1U);
    EXPECT_EQ(scene.facets.size(), 2U * 10U * 2U + 10U);
    EXPECT_EQ(scene.facet_rgb.size(), scene.facets.size());
}

}  // namespace
}  // namespace psicarve::session
