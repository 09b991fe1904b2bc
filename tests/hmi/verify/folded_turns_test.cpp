// SPDX-License-Identifier: GPL-3.0-or-later
// Turns of a circle that go over the same places are looked at once.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hmi/verify/program/programmed_way.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {
namespace {

constexpr WayTolerance kTolerance{0.05, 1.5};

/// R1 and Y on a circle of some turns, from its rightmost place on. Not folded: its radius changes by nothing
/// that a place could tell.
class TurnedWay {
public:
    TurnedWay(double radius_mm, double turns, bool is_folded)
        : radius_mm_(radius_mm), turns_(turns), way_{scale_, begin(), end(), arc(is_folded)} {}

    const ProgrammedWay& way() const { return way_; }
    /// The pulses nearest to a place of the circle, some of them off.
    Positions near(double share, double off_r_mm = 0.0, double off_y_mm = 0.0) const {
        const double angle_rad = 2.0 * kPi * turns_ * share;
        return {pulses(kCentre_mm + radius_mm_ * std::cos(angle_rad) + off_r_mm), pulses(41.0), 0,
                pulses(kHeight_mm + radius_mm_ * std::sin(angle_rad) + off_y_mm)};
    }

private:
    static constexpr double kCentre_mm = 40.0;
    static constexpr double kHeight_mm = 10.0;
    double per_mm() const { return scale_.pulses_per_unit[index_of(Axis::y)]; }
    std::int64_t pulses(double mm) const { return round_to_pulse(mm * per_mm()); }
    Place place(double angle_rad) const {
        return {(kCentre_mm + radius_mm_ * std::cos(angle_rad)) * per_mm(), 41.0 * per_mm(), 0.0,
                (kHeight_mm + radius_mm_ * std::sin(angle_rad)) * per_mm()};
    }
    Place begin() const { return place(0.0); }
    Place end() const { return place(2.0 * kPi * turns_); }
    WayArc arc(bool is_folded) const {
        constexpr double kNothing_mm = 1e-12;
        return {{true, false},
                kCentre_mm,
                kHeight_mm,
                radius_mm_,
                radius_mm_ + (is_folded ? 0.0 : kNothing_mm),
                0.0,
                2.0 * kPi * turns_};
    }

    WayScale scale_{Profile{}};
    double radius_mm_;
    double turns_;
    ProgrammedWay way_;
};

// Circles within the tolerance and larger ones, whole turns and parts; places on them, off them and far away.
TEST(FoldedTurns, SayWhatAllTurnsSay) {
    std::mt19937 random{45};
    std::uniform_real_distribution<double> radii_mm{0.004, 0.08};
    std::uniform_real_distribution<double> any{0.0, 1.0};
    for (int n = 0; n < 60; ++n) {
        const double radius_mm = radii_mm(random);
        const double turns = n % 2 == 0 ? 1.0 + n % 5 : 1.0 + 4.0 * any(random);
        const TurnedWay folded{radius_mm, turns, true};
        const TurnedWay unfolded{radius_mm, turns, false};
        Reach reach{{0.0, 0.0}};
        Reach all{{0.0, 0.0}};
        for (int step = 0; step <= 40; ++step) {
            const double off_mm = n % 3 == 0 ? 0.0 : 0.06 * (any(random) - 0.5);
            const Positions at = folded.near(step / 40.0, off_mm, -off_mm);
            const bool goes_on = folded.way().go_on(0, at, kTolerance, reach);
            ASSERT_EQ(goes_on, unfolded.way().go_on(0, at, kTolerance, all)) << radius_mm << " " << turns;
            ASSERT_EQ(reach.size(), all.size()) << radius_mm << " " << turns;
            for (std::size_t i = 0; i < reach.size(); ++i) {
                ASSERT_NEAR(reach[i].least, all[i].least, 1e-6) << radius_mm << " " << turns;
                ASSERT_NEAR(reach[i].most, all[i].most, 1e-6) << radius_mm << " " << turns;
            }
            const ShareRange range{0.3 * any(random), 1.0 - 0.3 * any(random)};
            const auto last = folded.way().last_near(0, at, kTolerance, range);
            const auto last_of_all = unfolded.way().last_near(0, at, kTolerance, range);
            ASSERT_EQ(last.has_value(), last_of_all.has_value()) << radius_mm << " " << turns;
            // Places are known to a part of a pulse.
            const double pulse_share = 0.0025 / (2.0 * kPi * radius_mm * turns);
            if (last) {
                ASSERT_NEAR(*last, *last_of_all, pulse_share) << radius_mm << " " << turns;
            }
            const bool is_one = folded.way().from_one_place_within_mm(at, kTolerance, range) <= kTolerance.mm;
            ASSERT_EQ(is_one,
                      unfolded.way().from_one_place_within_mm(at, kTolerance, range) <= kTolerance.mm);
        }
    }
}

// Places are as many as turns: a look at each turn from each place would be the square of that.
TEST(FoldedTurns, AreLookedAtOnce) {
    const auto looks_at_each = [](double turns) {
        const TurnedWay sut{0.02, turns, true};
        Reach reach{{0.0, 0.0}};
        const int places = static_cast<int>(turns) * 8;
        for (int n = 0; n <= places; ++n)
            EXPECT_TRUE(sut.way().go_on(0, sut.near(static_cast<double>(n) / places), kTolerance, reach));
        EXPECT_EQ(reach.back().most, 1.0);
        return static_cast<double>(sut.way().places_looked_at()) / places;
    };
    EXPECT_LT(looks_at_each(400), 2.0 * looks_at_each(4));
}

}  // namespace
}  // namespace psicarve::verify
