// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "rtcore/cycle/layer_range.hpp"
#include "rtcore/sim/sim_config.hpp"
#include "rtcore/sim/workpiece.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::uint32_t kCarvedLayers = 5;
constexpr std::uint32_t kLayerPoints = 60;

/// Which axes stepped together on the way to each point of the job; of the points that lie before the first,
/// and of it, none.
using Ways = std::vector<std::vector<std::uint32_t>>;

Ways ways_to_points(const std::vector<PortWrite>& writes, const std::vector<Positions>& points,
                    std::size_t first) {
    Ways ways(points.size());
    std::size_t next = first;
    PinCounter pins(points[next]);
    const auto pass_points = [&] {
        while (next < points.size() && points[next] == pins.positions()) ++next;
    };
    pass_points();
    for (const PortWrite& write : writes) {
        if (const std::uint32_t axes = pins.take(write.levels); axes != 0 && next < points.size())
            ways[next].push_back(axes);
        pass_points();
    }
    EXPECT_EQ(next, points.size()) << "every point from the first on, in order and exactly";
    return ways;
}

/// What the pins did while these layers were carved.
std::vector<PortWrite> writes_of(MachineRig& rig, LayerRange layers, const Positions& begin) {
    EXPECT_EQ(rig.ask(RequestKind::start, 0, packed(layers)), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::waiting));
    EXPECT_EQ(rig.positions(), begin) << "the heads go in at the very point";
    rig.port->writes.clear();
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::finishing));
    std::vector<PortWrite> writes = rig.port->writes;
    EXPECT_TRUE(rig.run_until(MachineState::ready));
    return writes;
}

struct Course {
    Joining joining;
    psicarve::Planner planner;
};

class FromPoint : public ::testing::TestWithParam<Course> {
protected:
    FromPoint()
        : job(random_job(kCarvedLayers, kLayerPoints, 17, GetParam().joining)),
          points(points_of(job)),
          sut(profile()) {
        job.profile_toml = profile_to_toml(profile());
        EXPECT_TRUE(sut.home());
        sut.load(job);
    }
    static Profile profile() {
        Profile result = quick_profile();
        result.blank.radius_mm = 16.0;
        result.blank.height_mm = 20.0;
        result.job.planner = GetParam().planner;
        return result;
    }
    LayerRange range(std::uint32_t layer, std::uint32_t step) const {
        return {.first = layer,
                .count = 0,
                .is_dry = false,
                .point_number = carved_point(GetParam().joining, kLayerPoints, layer, step) + 1};
    }
    /// In the order of carving.
    std::size_t index_of(const LayerRange& begin) const {
        const std::uint32_t number = begin.point_number;
        const std::uint32_t step =
            number == 0 ? 0 : carved_point(job.joining, kLayerPoints, begin.first, number - 1);
        return std::size_t{begin.first} * kLayerPoints + step;
    }

    JobTable job;
    std::vector<Positions> points;
    MachineRig sut;
};

TEST_P(FromPoint, HasThePulsesOfTheWholeRunFromThereOn) {
    const Ways whole = ways_to_points(writes_of(sut, {}, points[0]), points, 0);
    std::mt19937_64 random(23);
    std::vector<std::uint32_t> begins{1, kLayerPoints - 2};
    for (int i = 0; i < 2; ++i) begins.push_back(static_cast<std::uint32_t>(random() % (kLayerPoints - 1)));
    for (std::uint32_t layer = 0; layer < kCarvedLayers; ++layer) {
        for (const std::uint32_t step : begins) {
            const std::size_t first = std::size_t{layer} * kLayerPoints + step;
            const Ways rest =
                ways_to_points(writes_of(sut, range(layer, step), points[first]), points, first);
            for (std::size_t point = first + 1; point < points.size(); ++point) {
                // Between two layers the ways differ where the first of them was not planned with it.
                if (point % kLayerPoints == 0) continue;
                ASSERT_EQ(rest[point], whole[point])
                    << "point " << point << " from layer " << layer << ", point " << step;
            }
            ASSERT_EQ(sut.cycle->sample().points_done, points.size());
            ASSERT_GT(sut.cycle->sample().carve_last_tick, sut.cycle->sample().carve_first_tick);
        }
    }
    for (std::size_t k = 0; k < kAxisCount; ++k) EXPECT_EQ(sut.machine->report().axes[k].stalls, 0U);
}

TEST_P(FromPoint, OfTheLayersBeginIsTheStartOfTheLayer) {
    for (const std::uint32_t layer : {0U, 3U}) {
        const std::size_t first = std::size_t{layer} * kLayerPoints;
        const auto named = writes_of(sut, range(layer, 0), points[first]);
        const auto plain = writes_of(sut, {.first = layer, .count = 0}, points[first]);
        EXPECT_EQ(ways_to_points(named, points, first), ways_to_points(plain, points, first));
    }
}

TEST_P(FromPoint, IsRefusedBeyondTheLayerAndWithItsLastPoint) {
    for (const std::uint32_t layer : {0U, 1U}) {
        const auto ask = [&](std::uint32_t number) {
            return sut.ask(RequestKind::start, 0,
                           packed(LayerRange{.first = layer, .count = 0, .point_number = number}));
        };
        EXPECT_EQ(ask(kLayerPoints + 1), Refusal::no_such_point);
        EXPECT_EQ(ask(1'000'000), Refusal::no_such_point);
        EXPECT_EQ(ask(range(layer, kLayerPoints - 1).point_number), Refusal::no_such_point);
        EXPECT_EQ(sut.cycle->state(), MachineState::ready);
    }
}

TEST_P(FromPoint, TurnsTheTableFromThereInADryRunToo) {
    LayerRange dry = range(2, 31);
    dry.is_dry = true;
    ASSERT_EQ(sut.ask(RequestKind::start, 0, packed(dry)), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::waiting));
    const Positions& begin = points[2 * kLayerPoints + 31];
    EXPECT_EQ(sut.positions()[2], begin[2]);
    EXPECT_EQ(sut.positions()[3], begin[3]);
    EXPECT_GT(sut.positions()[0], begin[0]);
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions()[2], points.back()[2]);
    EXPECT_EQ(sut.positions()[3], points.back()[3]);
}

// Whoever reads the count after the core's sudden death goes on with that point: it must have been carved.
TEST_P(FromPoint, CountsAPointOnceBothHeadsHaveComeToItByThePins) {
    std::mt19937_64 random(37);
    ASSERT_EQ(sut.ask(RequestKind::start), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::waiting));
    sut.port->writes.clear();
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    PinCounter pins(points[0]);
    std::size_t passed = 0;
    std::size_t read = 0;
    const auto pass_points = [&] {
        while (passed < points.size() && points[passed] == pins.positions()) ++passed;
    };
    pass_points();
    while (sut.cycle->state() == MachineState::carving || sut.cycle->sample().points_done < points.size()) {
        sut.run(1 + random() % 40);
        for (; read < sut.port->writes.size(); ++read) {
            pins.take(sut.port->writes[read].levels);
            pass_points();
        }
        ASSERT_LE(sut.cycle->sample().points_done, passed) << "counted before its last pulse was out";
        if (passed == points.size() && sut.cycle->state() != MachineState::carving) break;
    }
    EXPECT_EQ(passed, points.size());
}

enum class Ended { stop, emergency_stop, limit };

/// Carves from there until it is ended at a random tick; homed again. The point with which to go on: the last
/// that was reached, or a layer's begin.
LayerRange ended_at_random(MachineRig& rig, const JobTable& job, LayerRange from, Ended how,
                           std::mt19937_64& random) {
    EXPECT_EQ(rig.ask(RequestKind::start, 0, packed(from)), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::waiting));
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), Refusal::none);
    rig.run(500 + random() % 3000);
    EXPECT_EQ(rig.cycle->state(), MachineState::carving);
    if (how == Ended::stop) rig.stop();
    if (how == Ended::emergency_stop) rig.emergency_stop();
    if (how == Ended::limit) rig.machine->hold_input(Signal::r2_limit, true);
    const bool is_alarm = how != Ended::stop;
    EXPECT_TRUE(rig.run_until(is_alarm ? MachineState::alarm : MachineState::ready));
    const Sample sample = rig.cycle->sample();
    rig.machine->release_input(Signal::r2_limit);
    rig.run(1000);
    if (is_alarm) {
        EXPECT_EQ(rig.ask(RequestKind::reset_alarm), Refusal::none);
        EXPECT_TRUE(rig.home());
    }
    const auto layer = static_cast<std::uint32_t>(sample.points_done / kLayerPoints);
    const auto reached = static_cast<std::uint32_t>(sample.points_done % kLayerPoints);
    if (reached < 2) return {.first = layer, .count = 0};
    EXPECT_EQ(carved_point(job.joining, kLayerPoints, layer, reached - 1), sample.point) << "as it is told";
    return {.first = layer, .count = 0, .is_dry = false, .point_number = sample.point + 1};
}

/// With a blank on its table from the first, and the job.
class RigWithBlank : public MachineRig {
public:
    RigWithBlank(const Profile& of_machine, const JobTable& job) : MachineRig(of_machine) {
        machine->set_workpiece(sim::Workpiece::make(sim::sim_config_from_profile(profile)));
        EXPECT_TRUE(home());
        load(job);
    }
    std::string surface() const { return sim::csv_of(machine->workpiece()->cuts()); }
};

TEST_P(FromPoint, GoesOnAfterStopsToTheSurfaceOfTheUndisturbedRun) {
    RigWithBlank whole(profile(), job);
    (void)writes_of(whole, {}, points[0]);
    ASSERT_GT(whole.machine->workpiece()->cuts().size(), 10'000U);
    std::mt19937_64 random(29);
    int within = 0;
    for (int round = 0; round < 2; ++round) {
        RigWithBlank rig(profile(), job);
        LayerRange begin{};
        for (int stop = 0; stop < 3; ++stop) {
            begin = ended_at_random(rig, job, begin, Ended::stop, random);
            within += begin.point_number != 0 ? 1 : 0;
        }
        (void)writes_of(rig, begin, points[index_of(begin)]);
        EXPECT_TRUE(rig.surface() == whole.surface()) << "round " << round;
    }
    EXPECT_GT(within, 3) << "it did go on within layers";
}

// Homing anew finds each sensor within a pulse or so, and heads whose drives go off coast: so the pulses
// alone are compared.
TEST_P(FromPoint, GoesOnAfterAlarmsWithThePulsesOfTheUndisturbedRun) {
    const Ways whole = ways_to_points(writes_of(sut, {}, points[0]), points, 0);
    std::mt19937_64 random(31);
    LayerRange begin{};
    for (const Ended how : {Ended::emergency_stop, Ended::limit}) {
        begin = ended_at_random(sut, job, begin, how, random);
        const std::size_t first = index_of(begin);
        const Ways rest = ways_to_points(writes_of(sut, begin, points[first]), points, first);
        for (std::size_t point = first + 1; point < points.size(); ++point) {
            if (point % kLayerPoints == 0) continue;
            ASSERT_EQ(rest[point], whole[point]) << point;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, FromPoint,
                         ::testing::Values(Course{Joining::continuous, psicarve::Planner::angle},
                                           Course{Joining::zigzag, psicarve::Planner::angle},
                                           Course{Joining::spiral, psicarve::Planner::angle},
                                           Course{Joining::continuous, psicarve::Planner::lookahead},
                                           Course{Joining::zigzag, psicarve::Planner::lookahead},
                                           Course{Joining::spiral, psicarve::Planner::lookahead}),
                         [](const auto& named) {
                             return std::string{name_of(named.param.joining)} +
                                    (named.param.planner == psicarve::Planner::angle ? "_by_angle"
                                                                                     : "_ahead");
                         });

TEST(LayerRange, IsOneNumberOfWhichAllCountsComeBack) {
    for (const std::uint32_t first : {0U, 7U, 999'999U}) {
        for (const std::uint32_t count : {0U, 3U, 1'000'000U}) {
            for (const std::uint32_t number : {0U, 1U, 4095U, 4096U, 65'536U, 1'000'000U}) {
                for (const bool is_dry : {false, true}) {
                    const LayerRange back = layer_range(packed(LayerRange{first, count, is_dry, number}));
                    EXPECT_EQ(back.first, first);
                    EXPECT_EQ(back.count, count);
                    EXPECT_EQ(back.is_dry, is_dry);
                    EXPECT_EQ(back.point_number, number);
                }
            }
        }
    }
}

// As starts were recorded when they named no point.
TEST(LayerRange, IsReadFromOldRecordersAsItWas) {
    const LayerRange old = layer_range(std::uint64_t{3 | kDryBit} << 32U | 999'999U);
    EXPECT_EQ(old.first, 999'999U);
    EXPECT_EQ(old.count, 3U);
    EXPECT_TRUE(old.is_dry);
    EXPECT_EQ(old.point_number, 0U);
}

}  // namespace
}  // namespace psicarve::cycle
