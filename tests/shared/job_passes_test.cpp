// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs of several passes, and those from before there were any.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include "shared/record/snapshot_file.hpp"
#include "tests/places.hpp"
#include "tests/shared/job_fixture.hpp"
#include "tests/shared/passes_fixture.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;

/// Two roughing passes of 2 and 1 layers, the finishing pass of 3.
JobTable three_passes(Joining joining = Joining::continuous) {
    JobTable table = small_job({}, 6);
    table.joining = joining;
    table.layer_height_pulses = {100, 120, 100, 100, 110, joining == Joining::spiral ? 110 : 120};
    set_passes(table, {2, 1, 3});
    return table;
}

TEST(JobPasses, ComeBackAsTheyWerePut) {
    const JobTable table = three_passes();
    const auto blob = job_blob_from_table(table);
    EXPECT_EQ(blob.size(), job_blob_bytes(6, 5, table.profile_toml.size(), table.report_json.size(), 3));
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view) << view.error().message;
    ASSERT_EQ(view->passes().size(), 3U);
    EXPECT_EQ(std::memcmp(view->passes().data(), table.passes.data(), 3 * sizeof(JobPass)), 0);
    EXPECT_EQ(view->finishing_layer(), 3U);
    const std::vector<std::uint32_t> pass_of{0, 0, 1, 2, 2, 2};
    const std::vector<std::uint32_t> end_of{2, 2, 3, 6, 6, 6};
    for (std::uint32_t layer = 0; layer < 6; ++layer) {
        EXPECT_EQ(view->pass_of(layer), pass_of[layer]) << layer;
        EXPECT_EQ(view->pass_end(layer), end_of[layer]) << layer;
        EXPECT_EQ(view->begins_pass(layer), layer == 0 || layer == 2 || layer == 3) << layer;
    }
    EXPECT_EQ(pass_name(view->passes()[1]), "roughing pass 2");
    EXPECT_EQ(pass_name(view->passes()[2]), "finishing pass");
    EXPECT_TRUE(check_job(*view, {}));
}

TEST(JobPasses, AJobWithoutThemIsOneFinishingPassAndHasNotChanged) {
    const auto blob = job_blob_from_table(small_job());
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view);
    const JobView copy = *view;
    ASSERT_EQ(copy.passes().size(), 1U);
    EXPECT_EQ(copy.passes()[0].kind, static_cast<std::uint32_t>(PassKind::finishing));
    EXPECT_EQ(copy.passes()[0].layer_count, 3U);
    EXPECT_EQ(copy.finishing_layer(), 0U);
    EXPECT_EQ(copy.pass_end(2), 3U);
    EXPECT_TRUE(copy.begins_pass(0));
    EXPECT_FALSE(copy.begins_pass(2));
    EXPECT_EQ(blob.size(), job_blob_bytes(3, 5, small_job().profile_toml.size(), 2));
}

TEST(JobPasses, OnlyTheFinishingPassOfASpiralRises) {
    JobTable table = three_passes(Joining::spiral);
    const auto blob = job_blob_from_table(table);
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view) << view.error().message;
    for (std::uint32_t layer = 0; layer < 4; ++layer) {
        EXPECT_FALSE(view->is_joint(layer, 0)) << layer;
        EXPECT_EQ(view->y_pulses(layer, 2), table.layer_height_pulses[layer]) << layer;
    }
    EXPECT_TRUE(view->is_joint(4, 0));
    EXPECT_EQ(view->y_pulses(4, 2), 105);
    EXPECT_TRUE(check_job(*view, {}));
}

TEST(JobPasses, HeightsRiseWithinEachOfThem) {
    JobTable table = three_passes();
    table.layer_height_pulses[1] = 100;
    const auto blob = job_blob_from_table(table);
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view);
    const auto checked = check_job(*view, {});
    ASSERT_FALSE(checked);
    EXPECT_THAT(checked.error().message, HasSubstr("layer 1"));
    EXPECT_THAT(checked.error().message, HasSubstr("does not lie above the layer below"));
}

struct PassHarm {
    const char* name;
    std::size_t pass;
    void (*apply)(JobPass&);
    const char* message;
};

class PassRefusals : public testing::TestWithParam<PassHarm> {};

TEST_P(PassRefusals, NameThePassAndWhatIsWrong) {
    JobTable table = three_passes();
    GetParam().apply(table.passes[GetParam().pass]);
    const auto view = JobView::check(job_blob_from_table(table));
    ASSERT_FALSE(view);
    EXPECT_THAT(view.error().message, HasSubstr(GetParam().message));
    EXPECT_THAT(view.error().message, HasSubstr("; make the job again"));
}

INSTANTIATE_TEST_SUITE_P(
    Table, PassRefusals,
    testing::Values(
        PassHarm{"Kind", 0, [](JobPass& p) { p.kind = 7; }, "pass 0 is of kind 7, where 1"},
        PassHarm{"FinishingFirst", 0, [](JobPass& p) { p.kind = 2; }, "pass 0 is of kind 2, where 1"},
        PassHarm{"RoughingLast", 2, [](JobPass& p) { p.kind = 1; }, "pass 2 is of kind 1, where 2"},
        PassHarm{"NumberZero", 0, [](JobPass& p) { p.number = 0; }, "pass 0 has the number 0"},
        PassHarm{"NumberBack", 1, [](JobPass& p) { p.number = 0; }, "pass 1 has the number 0 after 1"},
        PassHarm{"NumberAhead", 1, [](JobPass& p) { p.number = 3; }, "pass 1 has the number 3 after 1"},
        PassHarm{"Gap", 1, [](JobPass& p) { p.first_layer = 3; }, "pass 1 has 1 layers from layer 3 on"},
        PassHarm{"NoLayers", 1, [](JobPass& p) { p.layer_count = 0; }, "pass 1 has 0 layers"},
        PassHarm{"TooMany", 2, [](JobPass& p) { p.layer_count = 4; }, "pass 2 has 4 layers"},
        PassHarm{"Overflow", 2, [](JobPass& p) { p.layer_count = 0xFFFFFFFF; }, "pass 2 has 4294967295"},
        PassHarm{"TooFew", 2, [](JobPass& p) { p.layer_count = 2; }, "its passes hold 5 of 6 layers"},
        PassHarm{"AllowanceNegative", 0, [](JobPass& p) { p.allowance_mm = -0.1; }, "pass 0 has a length"},
        PassHarm{"DepthNan", 1, [](JobPass& p) { p.depth_mm = std::numeric_limits<double>::quiet_NaN(); },
                 "pass 1 has a length"},
        PassHarm{"ClearHuge", 2, [](JobPass& p) { p.clear_mm = 1e9; }, "pass 2 has a length"}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(JobPasses, MoreThanThereMayBeAreRefused) {
    auto blob = job_blob_from_table(three_passes());
    reinterpret_cast<JobHeader*>(blob.data())->pass_count = kMaxJobPasses + 1;
    const auto view = JobView::check(blob);
    ASSERT_FALSE(view);
    EXPECT_THAT(view.error().message, HasSubstr("1025 passes, where 1024 are the most"));
}

TEST(JobPasses, WhateverIsAcceptedAreAllLayersInOrder) {
    const auto good = job_blob_from_table(three_passes());
    const std::size_t begin = good.size() - 3 * sizeof(JobPass);
    std::mt19937 random(78);
    int accepted = 0;
    for (int round = 0; round < 20'000; ++round) {
        auto blob = good;
        for (unsigned i = 0; i <= random() % 2; ++i) {
            const std::size_t at = begin + random() % (3 * sizeof(JobPass));
            blob[at] = static_cast<std::byte>(random() % 8 == 0 ? random() & 0xFF : random() & 3);
        }
        const auto view = JobView::check(blob);
        if (!view) continue;
        ++accepted;
        for (std::uint32_t layer = 0; layer < view->layer_count(); ++layer) {
            ASSERT_LT(view->pass_of(layer), 3U);
            ASSERT_GT(view->pass_end(layer), layer);
            ASSERT_LE(view->pass_end(layer), 6U);
        }
        ASSERT_EQ(view->passes().back().kind, static_cast<std::uint32_t>(PassKind::finishing));
        for (const JobPass& pass : view->passes()) ASSERT_TRUE(std::isfinite(pass.clear_mm));
    }
    EXPECT_GT(accepted, 0);
}

/// Written by a psicarve of layout version 5, which knew of no passes.
TEST(OldFiles, OpenAsOneFinishingPass) {
    for (const std::string name : {"layout5.job", "layout5.snapshot"}) {
        const auto snapshot = load_snapshot(in_source("tests/data/jobs/") + name);
        ASSERT_TRUE(snapshot) << snapshot.error().message;
        EXPECT_EQ(snapshot->status.has_value(), name == "layout5.snapshot");
        const auto view = JobView::check(snapshot->job_blob);
        ASSERT_TRUE(view) << view.error().message;
        EXPECT_EQ(view->layer_count(), 3U);
        EXPECT_EQ(view->point_count(), 5U);
        ASSERT_EQ(view->passes().size(), 1U);
        EXPECT_EQ(view->passes()[0].kind, static_cast<std::uint32_t>(PassKind::finishing));
        EXPECT_EQ(view->passes()[0].layer_count, 3U);
        EXPECT_TRUE(check_job(*view, job_profile(*view).value()));
    }
}

/// Files of layout version 7: three layers of a box, roughed by two passes of three, 9 mm of blank.
TEST(OldFiles, OfSeveralPassesOpenWithThem) {
    for (const std::string name : {"layout7.job", "layout7.snapshot"}) {
        const auto snapshot = load_snapshot(in_source("tests/data/jobs/") + name);
        ASSERT_TRUE(snapshot) << snapshot.error().message;
        ASSERT_EQ(snapshot->status.has_value(), name == "layout7.snapshot");
        if (snapshot->status) {
            EXPECT_EQ(snapshot->status->state, MachineState::ready);
            EXPECT_EQ(snapshot->status->points_done, 45U);
            EXPECT_EQ(snapshot->records.size(), 39U);
        }
        const auto view = JobView::check(snapshot->job_blob);
        ASSERT_TRUE(view) << view.error().message;
        EXPECT_EQ(view->layer_count(), 9U);
        EXPECT_EQ(view->point_count(), 5U);
        ASSERT_EQ(view->passes().size(), 3U);
        for (const JobPass& pass : view->passes()) EXPECT_EQ(pass.layer_count, 3U);
        EXPECT_EQ(view->passes()[1].kind, static_cast<std::uint32_t>(PassKind::roughing));
        EXPECT_EQ(view->passes()[2].kind, static_cast<std::uint32_t>(PassKind::finishing));
        const auto profile = job_profile(*view);
        ASSERT_TRUE(profile) << profile.error().message;
        EXPECT_EQ(profile->blank.radius_mm, 9.0);
        EXPECT_EQ(profile->tool.shape, ToolShape::flat);
        EXPECT_TRUE(check_job(*view, *profile));
    }
}

}  // namespace
}  // namespace psicarve
