// SPDX-License-Identifier: GPL-3.0-or-later
// Which points of roughing passes are air.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "tests/shared/job_fixture.hpp"
#include "tests/shared/passes_fixture.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;

/// Three roughing layers of five points, of three of finishing; air at random in the former.
JobTable job_with_air(std::uint64_t seed) {
    JobTable table = small_job({}, 6);
    table.layer_height_pulses = {100, 120, 100, 100, 110, 120};
    set_passes(table, {2, 1, 3});
    std::mt19937_64 random(seed);
    table.air.assign(30, 0);
    for (std::size_t i = 0; i < 15; ++i) table.air[i] = static_cast<std::uint8_t>(random() % 2);
    table.air[seed % 15] = 1;
    return table;
}

constexpr std::size_t kAirBytes = 8;  // of 30 points, in whole words

TEST(JobAir, ComesBackAsItWasPut) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const JobTable table = job_with_air(seed);
        const auto blob = job_blob_from_table(table);
        EXPECT_EQ(blob.size(),
                  job_blob_bytes(6, 5, table.profile_toml.size(), table.report_json.size(), 3, true));
        const auto view = JobView::check(blob);
        ASSERT_TRUE(view) << view.error().message;
        EXPECT_TRUE(view->has_air());
        for (std::uint32_t layer = 0; layer < 6; ++layer) {
            for (std::uint32_t point = 0; point < 5; ++point)
                EXPECT_EQ(view->is_air(layer, point), table.air[layer * 5 + point] != 0);
        }
        EXPECT_TRUE(check_job(*view, {}));
    }
}

TEST(JobAir, WhereThereIsNoneTheBlobIsWhatItWas) {
    JobTable table = job_with_air(1);
    table.air.assign(30, 0);
    const auto with_zeros = job_blob_from_table(table);
    table.air.clear();
    const auto without = job_blob_from_table(table);
    EXPECT_EQ(with_zeros, without);
    EXPECT_EQ(without.size(), job_blob_bytes(6, 5, table.profile_toml.size(), table.report_json.size(), 3));
    const auto view = JobView::check(without);
    ASSERT_TRUE(view);
    EXPECT_FALSE(view->has_air());
    EXPECT_FALSE(view->is_air(0, 0));
}

/// The message with which a damaged blob is refused, or nothing.
std::string refusal(const std::vector<std::byte>& blob) {
    const auto view = JobView::check(blob);
    return view ? std::string{} : view.error().message;
}

TEST(JobAir, InTheFinishingPassIsRefused) {
    const auto good = job_blob_from_table(job_with_air(2));
    const std::size_t begin = good.size() - kAirBytes;
    for (std::size_t bit = 0; bit < 8 * kAirBytes; ++bit) {
        auto blob = good;
        blob[begin + bit / 8] |= std::byte{1} << (bit % 8);
        if (bit < 15) {
            EXPECT_EQ(refusal(blob), "") << bit;
        } else {
            EXPECT_THAT(refusal(blob), HasSubstr("it has air from layer 3 on")) << bit;
        }
    }
}

TEST(JobAir, OfAnotherSizeIsRefused) {
    const auto good = job_blob_from_table(job_with_air(3));
    const auto header = [](std::vector<std::byte>& blob) {
        return reinterpret_cast<JobHeader*>(blob.data());
    };
    for (const int more : {-16, -8, 8, 16}) {
        auto blob = good;
        blob.resize(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(good.size()) + more));
        header(blob)->total_bytes = blob.size();
        EXPECT_THAT(refusal(blob), HasSubstr("its counts need " + std::to_string(good.size()))) << more;
    }
    auto blob = good;
    header(blob)->has_air = 0;
    EXPECT_THAT(refusal(blob), HasSubstr("its counts need " + std::to_string(good.size() - kAirBytes)));
    header(blob)->has_air = 2;
    EXPECT_THAT(refusal(blob), HasSubstr("whether it has air is the unknown number 2"));
    auto without = job_blob_from_table(small_job());
    header(without)->has_air = 1;
    EXPECT_THAT(refusal(without), HasSubstr("its counts need"));
}

TEST(JobAir, OfAJobOfOnePassIsRefused) {
    JobTable table = small_job();
    table.air.assign(15, 0);
    table.air[3] = 1;
    EXPECT_THAT(refusal(job_blob_from_table(table)), HasSubstr("it has air from layer 0 on"));
}

}  // namespace
}  // namespace psicarve
