// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "rtcore/cycle/fine_dda.hpp"
#include "rtcore/cycle/fine_move.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::int64_t kPulse = FineDda::kUnitsPerPulse;
using Pulses4 = std::array<std::int64_t, kAxisCount>;

TEST(FineDda, LosesNothingToDivision) {
    std::mt19937_64 random{7};
    for (int round = 0; round < 200; ++round) {
        FineDda sut;
        std::int64_t emitted = 0;
        std::int64_t given = 0;
        const std::int64_t ticks = 1 + static_cast<std::int64_t>(random() % 97);
        sut.start(ticks);
        for (int period = 0; period < 500; ++period) {
            const auto increment =
                static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(ticks * kPulse / 2));
            given += increment;
            sut.set_increments({increment, 0, 0, 0}, ticks);
            for (std::int64_t tick = 0; tick < ticks; ++tick) {
                sut.tick();
                if (sut.due() == 0) continue;
                ASSERT_EQ(sut.due(), 1U);
                sut.take(0);
                ++emitted;
            }
            const double error = static_cast<double>(given) / kPulse - static_cast<double>(emitted);
            ASSERT_GT(error, -1e-4) << "period " << period;
            ASSERT_LT(error, 1.0) << "period " << period;
        }
    }
}

TEST(FineDda, SpreadsThePulsesOfAPeriodEvenly) {
    FineDda sut;
    sut.start(100);
    sut.set_increments({5 * kPulse, 0, 0, 0}, 100);
    std::vector<int> at;
    for (int tick = 1; tick <= 100; ++tick) {
        sut.tick();
        if (sut.due() == 0) continue;
        sut.take(0);
        at.push_back(tick);
    }
    EXPECT_EQ(at, (std::vector<int>{20, 40, 60, 80, 100}));
}

struct Course {
    Pulses4 emitted{};
    std::int64_t ticks = 0;
    std::vector<std::int64_t> ticks_of_first_axis;
};

Course run(FineMove& sut, std::int64_t most_ticks) {
    Course course;
    while (!sut.is_finished() && course.ticks < most_ticks) {
        sut.tick(false);
        ++course.ticks;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if ((sut.due() >> k & 1U) == 0) continue;
            sut.take(k);
            ++course.emitted[k];
            if (k == 0) course.ticks_of_first_axis.push_back(course.ticks);
        }
    }
    return course;
}

TEST(FineMove, EveryAxisGetsExactlyItsPulsesAndNoMore) {
    std::mt19937_64 random{11};
    for (int round = 0; round < 3000; ++round) {
        Pulses4 delta{};
        const std::uint64_t scale = std::uint64_t{1} << (random() % 14);
        for (auto& way : delta)
            way = static_cast<std::int64_t>(random() % (2 * scale + 1)) - static_cast<std::int64_t>(scale);
        FineMove sut;
        sut.start(delta, 0.02, 0.45, 0.0003);
        const Course course = run(sut, 4'000'000);
        for (std::size_t k = 0; k < kAxisCount; ++k)
            ASSERT_EQ(course.emitted[k], std::abs(delta[k])) << round;
        ASSERT_EQ(sut.due(), 0U);
    }
}

TEST(FineMove, AxesArriveTogetherAndStayOnTheLine) {
    FineMove sut;
    sut.start({4000, -1000, 2500, 0}, 0.02, 0.4, 0.0002);
    Pulses4 emitted{};
    while (!sut.is_finished()) {
        sut.tick(false);
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if ((sut.due() >> k & 1U) == 0) continue;
            sut.take(k);
            ++emitted[k];
        }
        const auto share = static_cast<double>(emitted[0]) / 4000.0;
        ASSERT_NEAR(static_cast<double>(emitted[1]), 1000.0 * share, 1.01);
        ASSERT_NEAR(static_cast<double>(emitted[2]), 2500.0 * share, 1.51);
    }
}

TEST(FineMove, NeverExceedsTopSpeedNorAcceleration) {
    constexpr double kTop = 0.25;
    constexpr double kAccel = 0.0001;
    FineMove sut;
    sut.start({20'000, 0, 0, 0}, 0.01, kTop, kAccel);
    const Course course = run(sut, 1'000'000);
    std::vector<std::int64_t> count(static_cast<std::size_t>(course.ticks) + 1, 0);
    for (const std::int64_t tick : course.ticks_of_first_axis) ++count[static_cast<std::size_t>(tick)];
    for (std::size_t i = 1; i < count.size(); ++i) count[i] += count[i - 1];
    for (const std::size_t window : {100U, 400U, 1000U}) {
        const auto w = static_cast<double>(window);
        for (std::size_t i = window; i + window < count.size(); ++i) {
            const std::int64_t bend = count[i + window] - 2 * count[i] + count[i - window];
            ASSERT_LE(std::abs(static_cast<double>(bend)), kAccel * w * w + 2.0);
            ASSERT_LE(static_cast<double>(count[i + window] - count[i]), kTop * w + 1.0);
        }
    }
}

TEST(FineMove, SlowsDownWhenAskedAndGoesOnWithoutLosingAPulse) {
    std::mt19937_64 random{5};
    for (int round = 0; round < 300; ++round) {
        FineMove sut;
        sut.start({3000, 700, 0, -2999}, 0.02, 0.4, 0.0005);
        Pulses4 emitted{};
        std::int64_t slow_from = static_cast<std::int64_t>(random() % 12'000);
        for (std::int64_t tick = 0; !sut.is_finished(); ++tick) {
            ASSERT_LT(tick, 1'000'000);
            const bool must_slow = tick >= slow_from;
            if (must_slow && sut.is_slowest()) {
                sut.rest();
                slow_from = tick + 1 + static_cast<std::int64_t>(random() % 5000);
            }
            sut.tick(must_slow);
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                if ((sut.due() >> k & 1U) == 0) continue;
                sut.take(k);
                ++emitted[k];
            }
        }
        EXPECT_EQ(emitted, (Pulses4{3000, 700, 0, 2999}));
    }
}

TEST(FineMove, WithoutAWayIsFinishedAtOnce) {
    FineMove sut;
    sut.start({}, 0.02, 0.4, 0.0005);
    EXPECT_TRUE(sut.is_finished());
}

}  // namespace
}  // namespace psicarve::cycle
