// SPDX-License-Identifier: GPL-3.0-or-later
// Two layers of each job of the motion benchmarks, as dense as they are carved there, through random
// sequences of hold, resume and override: thirty in a long run.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>

#include "hmi/verify/verify_report.hpp"
#include "tests/motion/carving_bench.hpp"
#include "tests/motion/random_operator.hpp"
#include "tests/places.hpp"
#include "tests/reference/table_csv.hpp"
#include "tests/shared/spiral_fixture.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

// Long enough for heads that go out and come back in between, too.
constexpr std::uint64_t kLongestSpan = 8000;
const std::uint64_t kStops = test::is_thorough() ? 6 : 1;
constexpr double kBacklash_mm = 0.05;
constexpr int kFiner = 10;

enum class Machine { plain, lifting, with_backlash, lifting_with_backlash, fine, coarse, spiral };

struct Case {
    const char* job;
    Machine machine;
};

Profile profile_of(Machine machine) {
    Profile profile = cycle::quick_profile();
    profile.job.planner = Planner::lookahead;
    profile.job.lifts_on_hold = machine == Machine::lifting || machine == Machine::lifting_with_backlash;
    profile.job.retract_mm = 0.5;
    if (machine == Machine::with_backlash || machine == Machine::lifting_with_backlash)
        profile.r1.backlash_mm = profile.r2.backlash_mm = kBacklash_mm;
    // Pulses a tenth, or ten times, as wide; the motors' speed in mm stays.
    if (machine == Machine::fine) {
        profile.tick.period_us = 10;
        profile.psi.pulses_per_rev *= kFiner;
    }
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        if (machine == Machine::fine) axis->pulses_per_mm *= kFiner;
        if (machine == Machine::coarse) axis->pulses_per_mm /= kFiner;
    }
    return profile;
}

JobTable table_for(const Case& of, const Profile& profile) {
    const std::string file = in_source("tests/motion/tables/") + of.job + ".csv";
    JobTable table = table_from_csv(file, profile).value();
    if (of.machine == Machine::spiral) return spiral_of(table);
    if (of.machine != Machine::fine && of.machine != Machine::coarse) return table;
    const bool is_fine = of.machine == Machine::fine;
    const auto scaled = [is_fine](auto& pulses) {
        for (auto& value : pulses) value = is_fine ? value * kFiner : value / kFiner;
    };
    scaled(table.r_left_pulses);
    scaled(table.r_right_pulses);
    scaled(table.layer_height_pulses);
    if (is_fine) table.psi_sweep_pulses *= kFiner;
    return table;
}

std::uint64_t rounds() {
    if (!test::is_thorough()) return 2;
    return test::is_long_run() ? 30 : 8;
}

class DisturbedTables : public ::testing::TestWithParam<Case> {};

TEST_P(DisturbedTables, ObeyTheFourRulesInTheSameOrder) {
    const Profile profile = profile_of(GetParam().machine);
    const JobTable table = table_for(GetParam(), profile);
    const Carved undisturbed = carved(profile, table);
    ASSERT_TRUE(undisturbed.report.ok) << verify::report_text(undisturbed.report);
    for (const verify::RuleResult& rule : undisturbed.report.rules) EXPECT_TRUE(rule.judged);
    for (std::uint64_t seed = 1; seed <= rounds(); ++seed) {
        const Carved disturbed = carved(profile, table, Operator(seed, kLongestSpan));
        EXPECT_TRUE(disturbed.report.ok) << "seed " << seed << '\n' << verify::report_text(disturbed.report);
        // Heads that go out and come back do so with pulses of their own.
        if (!profile.job.lifts_on_hold) {
            EXPECT_TRUE(disturbed.order == undisturbed.order) << "seed " << seed;
        }
    }
}

void expect_stops_in_order(const Case& of, std::uint64_t stops) {
    const Profile profile = profile_of(of.machine);
    const JobTable table = table_for(of, profile);
    for (std::uint64_t seed = 1; seed <= stops; ++seed) {
        const Carved stopped = carved(profile, table, Stopper(seed, kLongestSpan));
        EXPECT_LT(stopped.report.points_visited, stopped.report.points_total);
        for (std::size_t rule = 0; rule < stopped.report.rules.size(); ++rule) {
            const verify::RuleResult& result = stopped.report.rules[rule];
            EXPECT_EQ(result.offences, rule == 0 ? 1U : 0U) << "seed " << seed << '\n'
                                                            << verify::report_text(stopped.report);
            if (rule == 0 && result.first) {
                EXPECT_EQ(result.first->fault, "ends-early") << seed;
            }
        }
    }
}

TEST_P(DisturbedTables, AreStoppedInOrder) {
    expect_stops_in_order(GetParam(), kStops);
}

class StoppedTables : public ::testing::TestWithParam<Case> {};

TEST_P(StoppedTables, EndInOrder) {
    const std::uint64_t stops = GetParam().machine == Machine::fine ? 1 : kStops;
    expect_stops_in_order(GetParam(), test::is_long_run() ? 60 : stops);
}

class BenchTables : public ::testing::TestWithParam<const char*> {};

// Machine time, not the wall clock's: the same everywhere.
TEST_P(BenchTables, AreCarvedInTheirReferenceTimeAndNeverSlowerThanByAngles) {
    Profile profile = profile_of(Machine::plain);
    const std::string file = in_source("tests/motion/tables/") + GetParam() + ".csv";
    const JobTable table = table_from_csv(file, profile).value();
    const Carved ahead = carved(profile, table);
    ASSERT_TRUE(ahead.report.ok) << verify::report_text(ahead.report);
    ASSERT_GT(ahead.t_ref_s, 0.0);
    EXPECT_LE(ahead.carve_s, 1.01 * ahead.t_ref_s);
    EXPECT_GE(ahead.carve_s, 0.999 * ahead.t_ref_s);
    profile.job.planner = Planner::angle;
    const Carved by_angles = carved(profile, table);
    ASSERT_TRUE(by_angles.report.ok) << verify::report_text(by_angles.report);
    EXPECT_LE(ahead.carve_s, by_angles.carve_s);
}

INSTANTIATE_TEST_SUITE_P(Bench, BenchTables,
                         ::testing::Values("vase", "figurine", "gear", "relief", "scan", "bunny"),
                         [](const auto& named) { return std::string{named.param}; });

std::string name_of(const ::testing::TestParamInfo<Case>& info) {
    const char* const machines[] = {"Plain", "Lifting", "WithBacklash", "LiftingWithBacklash",
                                    "Fine",  "Coarse",  "Spiral"};
    return info.param.job + std::string{machines[static_cast<std::size_t>(info.param.machine)]};
}

INSTANTIATE_TEST_SUITE_P(Bench, DisturbedTables,
                         ::testing::Values(Case{"vase", Machine::plain}, Case{"figurine", Machine::plain},
                                           Case{"gear", Machine::plain}, Case{"relief", Machine::plain},
                                           Case{"scan", Machine::plain}, Case{"bunny", Machine::plain},
                                           Case{"gear", Machine::with_backlash},
                                           Case{"relief", Machine::lifting},
                                           Case{"gear", Machine::lifting_with_backlash},
                                           Case{"figurine", Machine::lifting_with_backlash}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(Bench, StoppedTables,
                         ::testing::Values(Case{"gear", Machine::fine}, Case{"figurine", Machine::coarse},
                                           Case{"gear", Machine::coarse}, Case{"figurine", Machine::spiral},
                                           Case{"scan", Machine::spiral},
                                           Case{"scan", Machine::with_backlash},
                                           Case{"relief", Machine::lifting_with_backlash},
                                           Case{"bunny", Machine::lifting_with_backlash}),
                         name_of);

}  // namespace
}  // namespace psicarve::motion
