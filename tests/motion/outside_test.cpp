// SPDX-License-Identifier: GPL-3.0-or-later
// Roughing passes of which heads are outside of the blank in part: the pins obey all rules there too, and the
// feed wherever a head may cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "hmi/rough/roughing.hpp"
#include "hmi/verify/verify_report.hpp"
#include "shared/base/units.hpp"
#include "tests/motion/carving_bench.hpp"
#include "tests/motion/random_operator.hpp"
#include "tests/shared/passes_fixture.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

using cycle::MachineRig;
using cycle::RequestKind;

constexpr std::int32_t kOut_pulses = 6400;
constexpr std::int32_t kIn_pulses = 6360;
/// 16 mm less the clearance, the path's tolerance and two pulses.
constexpr double kClear_mm = 13.985;

/// Sets the radii of the roughing layers [pulses].
template <typename Radius>
void set_radii(JobTable& job, const Radius& radius) {
    for (std::uint32_t layer = 0; layer < job.passes.back().first_layer; ++layer) {
        for (std::uint32_t point = 0; point < job.point_count; ++point) {
            const std::size_t at = std::size_t{layer} * job.point_count + point;
            job.r_left_pulses[at] = job.r_right_pulses[at] = radius(layer, point);
        }
    }
}

/// `more_mm`: so much more of a blank.
void tell_blank(JobTable& job, double more_mm = 0.0) {
    for (JobPass& pass : job.passes) pass.clear_mm = kClear_mm + more_mm;
}
/// Too much for anything to be outside, and next to nothing on the ways between passes.
constexpr double kTooMuch_mm = 0.05;

struct Course {
    Joining joining;
    Planner planner;
};

std::string name_of_course(const Course& course) {
    return std::string{name_of(course.joining)} + (course.planner == Planner::angle ? "Angle" : "Lookahead");
}

class Outside : public ::testing::TestWithParam<Course> {
protected:
    Outside() : profile(cycle::quick_profile()) {
        profile.job.planner = GetParam().planner;
        profile.job.joining = GetParam().joining;
        profile.job.feed_mm_s = 6.0;
    }
    /// The heads stand alike, as on the ways between passes pulses of two may change places. Outside are the
    /// first and the last third of each layer of the first roughing pass, and the second's but for its last
    /// layer's middle.
    JobTable table(double more_blank_mm = 0.0) const {
        constexpr std::uint32_t points = 31;
        const auto shape = [](double at, std::uint32_t) { return 10.0 + 0.2 * std::cos(2.0 * at); };
        JobTable job = with_roughing(table_of(profile, shape, 3, points, GetParam().joining), 2, 0);
        set_radii(job, [&](std::uint32_t layer, std::uint32_t point) {
            const bool is_third = point < points / 3 || point > 2 * points / 3;
            const bool is_second = layer >= job.passes[1].first_layer;
            const bool is_middle = layer + 1 == job.passes[2].first_layer && point == points / 2;
            return is_third || (is_second && !is_middle) ? kOut_pulses : kIn_pulses;
        });
        tell_blank(job, more_blank_mm);
        return job;
    }

    Profile profile;
};

TEST_P(Outside, ObeysTheFourRulesAndTakesLessTime) {
    const Carved fed = carved(profile, table(kTooMuch_mm));
    ASSERT_TRUE(fed.report.ok) << verify::report_text(fed.report);
    const JobTable job = table();
    const Carved result = carved(profile, job);
    ASSERT_TRUE(result.report.ok) << verify::report_text(result.report);
    EXPECT_EQ(result.report.points_visited, std::uint64_t{job.layer_count} * job.point_count);
    ASSERT_EQ(result.report.passes.size(), 3U);
    EXPECT_LT(result.report.passes[0].seconds, 0.8 * fed.report.passes[0].seconds);
    EXPECT_LT(result.report.passes[1].seconds, 0.6 * fed.report.passes[1].seconds);
    EXPECT_NEAR(result.report.passes[2].seconds, fed.report.passes[2].seconds, 0.1);
    if (GetParam().planner == Planner::lookahead) {
        EXPECT_NEAR(result.carve_s, result.t_ref_s, 0.02 * result.t_ref_s);
    }
}

TEST_P(Outside, HasTheSamePulsesHoweverItIsDisturbed) {
    const JobTable job = table();
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
    double outside_mm_s = 0.0;
    double seconds = 0.0;
};

/// Looks at the speeds in the roughing layers, which are rings of an even radius.
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
        const bool is_clear = last_psi_ == kNowhere || is_outside(last_psi_, psi);
        last_psi_ = psi;
        // The finishing pass has another radius.
        if (psi > job_.psi_sweep_pulses * job_.passes.back().first_layer) return seen_.clear();
        if (!seen_.empty() && is_clear != seen_.front().is_outside) seen_.clear();
        seen_.push_back({ticks_, is_clear});
        if (seen_.size() <= kPulses) return;
        const auto took_s = static_cast<double>(ticks_ - seen_[seen_.size() - 1 - kPulses].tick) * tick_s_;
        double& most = is_clear ? speeds_.outside_mm_s : speeds_.in_cut_mm_s;
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
        bool is_outside;
    };
    static constexpr std::int64_t kNowhere = -1'000'000;

    /// Whether the pulse between two positions of psi belongs to a way outside.
    bool is_outside(std::int64_t from, std::int64_t to) const {
        const std::int64_t sweep = job_.psi_sweep_pulses;
        const std::int64_t layer = std::min(from, to) / sweep;
        const std::int64_t steps = job_.point_count - 1;
        if (layer >= job_.passes.back().first_layer) return false;
        const std::int64_t step = ((std::min(from, to) % sweep) * steps) / sweep;
        const auto at = static_cast<std::size_t>(layer * job_.point_count + step);
        return job_.r_left_pulses[at] >= kOut_pulses && job_.r_left_pulses[at + 1] >= kOut_pulses;
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

class OutsideByPlanner : public ::testing::TestWithParam<Planner> {};

// The heads go out and in on straight ways, by 0.1 mm a line: nothing but the feed slows the table down where
// they pass the limit.
TEST_P(OutsideByPlanner, TheFeedHoldsUpToThePointWhereAHeadMayCutAtAnyOverride) {
    Profile profile = cycle::quick_profile();
    profile.job.planner = GetParam();
    profile.job.feed_mm_s = 6.0;
    constexpr double kRadius_mm = 16.0;
    const auto shape = [](double, std::uint32_t) { return 10.0; };
    JobTable fed = with_roughing(table_of(profile, shape, 2, 41), 1, 0);
    set_radii(fed, [](std::uint32_t, std::uint32_t point) {
        return kOut_pulses + 40 * (std::abs(static_cast<std::int32_t>(point % 16) - 8) - 4);
    });
    JobTable job = fed;
    tell_blank(fed, 0.5);
    tell_blank(job);
    const double feed_mm_s = profile.job.feed_mm_s;
    // With so few pulses the rounding of the curve makes some hundredths, and so does the radius.
    const double cut_mm_s = std::max(feed_mm_s, speeds_of(profile, fed, kRadius_mm, 100).in_cut_mm_s);
    EXPECT_LE(cut_mm_s, 1.06 * feed_mm_s);
    const Speeds plain = speeds_of(profile, job, kRadius_mm, 100);
    EXPECT_LE(plain.in_cut_mm_s, 1.003 * cut_mm_s);
    EXPECT_GE(plain.in_cut_mm_s, 0.97 * feed_mm_s);
    EXPECT_GE(plain.outside_mm_s, 1.3 * feed_mm_s);
    const Speeds half = speeds_of(profile, job, kRadius_mm, 50);
    EXPECT_LE(half.in_cut_mm_s, 1.003 * 0.5 * cut_mm_s);
    const double top_mm_s = kRadius_mm * kPi / 180.0 * profile.psi.speed_deg_s;
    EXPECT_LE(plain.outside_mm_s, 1.01 * top_mm_s);
    EXPECT_LE(half.outside_mm_s, 1.01 * 0.5 * top_mm_s);
    const Speeds twice = speeds_of(profile, job, kRadius_mm, 200);
    EXPECT_LE(twice.in_cut_mm_s, 1.003 * 2.0 * cut_mm_s);
    EXPECT_GE(twice.outside_mm_s, 0.99 * plain.outside_mm_s);
    EXPECT_LE(twice.seconds, 1.0001 * plain.seconds);
    EXPECT_LT(plain.seconds, 0.9 * speeds_of(profile, fed, kRadius_mm, 100).seconds);
}

/// A blank off the axis, roughed with heads that are raised out of it and, at a feed at which that is worth
/// nothing, with heads that are not; both carved at the same feed.
TEST_P(OutsideByPlanner, ABlankOffTheAxisIsRoughedInLessTime) {
    Profile profile = cycle::quick_profile();
    profile.r1.travel_mm[1] = profile.r2.travel_mm[1] = 40.0;
    profile.r1.home_position_mm = profile.r2.home_position_mm = 40.0;
    profile.job.planner = GetParam();
    profile.job.path_tolerance_mm = 0.02;
    profile.tool = {ToolShape::ball, 3.0, 60.0, 0.0};
    profile.blank = {.radius_mm = 16.0, .offset_x_mm = 4.0};
    constexpr double kFeed_mm_s = 6.0;
    const auto made = [&profile](double feed_mm_s) {
        const auto shape = [](double, std::uint32_t) { return 16.2; };
        JobTable table = table_of(profile, shape, 2, 121);
        table.feed_mm_s = feed_mm_s;
        const JobTable level = table;
        EXPECT_TRUE(rough::add_roughing(table, level, profile, {1.5, 0.2, {}}));
        table.feed_mm_s = kFeed_mm_s;
        return table;
    };
    const Carved raised = carved(profile, made(kFeed_mm_s));
    ASSERT_TRUE(raised.report.ok) << verify::report_text(raised.report);
    const Carved plain = carved(profile, made(1000.0));
    ASSERT_TRUE(plain.report.ok) << verify::report_text(plain.report);
    ASSERT_EQ(raised.report.passes.size(), plain.report.passes.size());
    ASSERT_GE(raised.report.passes.size(), 3U);
    EXPECT_LT(raised.report.passes[0].seconds, 0.85 * plain.report.passes[0].seconds);
    // The ways from pass to pass go by the largest radius.
    EXPECT_LT(raised.carve_s, 0.98 * plain.carve_s);
    RecordProperty("raised_s", std::to_string(raised.report.passes[0].seconds));
    RecordProperty("plain_s", std::to_string(plain.report.passes[0].seconds));
}

INSTANTIATE_TEST_SUITE_P(Carved, OutsideByPlanner, ::testing::Values(Planner::lookahead, Planner::angle),
                         [](const auto& named) {
                             return std::string(named.param == Planner::angle ? "Angle" : "Lookahead");
                         });

INSTANTIATE_TEST_SUITE_P(Carved, Outside,
                         ::testing::Values(Course{Joining::continuous, Planner::lookahead},
                                           Course{Joining::zigzag, Planner::lookahead},
                                           Course{Joining::spiral, Planner::lookahead},
                                           Course{Joining::continuous, Planner::angle},
                                           Course{Joining::zigzag, Planner::angle}),
                         [](const auto& named) { return name_of_course(named.param); });

}  // namespace
}  // namespace psicarve::motion
