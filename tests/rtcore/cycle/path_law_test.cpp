// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/path_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/rtcore/cycle/path_rig.hpp"
#include "tests/rtcore/cycle/timed_curve.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::cycle {
namespace {

constexpr double kSlack = 1.0 + 1e-6;
constexpr double kStandingSpeed2 = 1e-14;  // where a profile all but touches 0

/// Drives a law along a curve and judges every tick.
class Drive {
public:
    explicit Drive(const TimedCurve& curve) : curve_(curve), law_(kPathTick_s) {}

    /// From the segment at hand, or from the begin, to this one is all that is queued.
    void queue_up_to(std::size_t segments) {
        queued_ = segments;
        rest2_ = curve_.rest_speed2(segments);
        law_.cap(true);
    }
    void queue_all() {
        queued_ = 0;
        law_.cap(false);
    }
    /// It has come to the end of what is queued.
    void go_on() {
        queue_all();
        law_.start_again(curve_.blocks()[segment].path);
        jumped_ = true;
        remember();
    }
    bool is_capped() const { return queued_ > 0; }

    void start() {
        law_.start(path_at(0));
        jumped_ = true;
        remember();
    }
    void aim(double feed_ratio) {
        const bool rested = resting;
        law_.aim(feed_ratio);
        feed = feed_ratio;
        has_met_ = false;
        if (rested && feed_ratio > 0.0) {
            resting = false;
            jumped_ = true;
        }
    }
    /// False at the curve's end, or that of what is queued.
    bool tick() {
        ++ticks;
        if (feed == 0.0 && law_.is_slowest()) {
            law_.rest();
            resting = true;
            jumped_ = true;
            remember();
            return true;
        }
        law_.tick();
        while (law_.is_at_end()) {
            ++segment;
            if (segment == curve_.segments() || segment == queued_) return false;
            law_.next(path_at(segment));
        }
        judge();
        remember();
        return true;
    }
    double speed() const { return law_.speed(); }
    double target2() const {
        const double low = curve_.speed2(0, segment, law_.way());
        const double high = curve_.speed2(1, segment, law_.way());
        const double square = feed * feed;
        return square <= 1.0 ? square * low : low + (square - 1.0) / 3.0 * (high - low);
    }

    std::size_t segment = 0;
    std::uint64_t ticks = 0;
    double feed = 1.0;
    bool resting = false;
    double most_speed = 0.0;  ///< as parts of the limits
    double most_accel = 0.0;

private:
    PathTiming path_at(std::size_t at) const {
        PathTiming path = curve_.blocks()[at].path;
        const double per_s2 = 1.0 / (kPathTick_s * kPathTick_s);
        if (queued_ > 0) path.rest_speed2 = {rest2_[at] * per_s2, rest2_[at + 1] * per_s2};
        return path;
    }
    void judge() {
        const CurveLimits& limits = curve_.limits();
        const Axis4 slope = curve_.slope(segment, law_.way());
        const double speed2 = law_.speed() * law_.speed();
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const double axis_speed = slope[k] * law_.speed();
            const double accel = slope[k] * law_.accel() + curve_.bend(segment)[k] * speed2;
            const double change = std::fabs(axis_speed - axis_speed_[k]);
            const double jump = jumped_ ? limits.jump[k] : 0.0;
            most_speed = std::max(most_speed, std::fabs(axis_speed) / limits.speed[k]);
            most_accel = std::max(most_accel, std::fabs(accel) / limits.accel[k]);
            ASSERT_LE(std::fabs(axis_speed), limits.speed[k] * kSlack) << "axis " << k << " tick " << ticks;
            ASSERT_LE(std::fabs(accel), limits.accel[k] * kSlack) << "axis " << k << " tick " << ticks;
            ASSERT_LE(change, (limits.accel[k] + jump) * kSlack) << "axis " << k << " tick " << ticks;
        }
        jumped_ = false;
        ASSERT_LE(speed2, curve_.speed2(1, segment, law_.way()) * kSlack + kStandingSpeed2)
            << "tick " << ticks;
        if (queued_ > 0) {
            const double part = law_.way() / curve_.blocks()[segment].path.length;
            const double rest2 = rest2_[segment] + (rest2_[segment + 1] - rest2_[segment]) * part;
            ASSERT_LE(speed2, rest2 * kSlack + kStandingSpeed2) << "tick " << ticks;
        }
        if (has_met_) {
            ASSERT_LE(speed2, target2() * kSlack + kStandingSpeed2) << "tick " << ticks;
        }
        has_met_ = has_met_ || (feed > 0.0 && speed2 <= target2());
    }
    void remember() {
        const Axis4 slope = curve_.slope(segment, law_.way());
        for (std::size_t k = 0; k < kAxisCount; ++k) axis_speed_[k] = slope[k] * law_.speed();
    }

    const TimedCurve& curve_;
    PathLaw law_;
    Axis4 axis_speed_{};
    bool jumped_ = false;
    bool has_met_ = false;
    std::size_t queued_ = 0;     ///< segments; 0: all
    std::vector<double> rest2_;  ///< at their nodes
};

CurveLimits random_limits(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    CurveLimits limits;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        limits.speed[k] = 0.1 + 0.3 * part(random);
        limits.accel[k] = 3e-5 + 3e-4 * part(random);
        limits.jump[k] = 0.005 + 0.03 * part(random);
    }
    if (seed % 3 != 0) limits.feed = 0.05 + 0.2 * part(random);
    return limits;
}

/// One of: hold, resume or another feed.
double random_feed(std::mt19937_64& random) {
    if (random() % 3 == 0) return 0.0;
    return static_cast<double>(10 + random() % 191) / 100.0;
}

TEST(PathLaw, KeepsEveryAxisWithinItsLimitsThroughAnyHoldResumeAndOverride) {
    double most_accel = 0.0;
    const std::uint64_t seeds = test::is_thorough() ? 60 : 12;
    for (std::uint64_t seed = 1; seed <= seeds && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        const TimedCurve curve(seed, 400, random_limits(seed));
        std::mt19937_64 random(seed);
        Drive sut(curve);
        sut.start();
        std::uint64_t until = random() % 2000;
        while (sut.tick() && !::testing::Test::HasFatalFailure()) {
            if (sut.ticks < until) continue;
            sut.aim(random_feed(random));
            until = sut.ticks + 1 + random() % (random() % 2 == 0 ? 100 : 4000);
            ASSERT_LT(sut.ticks, 20'000'000U);
        }
        EXPECT_EQ(sut.segment, curve.segments());
        most_accel = std::max(most_accel, sut.most_accel);
    }
    EXPECT_GT(most_accel, 0.999);
}

// Wherever what is queued ends: it rests there, or goes on in time, and no axis is asked for more than it
// has.
TEST(PathLaw, RestsWhereWhatIsQueuedEndsThroughAnyHoldResumeAndOverride) {
    const std::uint64_t seeds = test::is_thorough() ? 120 : 24;
    int rests = 0;
    for (std::uint64_t seed = 1; seed <= seeds && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        const TimedCurve curve(seed, 400, random_limits(seed));
        std::mt19937_64 random(seed);
        Drive sut(curve);
        sut.queue_up_to(40 + random() % 340);
        sut.start();
        const std::uint64_t lifted = seed % 2 == 0 ? 1000 + random() % 20'000 : ~std::uint64_t{0};
        std::uint64_t until = seed % 4 < 2 ? random() % 2000 : ~std::uint64_t{0};
        while (!::testing::Test::HasFatalFailure()) {
            if (!sut.tick()) {
                if (sut.segment == curve.segments()) break;
                ++rests;
                sut.go_on();
            }
            if (sut.is_capped() && sut.ticks >= lifted) sut.queue_all();
            if (sut.ticks >= until) {
                sut.aim(random_feed(random));
                until = sut.ticks + 1 + random() % (random() % 2 == 0 ? 100 : 4000);
            }
            ASSERT_LT(sut.ticks, 20'000'000U);
        }
        EXPECT_EQ(sut.segment, curve.segments());
    }
    EXPECT_GT(rests, 0);
}

// A straight line along one axis, 0.4 pulses a tick, feed-bound: speeds and times are those of the textbook.
TEST(PathLaw, ChangesSpeedFromTheNextTickOnAsFastAsTheAxisCan) {
    PathLaw sut(kPathTick_s);
    sut.start(path_block({}, 1e6, 0.2, 0.2).path);
    for (int n = 0; n < 100; ++n) sut.tick();
    EXPECT_DOUBLE_EQ(sut.speed(), 0.2);
    // Three hundredths are left for the pulses.
    constexpr double kAccel = 0.97e-4;
    for (const double feed : {0.5, 2.0, 1.5, 0.1, 1.0}) {
        const double before = sut.speed();
        const double after = 0.2 * feed;
        const double sign = after > before ? 1.0 : -1.0;
        const auto ticks = static_cast<int>(std::fabs(after - before) / kAccel);
        sut.aim(feed);
        for (int n = 1; n < ticks; ++n) {
            sut.tick();
            ASSERT_NEAR(sut.speed(), before + sign * kAccel * n, 1e-9) << "feed " << feed;
        }
        sut.tick();
        sut.tick();
        EXPECT_NEAR(sut.speed(), after, 1e-12) << "feed " << feed;
    }
    // From 0.2 down to the start-stop speed, 0.02; the way is (0.2^2 - 0.02^2) / 2a.
    const double from = sut.way();
    sut.aim(0.0);
    int ticks = 0;
    for (; !sut.is_slowest(); ++ticks) sut.tick();
    EXPECT_NEAR(ticks, 0.18 / kAccel, 1.0);
    EXPECT_NEAR(sut.way() - from, (0.04 - 0.0004) / (2.0 * kAccel), 0.1);
    sut.rest();
    EXPECT_EQ(sut.speed(), 0.0);
    sut.aim(1.0);
    EXPECT_NEAR(sut.speed(), 0.02, 1e-8);
    for (int n = 0; n < 1860; ++n) sut.tick();
    EXPECT_NEAR(sut.speed(), 0.2, 1e-12);
}

TEST(PathLaw, FollowsTheScaledProfileOnceItWasReached) {
    for (const double feed : {0.1, 0.35, 0.8, 1.0}) {
        const TimedCurve curve(5, 300, random_limits(5));
        Drive sut(curve);
        sut.aim(feed);
        sut.start();
        while (sut.tick()) {
            ASSERT_NEAR(sut.speed() * sut.speed() / sut.target2(), 1.0, 1e-7) << "segment " << sut.segment;
        }
    }
}

}  // namespace
}  // namespace psicarve::cycle
