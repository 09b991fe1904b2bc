// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/soft_limits.hpp"

#include <gtest/gtest.h>

#include <random>

#include "rtcore/plan/cycle_config_from_profile.hpp"

namespace psicarve::cycle {
namespace {

using Pulses4 = std::array<std::int64_t, kAxisCount>;

SoftLimits limits_of(const Profile& profile) {
    return plan::cycle_config_from_profile(profile).soft_limits;
}

/// The default machine with short travels, heads of different scale and tip offsets.
Profile uneven_profile() {
    Profile profile;
    profile.r1.travel_mm = {0.5, 9.0};
    profile.r1.home_position_mm = 9.0;
    profile.r1.tip_offset_mm = 0.25;
    profile.r2.pulses_per_mm = 333.0;
    profile.r2.travel_mm = {2.0, 9.0};
    profile.r2.home_position_mm = 8.5;
    profile.r2.tip_offset_mm = -0.5;
    profile.y.travel_mm = {0.0, 5.0};
    profile.head_clearance_mm = 6.0;
    return profile;
}

TEST(SoftLimits, EachIsNamedWithItsAxis) {
    const SoftLimits sut = limits_of(Profile{});
    const Pulses4 from{8000, 8000, 0, 4000};
    const auto breach = [&](Pulses4 to) { return first_breach(sut, from, to); };
    EXPECT_EQ(breach({8000, 24001, 0, 4000}).limit, SoftLimit::travel);
    EXPECT_EQ(breach({8000, 24001, 0, 4000}).axis, 1);
    EXPECT_EQ(breach({8000, 8000, 0, -1}).limit, SoftLimit::travel);
    EXPECT_EQ(breach({8000, 8000, 0, -1}).axis, 3);
    EXPECT_EQ(breach({599, 8000, 0, 4000}).limit, SoftLimit::core_radius);
    EXPECT_EQ(breach({8000, 599, 0, 4000}).axis, 1);
    EXPECT_EQ(breach({600, 8000, 6400 * 1000, 60'000}).limit, SoftLimit::none);
    Profile wide_heads;
    wide_heads.head_clearance_mm = 10.0;
    const SoftLimits wide = limits_of(wide_heads);
    EXPECT_EQ(first_breach(wide, from, {2000, 1998, 0, 4000}).limit, SoftLimit::head_clearance);
    EXPECT_EQ(first_breach(wide, from, {8000, 8000, 0, 4000}).limit, SoftLimit::none);
    EXPECT_EQ(first_breach(wide, {2000, 8000, 0, 0}, {2000, 1900, 0, 0}).axis, 1);
}

TEST(SoftLimits, TheClearanceCountsFromEachHeadsOwnTip) {
    for (const bool is_r1_longer : {false, true}) {
        Profile profile;
        profile.core_radius_mm = 0.5;
        profile.head_clearance_mm = 3.0;
        (is_r1_longer ? profile.r1 : profile.r2).tip_offset_mm = 0.5;
        (is_r1_longer ? profile.r2 : profile.r1).tip_offset_mm = -0.25;
        const SoftLimits sut = limits_of(profile);
        const Pulses4 from{8000, 8000, 0, 4000};
        // 2.75 mm between the heads, less the rounding of both to pulses.
        EXPECT_EQ(first_breach(sut, from, {550, 549, 0, 4000}).limit, SoftLimit::none);
        EXPECT_EQ(first_breach(sut, from, {549, 549, 0, 4000}).limit, SoftLimit::head_clearance);
    }
}

// A breach that is there already and gets no worse is none: the way back must be open.
TEST(SoftLimits, APlaceOutsideMayBeLeftTowardsTheInside) {
    const SoftLimits sut = limits_of(Profile{});
    const Pulses4 inside_core{300, 8000, 0, -50};
    EXPECT_EQ(first_breach(sut, inside_core, {400, 8000, 0, -20}).limit, SoftLimit::none);
    EXPECT_EQ(first_breach(sut, inside_core, {299, 8000, 0, -50}).limit, SoftLimit::core_radius);
    EXPECT_EQ(first_breach(sut, inside_core, {300, 8000, 0, -51}).limit, SoftLimit::travel);
}

TEST(SoftLimits, TheFurthestGoodPositionIsGoodAndTheNextOneIsNot) {
    std::mt19937_64 random{17};
    const SoftLimits sut = limits_of(uneven_profile());
    const auto between = [&](std::int64_t least, std::int64_t most) {
        return least + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(most - least + 1));
    };
    int tested = 0;
    for (int round = 0; round < 4000; ++round) {
        Pulses4 from{};
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            from[k] = k == 2 ? between(-9000, 9000) : between(sut.least_pulses[k], sut.most_pulses[k]);
        }
        // From a good place: nothing there is breached.
        const double sum = static_cast<double>(from[0]) * sut.mm_per_pulse[0] +
                           static_cast<double>(from[1]) * sut.mm_per_pulse[1];
        if (from[0] < sut.core_pulses[0] || from[1] < sut.core_pulses[1] || sum < sut.least_sum_mm) continue;
        ++tested;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            for (const bool up : {false, true}) {
                Pulses4 to = from;
                to[k] = furthest_pulses(sut, from, k, up);
                ASSERT_EQ(first_breach(sut, from, to).limit, SoftLimit::none) << k << up << round;
                if (k == 2) continue;
                to[k] += up ? 1 : -1;
                ASSERT_NE(first_breach(sut, from, to).limit, SoftLimit::none) << k << up << round;
            }
        }
    }
    EXPECT_GT(tested, 1000);
}

TEST(SoftLimits, BothHeadsGoEquallyFarAndAsFarAsTheyMay) {
    std::mt19937_64 random(91);
    const SoftLimits sut = limits_of(uneven_profile());
    for (int round = 0; round < 2000; ++round) {
        Pulses4 from{};
        for (std::size_t k = 0; k < 2; ++k) {
            const auto span = static_cast<std::uint64_t>(sut.most_pulses[k] - sut.least_pulses[k]);
            from[k] = sut.least_pulses[k] + static_cast<std::int64_t>(random() % span);
        }
        for (const bool out : {true, false}) {
            const Pulses4 to = furthest_of_heads(sut, from, out);
            ASSERT_EQ(first_breach(sut, from, to).limit, SoftLimit::none);
            double way_mm[2];
            for (std::size_t k = 0; k < 2; ++k) {
                way_mm[k] = static_cast<double>(to[k] - from[k]) * sut.mm_per_pulse[k];
                ASSERT_GE(out ? way_mm[k] : -way_mm[k], 0.0);
            }
            ASSERT_NEAR(way_mm[0], way_mm[1], 0.004) << "a pulse";
            Pulses4 further = to;
            for (std::size_t k = 0; k < 2; ++k) further[k] += out ? 2 : -2;
            ASSERT_NE(first_breach(sut, from, further).limit, SoftLimit::none);
        }
    }
}

}  // namespace
}  // namespace psicarve::cycle
