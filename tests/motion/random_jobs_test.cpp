// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs of random shapes for random machines, carved through random holds, resumes and overrides, from random
// layers on, some of them dry: what a motor follows holds on the pins, and motors that have nothing to spare
// never stall.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "hmi/verify/verify_report.hpp"
#include "tests/motion/carving_bench.hpp"
#include "tests/motion/random_operator.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

/// Numbers of one seed.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    std::uint64_t below(std::uint64_t most) { return random_() % most; }
    bool one_in(std::uint64_t count) { return below(count) == 0; }
    double between(double least, double most) {
        return least + (most - least) * static_cast<double>(below(1'000'000)) * 1e-6;
    }
    /// As likely to be between 1 and 2 as between 2 and 4.
    double spread(double least, double most) { return least * std::pow(most / least, between(0.0, 1.0)); }

private:
    std::mt19937_64 random_;
};

enum class Kind { waves, jagged, teeth, cliffs, noise };
constexpr std::uint64_t kKinds = 5;

/// The radius over and over again as a row of knots, with waves on top.
Shape random_shape(Dice& dice) {
    const auto kind = static_cast<Kind>(dice.below(kKinds));
    std::vector<double> knots(8 + dice.below(90));
    double radius = 9.0;
    for (double& knot : knots) {
        if (kind == Kind::jagged) radius = std::clamp(radius + dice.between(-0.8, 0.8), 5.0, 13.0);
        if (kind == Kind::teeth) radius = dice.one_in(2) ? 10.0 : 8.5;
        if (kind == Kind::cliffs && dice.one_in(6)) radius = dice.between(4.0, 13.0);
        if (kind == Kind::noise) radius = 9.0 + dice.between(-0.1, 0.1);
        knot = radius;
    }
    const double blend = kind == Kind::jagged ? 1.0 : dice.spread(0.02, 1.0);
    const double wave_mm = kind == Kind::waves ? dice.between(0.2, 1.5) : dice.between(0.0, 0.05);
    const double ripple_mm = kind == Kind::waves ? dice.spread(0.005, 0.5) : 0.0;
    const double waves = 1.0 + static_cast<double>(dice.below(9));
    const double ripples = 5.0 + static_cast<double>(dice.below(40));
    return [=](double direction, std::uint32_t layer) {
        const double turns = direction / (2.0 * std::numbers::pi);
        const double along = (turns - std::floor(turns)) * static_cast<double>(knots.size());
        const auto knot = std::min(static_cast<std::size_t>(along), knots.size() - 1);
        const double part = std::clamp((along - static_cast<double>(knot)) / blend, 0.0, 1.0);
        const double from = knots[(knot + knots.size() - 1) % knots.size()];
        return from + (knots[knot] - from) * part + wave_mm * std::cos(waves * direction + 0.1 * layer) +
               ripple_mm * std::cos(ripples * direction);
    };
}

Profile random_profile(Dice& dice) {
    Profile profile = cycle::quick_profile();
    profile.job.planner = Planner::lookahead;
    if (dice.one_in(3)) profile.psi.pulses_per_rev = std::array{200, 400, 800, 1600}[dice.below(4)];
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->accel_mm_s2 = dice.spread(30.0, 600.0);
        axis->start_stop_mm_s = dice.spread(0.1, 2.0);
    }
    profile.psi.accel_deg_s2 = dice.spread(500.0, 6000.0);
    profile.job.feed_mm_s = dice.spread(3.0, 40.0);
    // Down to less than a pulse: there bands are as narrow as they may be.
    profile.job.path_tolerance_mm = dice.one_in(2) ? dice.spread(0.0002, 0.02) : dice.spread(0.002, 0.3);
    if (dice.one_in(4)) profile.r1.backlash_mm = profile.r2.backlash_mm = dice.between(0.01, 0.1);
    if (dice.one_in(6)) profile.psi.backlash_deg = 0.5;
    profile.job.lifts_on_hold = dice.one_in(8);
    profile.job.retract_mm = 0.5;
    return profile;
}

/// Motors that can do what the profile says and no more.
void leave_nothing_to_spare(sim::SimConfig& config) {
    for (sim::AxisConfig& axis : config.axes) {
        axis.motor.accel_pps2 /= sim::kAccelReserve_ratio;
        axis.motor.speed_pps /= sim::kSpeedReserve_ratio;
        axis.motor.start_stop_pps /= sim::kStartStopReserve_ratio;
    }
}

struct RandomJob {
    Profile profile;
    JobTable table;
    cycle::LayerRange layers;
};

RandomJob random_job_of(Dice& dice) {
    RandomJob job;
    job.profile = random_profile(dice);
    const auto joining =
        std::array{Joining::continuous, Joining::zigzag, Joining::spiral, Joining::spiral}[dice.below(4)];
    const auto points = static_cast<std::uint32_t>(dice.spread(20.0, 500.0));
    const auto layers = static_cast<std::uint32_t>(3 + dice.below(2));
    const auto most = static_cast<std::uint32_t>(job.profile.psi.pulses_per_rev / 2 + 1);
    job.table = table_of(job.profile, random_shape(dice), layers, std::min(points, most), joining);
    if (dice.one_in(3)) job.layers.first = static_cast<std::uint32_t>(dice.below(layers - 2));
    job.layers.is_dry = dice.one_in(10);
    return job;
}

TEST(RandomJobs, AreFollowedByMotorsThatHaveNothingToSpare) {
    const std::uint64_t seeds = !test::is_thorough() ? 4 : test::is_long_run() ? 400 : 24;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Dice dice(seed);
        const RandomJob job = random_job_of(dice);
        const Carved result = carved(job.profile, job.table, Operator(seed, 200 + dice.below(8000)),
                                     {leave_nothing_to_spare, job.layers});
        EXPECT_EQ(result.stalls, 0U) << "seed " << seed;
        // That a job is not carved from its first layer on is rule 1's to tell, and a dry run has no points.
        const bool is_whole = job.layers.first == 0 && !job.layers.is_dry;
        for (std::size_t rule = is_whole ? 0 : 1; rule < verify::kRuleCount; ++rule) {
            const verify::RuleResult& judged = result.report.rules[rule];
            EXPECT_TRUE(judged.judged) << "seed " << seed << ", rule " << rule + 1;
            EXPECT_EQ(judged.offences, 0U) << "seed " << seed << '\n' << verify::report_text(result.report);
        }
    }
}

/// Whether all that is wrong with a run that was stopped is that it ends.
bool only_ends_early(const verify::VerifyReport& report) {
    for (const verify::RuleResult& rule : report.rules) {
        const bool is_path = &rule == &report.rules[0];
        if (!rule.judged || rule.offences > (is_path ? 1U : 0U)) return false;
        if (rule.first && rule.first->fault != "ends-early") return false;
    }
    return true;
}

// Wherever the heads come to rest they stand no deeper than the job asks.
TEST(RandomJobs, AreStoppedInOrder) {
    const std::uint64_t seeds = !test::is_thorough() ? 4 : test::is_long_run() ? 400 : 24;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        Dice dice(seed);
        RandomJob job = random_job_of(dice);
        job.layers = {};
        const Stopper stopper(seed, 200 + dice.below(8000), 200'000);
        const Carved stopped = carved(job.profile, job.table, stopper, {leave_nothing_to_spare, {}});
        EXPECT_EQ(stopped.stalls, 0U) << "seed " << seed;
        EXPECT_TRUE(only_ends_early(stopped.report)) << "seed " << seed << '\n'
                                                     << verify::report_text(stopped.report);
    }
}

}  // namespace
}  // namespace psicarve::motion
