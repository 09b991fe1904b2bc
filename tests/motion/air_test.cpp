// SPDX-License-Identifier: GPL-3.0-or-later
// Roughing passes that are air in part: the pins obey all rules there too, and the feed where a head cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "hmi/verify/verify_report.hpp"
#include "shared/units.hpp"
#include "tests/motion/carving_bench.hpp"
#include "tests/motion/random_operator.hpp"
#include "tests/shared/passes_fixture.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

using cycle::MachineRig;
using cycle::RequestKind;

struct Course {
    Joining joining;
    Planner planner;
};

std::string name_of_course(const Course& course) {
    return std::string{name_of(course.joining)} + (course.planner == Planner::angle ? "Angle" : "Lookahead");
}

class Air : public ::testing::TestWithParam<Course> {
protected:
    Air() : profile(cycle::quick_profile()) {
        profile.job.planner = GetParam().planner;
        profile.job.joining = GetParam().joining;
        profile.job.feed_mm_s = 6.0;
    }
    /// The heads stand alike, as on the ways between passes pulses of two may change places. The first and
    /// the last third of each roughing layer of the first pass, and the whole of the second's.
    JobTable table(bool has_air, std::uint32_t points = 31) const {
        const auto shape = [](double at, std::uint32_t) { return 15.0 + 0.2 * std::cos(2.0 * at); };
        JobTable job = with_roughing(table_of(profile, shape, 3, points, GetParam().joining), 2, 400);
        if (!has_air) return job;
        job.air.assign(job.r_left_pulses.size(), 0);
        for (std::uint32_t layer = 0; layer < job.passes[2].first_layer; ++layer) {
            for (std::uint32_t point = 0; point < points; ++point) {
                const bool is_third = point < points / 3 || point > 2 * points / 3;
                const bool is_air = layer >= job.passes[1].first_layer || is_third;
                job.air[std::size_t{layer} * points + point] = is_air ? 1 : 0;
            }
        }
        return job;
    }

    Profile profile;
};

TEST_P(Air, ObeysTheFourRulesAndTakesLessTime) {
    const Carved fed = carved(profile, table(false));
    ASSERT_TRUE(fed.report.ok) << verify::report_text(fed.report);
    const JobTable job = table(true);
    const Carved result = carved(profile, job);
    ASSERT_TRUE(result.report.ok) << verify::report_text(result.report);
    EXPECT_EQ(result.report.points_visited, std::uint64_t{job.layer_count} * job.point_count);
    ASSERT_EQ(result.report.passes.size(), 3U);
    EXPECT_LT(result.report.passes[0].seconds, 0.8 * fed.report.passes[0].seconds);
    EXPECT_LT(result.report.passes[1].seconds, 0.6 * fed.report.passes[1].seconds);
    EXPECT_NEAR(result.report.passes[2].seconds, fed.report.passes[2].seconds, 1e-3);
    if (GetParam().planner == Planner::lookahead) {
        EXPECT_NEAR(result.carve_s, result.t_ref_s, 0.02 * result.t_ref_s);
    } else {
        EXPECT_EQ(result.order, fed.order);
    }
}

TEST_P(Air, HasTheSamePulsesHoweverItIsDisturbed) {
    const JobTable job = table(true);
    const Carved undisturbed = carved(profile, job);
    for (std::uint64_t seed = 1; seed <= (test::is_thorough() ? 4U : 1U); ++seed) {
        const Carved disturbed = carved(profile, job, Operator(seed));
        ASSERT_TRUE(disturbed.report.ok) << "seed " << seed << '\n' << verify::report_text(disturbed.report);
        ASSERT_EQ(disturbed.order, undisturbed.order) << "seed " << seed;
    }
}

/// How fast a carving goes over the surface, from the pulses of some hundredths of a second.
struct Speeds {
    double in_cut_mm_s = 0.0;
    double in_air_mm_s = 0.0;
    double seconds = 0.0;
};

/// Of the roughing layers, which are rings of an even radius.
class SpeedWitness {
public:
    SpeedWitness(const JobTable& job, const Profile& profile, double radius_mm)
        : job_(job),
          tick_s_(1e-9 * static_cast<double>(tick_period_ns(profile))),
          mm_per_pulse_(radius_mm * rad_from_pulses(1, profile.psi.pulses_per_rev)) {}

    void look(const MachineRig& rig) {
        ++ticks_;
        const std::int64_t psi = rig.positions()[index_of(Axis::psi)];
        if (psi == last_psi_) return;
        const bool is_in_air = last_psi_ == kNowhere || is_air(last_psi_, psi);
        last_psi_ = psi;
        if (!seen_.empty() && is_in_air != seen_.front().is_air) seen_.clear();
        seen_.push_back({ticks_, is_in_air});
        if (seen_.size() <= kPulses) return;
        const auto took_s = static_cast<double>(ticks_ - seen_[seen_.size() - 1 - kPulses].tick) * tick_s_;
        double& most = is_in_air ? speeds_.in_air_mm_s : speeds_.in_cut_mm_s;
        most = std::max(most, static_cast<double>(kPulses) * mm_per_pulse_ / took_s);
    }
    Speeds speeds() const {
        Speeds result = speeds_;
        result.seconds = static_cast<double>(ticks_) * tick_s_;
        return result;
    }
    static constexpr std::size_t kPulses = 40;  // fewer tell less of the speed, more less of the place

private:
    struct Seen {
        std::uint64_t tick;
        bool is_air;
    };
    static constexpr std::int64_t kNowhere = -1'000'000;

    /// Whether the pulse between two positions of psi belongs to a way in air.
    bool is_air(std::int64_t from, std::int64_t to) const {
        const std::int64_t sweep = job_.psi_sweep_pulses;
        const std::int64_t layer = std::min(from, to) / sweep;
        const std::int64_t steps = job_.point_count - 1;
        if (job_.air.empty() || layer >= job_.passes.back().first_layer) return false;
        const std::int64_t step = ((std::min(from, to) % sweep) * steps) / sweep;
        const auto at = static_cast<std::size_t>(layer * job_.point_count + step);
        return job_.air[at] != 0 && job_.air[at + 1] != 0;
    }

    const JobTable& job_;
    double tick_s_;
    double mm_per_pulse_;
    std::uint64_t ticks_ = 0;
    std::int64_t last_psi_ = kNowhere;
    std::vector<Seen> seen_;
    Speeds speeds_;
};

Speeds speeds_of(const Profile& profile, const JobTable& job, double radius_mm, std::uint64_t per_cent) {
    MachineRig rig(profile);
    EXPECT_TRUE(rig.home());
    rig.load(job);
    EXPECT_EQ(rig.ask(RequestKind::start), cycle::Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::waiting));
    EXPECT_EQ(rig.ask(RequestKind::override, 0, per_cent), cycle::Refusal::none);
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), cycle::Refusal::none);
    SpeedWitness witness(job, profile, radius_mm);
    while (rig.cycle->state() != MachineState::finishing) {
        rig.tick();
        witness.look(rig);
    }
    return witness.speeds();
}

class AirByPlanner : public ::testing::TestWithParam<Planner> {};

// The runs of air are 320 pulses long and those of the cut between them too: every boundary is looked at.
TEST_P(AirByPlanner, TheFeedHoldsUpToThePointWhereAHeadCutsAtAnyOverride) {
    Profile profile = cycle::quick_profile();
    profile.job.planner = GetParam();
    profile.job.feed_mm_s = 6.0;
    constexpr double kRadius_mm = 16.0;
    const auto shape = [](double, std::uint32_t) { return kRadius_mm; };
    JobTable job = with_roughing(table_of(profile, shape, 2, 41), 1, 0);
    const JobTable fed = job;
    job.air.assign(job.r_left_pulses.size(), 0);
    for (std::size_t at = 0; at < 2 * std::size_t{job.point_count}; ++at)
        job.air[at] = at % job.point_count % 8 < 5 ? 1 : 0;
    const double feed_mm_s = profile.job.feed_mm_s;
    const Speeds plain = speeds_of(profile, job, kRadius_mm, 100);
    EXPECT_LE(plain.in_cut_mm_s, 1.01 * feed_mm_s);
    EXPECT_GE(plain.in_cut_mm_s, 0.97 * feed_mm_s);
    EXPECT_GE(plain.in_air_mm_s, 1.3 * feed_mm_s);
    const Speeds half = speeds_of(profile, job, kRadius_mm, 50);
    EXPECT_LE(half.in_cut_mm_s, 1.01 * 0.5 * feed_mm_s);
    const double top_mm_s = kRadius_mm * kPi / 180.0 * profile.psi.speed_deg_s;
    EXPECT_LE(plain.in_air_mm_s, 1.01 * top_mm_s);
    EXPECT_LE(half.in_air_mm_s, 1.01 * 0.5 * top_mm_s);
    const Speeds twice = speeds_of(profile, job, kRadius_mm, 200);
    EXPECT_LE(twice.in_cut_mm_s, 1.01 * 2.0 * feed_mm_s);
    EXPECT_GE(twice.in_air_mm_s, 0.99 * plain.in_air_mm_s);
    EXPECT_LE(twice.seconds, 1.0001 * plain.seconds);
    EXPECT_LT(plain.seconds, 0.9 * speeds_of(profile, fed, kRadius_mm, 100).seconds);
}

INSTANTIATE_TEST_SUITE_P(Carved, AirByPlanner, ::testing::Values(Planner::lookahead, Planner::angle),
                         [](const auto& named) {
                             return std::string(named.param == Planner::angle ? "Angle" : "Lookahead");
                         });

INSTANTIATE_TEST_SUITE_P(Carved, Air,
                         ::testing::Values(Course{Joining::continuous, Planner::lookahead},
                                           Course{Joining::zigzag, Planner::lookahead},
                                           Course{Joining::spiral, Planner::lookahead},
                                           Course{Joining::continuous, Planner::angle},
                                           Course{Joining::zigzag, Planner::angle}),
                         [](const auto& named) { return name_of_course(named.param); });

}  // namespace
}  // namespace psicarve::motion
