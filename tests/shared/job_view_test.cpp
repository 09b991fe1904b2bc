// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <random>

#include "tests/shared/job_fixture.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;

JobHeader& header_of(std::vector<std::byte>& blob) {
    return *reinterpret_cast<JobHeader*>(blob.data());
}

/// What JobView says of a good blob after `harm`.
std::string verdict_after(const std::function<void(JobHeader&)>& harm) {
    auto blob = job_blob_from_table(small_job());
    harm(header_of(blob));
    const auto view = JobView::check(blob);
    return view ? "accepted" : view.error().message;
}

TEST(JobBlob, ComesBackAsTheTableItWasMadeFrom) {
    JobTable table = small_job({}, 4, 7);
    table.joining = Joining::zigzag;
    for (std::size_t i = 0; i < table.r_left_pulses.size(); ++i) {
        table.r_left_pulses[i] = static_cast<std::int32_t>(1000 + i);
        table.r_right_pulses[i] = static_cast<std::int32_t>(2000 - i);
    }
    const auto blob = job_blob_from_table(table);
    const auto checked = JobView::check(blob);
    ASSERT_TRUE(checked) << checked.error().message;
    const JobView& view = *checked;
    EXPECT_EQ(view.layer_count(), 4U);
    EXPECT_EQ(view.point_count(), 7U);
    EXPECT_EQ(view.psi_sweep_pulses(), 3200);
    EXPECT_EQ(view.joining(), Joining::zigzag);
    EXPECT_EQ(view.header().feed_mm_s, 20.0);
    EXPECT_EQ(view.header().source_hash, table.source_hash);
    EXPECT_EQ(view.source_name(), "model.stl");
    EXPECT_EQ(view.profile_toml(), table.profile_toml);
    EXPECT_EQ(view.report_json(), "{}");
    EXPECT_THAT(view.layer_heights_pulses(), testing::ElementsAreArray(table.layer_height_pulses));
    EXPECT_EQ(view.r_left_pulses(3)[6], 1027);
    EXPECT_EQ(view.r_right_pulses(1)[0], 1993);
    EXPECT_EQ(view.max_radius_pulses(Axis::r1), 1027);
    EXPECT_EQ(view.max_radius_pulses(Axis::r2), 2000);
    const auto profile = job_profile(view);
    ASSERT_TRUE(profile);
    EXPECT_EQ(*profile, Profile{});
}

TEST(JobBlob, SizeIsKnownBeforeItIsMade) {
    const JobTable table = small_job({}, 3, 3);  // an odd number of cells needs padding
    EXPECT_EQ(job_blob_from_table(table).size(),
              job_blob_bytes(3, 3, table.profile_toml.size(), table.report_json.size()));
    EXPECT_EQ(job_blob_bytes(3, 3, 0, 0), 256U + 3 * 8 + 2 * 40);
    EXPECT_EQ(job_blob_bytes(1, 2, 1, 9), 256U + 8 + 16 + 8 + 2 * 8);
    EXPECT_EQ(job_blob_bytes(1'000'000, 1'000'000, 0, 0), 256U + 8'000'000U + 8'000'000'000'000U);
}

TEST(JobBlob, PartsStandAtMultiplesOfEight) {
    JobTable table = small_job({}, 3, 3);
    for (int extra = 0; extra < 9; ++extra) {
        table.report_json += ' ';
        const auto blob = job_blob_from_table(table);
        const auto view = JobView::check(blob);
        ASSERT_TRUE(view) << view.error().message;
        EXPECT_EQ(view->header().heights_offset % 8, 0U);
        EXPECT_EQ(view->header().r_right_offset % 8, 0U);
    }
}

TEST(JobBlob, CarriesTheDirectionSignsOfItsProfile) {
    Profile profile;
    profile.r2.positive_is_high = false;
    profile.y.positive_is_high = false;
    const auto blob = job_blob_from_table(small_job(profile));
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view);
    EXPECT_THAT(view->header().direction_sign, testing::ElementsAre(1, -1, 1, -1));
}

TEST(JobBlob, LongNamesAreCutBetweenCharacters) {
    JobTable table = small_job();
    table.source_name = std::string(126, 'a') + "ö.stl";  // the ö would straddle the end
    const auto blob = job_blob_from_table(table);
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view) << view.error().message;
    EXPECT_EQ(view->source_name(), std::string(126, 'a'));
}

TEST(JobBlob, ControlCharactersInNamesAreReplaced) {
    JobTable table = small_job();
    table.source_name = "a\x1b[31mb\n";
    const auto blob = job_blob_from_table(table);
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view) << view.error().message;
    EXPECT_EQ(view->source_name(), "a?[31mb?");
}

struct Harm {
    const char* name;
    void (*apply)(JobHeader&);
    const char* message;
};

class JobViewRefusals : public testing::TestWithParam<Harm> {};

TEST_P(JobViewRefusals, NameWhatIsWrong) {
    const std::string verdict = verdict_after(GetParam().apply);
    EXPECT_THAT(verdict, HasSubstr(GetParam().message));
    EXPECT_THAT(verdict, HasSubstr("; make the job again"));
}

INSTANTIATE_TEST_SUITE_P(
    Header, JobViewRefusals,
    testing::Values(
        Harm{"Magic", [](JobHeader& h) { h.magic ^= 1; }, "does not begin like one"},
        Harm{"NoLayers", [](JobHeader& h) { h.layer_count = 0; }, "0 layers"},
        Harm{"OnePoint", [](JobHeader& h) { h.point_count = 1; }, "1 points"},
        Harm{"ManyLayers", [](JobHeader& h) { h.layer_count = 0xFFFFFFFF; }, "4294967295 layers"},
        Harm{"ManyPoints", [](JobHeader& h) { h.point_count = 1'000'001; }, "1000001 points"},
        Harm{"OneLayerMore", [](JobHeader& h) { ++h.layer_count; }, "its counts need"},
        Harm{"OnePointLess", [](JobHeader& h) { --h.point_count; }, "its counts need"},
        Harm{"Total", [](JobHeader& h) { h.total_bytes += 8; }, "its counts need"},
        Harm{"HugeProfile", [](JobHeader& h) { h.profile_bytes = ~std::uint64_t{0} - 255; }, "a profile of"},
        Harm{"HugeReport", [](JobHeader& h) { h.report_bytes = ~std::uint64_t{0}; }, "a report of"},
        Harm{"ProfileOffset", [](JobHeader& h) { h.profile_offset = 0; }, "do not stand where"},
        Harm{"ReportOffset", [](JobHeader& h) { h.report_offset = h.profile_offset; }, "do not stand where"},
        Harm{"HeightsOffset", [](JobHeader& h) { h.heights_offset += 4; }, "do not stand where"},
        Harm{"LeftOffset", [](JobHeader& h) { h.r_left_offset = ~std::uint64_t{0} - 7; },
             "do not stand where"},
        Harm{"RightOffset", [](JobHeader& h) { h.r_right_offset = h.r_left_offset; }, "do not stand where"},
        Harm{"Joining", [](JobHeader& h) { h.joining = 3; }, "unknown number 3"},
        Harm{"SignZero", [](JobHeader& h) { h.direction_sign[2] = 0; }, "direction sign is 0"},
        Harm{"SignTwo", [](JobHeader& h) { h.direction_sign[0] = -2; }, "direction sign is -2"},
        Harm{"Passes", [](JobHeader& h) { h.pass_count = 1; }, "counts need"},
        Harm{"FeedZero", [](JobHeader& h) { h.feed_mm_s = 0.0; }, "feed"},
        Harm{"FeedNegative", [](JobHeader& h) { h.feed_mm_s = -1.0; }, "feed"},
        Harm{"FeedNan", [](JobHeader& h) { h.feed_mm_s = std::numeric_limits<double>::quiet_NaN(); }, "feed"},
        Harm{"FeedInf", [](JobHeader& h) { h.feed_mm_s = std::numeric_limits<double>::infinity(); }, "feed"},
        Harm{"SweepZero", [](JobHeader& h) { h.psi_sweep_pulses = 0; }, "sweeps 0 pulses"},
        Harm{"SweepHuge", [](JobHeader& h) { h.psi_sweep_pulses = std::numeric_limits<std::int64_t>::max(); },
             "sweeps 9223372036854775807 pulses"},
        Harm{"NameEndless", [](JobHeader& h) { std::memset(h.source_name, 'x', sizeof h.source_name); },
             "does not end"},
        Harm{"NameEscape", [](JobHeader& h) { h.source_name[0] = '\x1b'; }, "control character"}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(JobView, RefusesEveryTruncation) {
    const auto blob = job_blob_from_table(small_job({}, 1, 2));
    for (std::size_t length = 0; length < blob.size(); ++length) {
        EXPECT_FALSE(JobView::check(std::span(blob).first(length))) << length;
    }
    auto longer = blob;
    longer.resize(blob.size() + 8);
    EXPECT_FALSE(JobView::check(longer));
}

TEST(JobView, RefusesABlobAtAnOddAddress) {
    const auto blob = job_blob_from_table(small_job());
    std::vector<std::byte> shifted(blob.size() + 1);
    std::memcpy(shifted.data() + 1, blob.data(), blob.size());
    const auto view = JobView::check(std::span(shifted).subspan(1));
    ASSERT_FALSE(view);
    EXPECT_THAT(view.error().message, HasSubstr("multiple of 8"));
}

TEST(JobView, WhateverItAcceptsLiesInsideTheBlob) {
    const auto good = job_blob_from_table(small_job());
    std::mt19937 random(77);
    int accepted = 0;
    for (int round = 0; round < 20'000; ++round) {
        auto blob = good;
        const auto flips = 1 + random() % 3;
        for (unsigned i = 0; i < flips; ++i) {
            blob[random() % sizeof(JobHeader)] = static_cast<std::byte>(random() & 0xFF);
        }
        const auto view = JobView::check(blob);
        if (!view) continue;
        ++accepted;
        const std::byte* const end = blob.data() + blob.size();
        const auto last_row = view->r_right_pulses(view->layer_count() - 1);
        ASSERT_LE(static_cast<const void*>(last_row.data() + last_row.size()), static_cast<const void*>(end));
        ASSERT_GE(static_cast<const void*>(view->profile_toml().data()),
                  static_cast<const void*>(blob.data() + sizeof(JobHeader)));
        (void)view->max_radius_pulses(Axis::r1);
    }
    EXPECT_GT(accepted, 0);
}

TEST(JobProfile, ATextThatIsNoProfileIsRefused) {
    JobTable table = small_job();
    table.profile_toml = "[job]\nfeed = 1\n";
    const auto blob = job_blob_from_table(table);
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view);
    const auto profile = job_profile(*view);
    ASSERT_FALSE(profile);
    EXPECT_THAT(profile.error().message, HasSubstr("job's profile:2: job.feed: unknown key"));
}

TEST(TableAngle, GrowsOnAcrossLayersWhenContinuous) {
    EXPECT_EQ(table_angle_pulses(Joining::continuous, 3200, 5, 0, 0), 0);
    EXPECT_EQ(table_angle_pulses(Joining::continuous, 3200, 5, 0, 4), 3200);
    EXPECT_EQ(table_angle_pulses(Joining::continuous, 3200, 5, 1, 0), 3200);
    EXPECT_EQ(table_angle_pulses(Joining::continuous, 3200, 5, 7, 1), 7 * 3200 + 800);
    EXPECT_EQ(table_angle_pulses(Joining::continuous, 50'000'000, 1'000'000, 999'999, 999'999),
              50'000'000LL * 1'000'000);
}

TEST(TableAngle, StaysWithinOneSweepWhenZigzag) {
    EXPECT_EQ(table_angle_pulses(Joining::zigzag, 3200, 5, 1, 0), 0);
    EXPECT_EQ(table_angle_pulses(Joining::zigzag, 3200, 5, 1, 4), 3200);
}

TEST(CarvedPoint, RunsOddLayersBackwardsWhenZigzag) {
    EXPECT_EQ(carved_point(Joining::zigzag, 5, 0, 1), 1U);
    EXPECT_EQ(carved_point(Joining::zigzag, 5, 1, 0), 4U);
    EXPECT_EQ(carved_point(Joining::zigzag, 5, 1, 4), 0U);
    EXPECT_EQ(carved_point(Joining::continuous, 5, 1, 1), 1U);
}

TEST(TableAngle, GrowsOnAcrossTheRowsOfASpiral) {
    EXPECT_EQ(table_angle_pulses(Joining::spiral, 3200, 5, 7, 1), 7 * 3200 + 800);
}

TEST(TableHeight, IsTheLayersOwnButForTheRisingRowsOfASpiral) {
    const std::vector<std::int64_t> heights{100, 110, 125, 125};
    const auto row = [&](Joining joining, std::size_t layer) {
        std::vector<std::int64_t> y;
        for (std::int64_t point = 0; point < 5; ++point) {
            y.push_back(table_height_pulses(joining, heights, 5, layer, point));
        }
        return y;
    };
    EXPECT_THAT(row(Joining::continuous, 1), testing::Each(110));
    EXPECT_THAT(row(Joining::zigzag, 2), testing::Each(125));
    EXPECT_THAT(row(Joining::spiral, 0), testing::Each(100));
    EXPECT_THAT(row(Joining::spiral, 1), testing::ElementsAre(100, 103, 105, 108, 110));
    EXPECT_THAT(row(Joining::spiral, 2), testing::ElementsAre(110, 114, 118, 121, 125));
    EXPECT_THAT(row(Joining::spiral, 3), testing::Each(125));
}

TEST(JobView, SaysWhereASpiralsPointsStandAndWhichItHasReachedBefore) {
    const auto blob = job_blob_from_table(spiral_of(small_job()));
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view);
    EXPECT_EQ(view->joining(), Joining::spiral);
    EXPECT_EQ(view->y_pulses(1, 1), 103);
    EXPECT_EQ(view->y_pulses(1, 4), 110);
    EXPECT_FALSE(view->is_joint(0, 0));
    EXPECT_TRUE(view->is_joint(1, 0));
    EXPECT_FALSE(view->is_joint(1, 4));
}

TEST(JobView, RefusesHeightsOfASpiralThatNoSumCouldHold) {
    for (const std::int64_t height :
         {kMaxHeightPulses + 1, -kMaxHeightPulses - 1, std::numeric_limits<std::int64_t>::min()}) {
        JobTable table = spiral_of(small_job());
        table.layer_height_pulses[1] = height;
        const auto view = JobView::check(job_blob_from_table(table));
        ASSERT_FALSE(view);
        EXPECT_THAT(view.error().message, HasSubstr("the height of " + std::to_string(height) + " pulses"));
    }
}

}  // namespace
}  // namespace psicarve
