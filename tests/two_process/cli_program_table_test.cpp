// SPDX-License-Identifier: GPL-3.0-or-later
// A table carved as a job and as a program whose corners are rounded: surfaces alike within the tolerance and
// a pulse.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "hmi/verify/pin_rules.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/two_process/cli_machine_rig.hpp"
#include "tests/two_process/table_program.hpp"

namespace psicarve::test {
namespace {

using verify::Positions;
using Place = std::array<double, kAxisCount>;

/// By the table's angle.
using Places = std::map<std::int64_t, std::vector<Positions>>;

/// Where the axes were while the spindle was on.
class PlacesCarved final : public verify::PositionJudge {
public:
    void settle(std::int64_t, const Positions& positions, SignalWord levels) override {
        if ((levels & bit_of(Signal::spindle)) != 0)
            places[positions[index_of(Axis::psi)]].push_back(positions);
    }
    void redefine(std::int64_t, const Positions&) override { places.clear(); }
    Places places;
};

Places places_carved(const std::string& path, const Profile& profile) {
    auto trace = verify::open_trace(path).value();
    PlacesCarved carved;
    verify::OffenceLog log;
    verify::CarvePlace place;
    verify::PinRules pins{profile, log, place, carved};
    EXPECT_TRUE(pins.begin(trace->start()).has_value());
    std::vector<verify::TraceEvent> events(4096);
    while (const std::size_t count = trace->read(events).value()) pins.feed(std::span{events}.first(count));
    pins.settle();
    return std::move(carved.places);
}

/// How far a head is off, along the surface, its radius and its height, but for a pulse of each axis.
double off_mm(const Profile& profile, std::size_t head, const Place& of, const Positions& at) {
    const double per_mm = axis_motion(profile, verify::kHeads[head]).pulses_per_unit;
    const double radius_mm = std::max(of[head], static_cast<double>(at[head])) / per_mm;
    const std::array<std::size_t, 3> axes{head, index_of(Axis::psi), index_of(Axis::y)};
    const std::array<double, 3> pulse_mm{1.0 / per_mm,
                                         radius_mm * rad_from_pulses(1, profile.psi.pulses_per_rev),
                                         1.0 / profile.y.pulses_per_mm};
    double square = 0.0;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double off = std::abs(static_cast<double>(at[axes[i]]) - of[axes[i]]);
        square += std::pow(std::max(0.0, off - 1.0) * pulse_mm[i], 2);
    }
    return std::sqrt(square);
}

Place point_of(const JobView& table, std::uint32_t layer, std::uint32_t step) {
    const std::uint32_t point = carved_point(table.joining(), table.point_count(), layer, step);
    return {static_cast<double>(table.r_left_pulses(layer)[point]),
            static_cast<double>(table.r_right_pulses(layer)[point]),
            static_cast<double>(table.psi_pulses(layer, point)),
            static_cast<double>(table.y_pulses(layer, point))};
}

class ProgramOfATable : public Machine, public testing::WithParamInterface<double> {};
INSTANTIATE_TEST_SUITE_P(Tolerance, ProgramOfATable, testing::Values(0.005, 0.02, 0.1),
                         [](const auto& parameter) {
                             return "um" + std::to_string(std::lround(1000.0 * parameter.param));
                         });

/// Of the table's way, sampled: how far the place is from all places carved that is furthest from them.
double furthest_mm(const JobView& table, const Profile& profile, const Places& places) {
    // No place is looked for where the table stands further off: it would be too far.
    constexpr double kAround_pulses = 40.0;
    constexpr int kParts = 8;
    double furthest_mm = 0.0;
    const auto look_at = [&](const Place& at) {
        for (std::size_t head = 0; head < verify::kHeadCount; ++head) {
            double least_mm = std::numeric_limits<double>::infinity();
            const double psi = at[index_of(Axis::psi)];
            auto angle = places.lower_bound(std::llround(psi - kAround_pulses));
            for (; angle != places.end() && static_cast<double>(angle->first) < psi + kAround_pulses; ++angle)
                for (const Positions& place : angle->second)
                    least_mm = std::min(least_mm, off_mm(profile, head, at, place));
            furthest_mm = std::max(furthest_mm, least_mm);
        }
    };
    for (std::uint32_t layer = 0; layer < table.layer_count(); ++layer) {
        for (std::uint32_t step = 0; step + 1 < table.point_count(); ++step) {
            const Place from = point_of(table, layer, step);
            const Place to = point_of(table, layer, step + 1);
            for (int part = 0; part <= kParts; ++part) {
                Place at;
                for (std::size_t k = 0; k < kAxisCount; ++k)
                    at[k] = from[k] + (to[k] - from[k]) * part / kParts;
                look_at(at);
            }
        }
    }
    return furthest_mm;
}

// Job and program pass along all of the table's way. That they are nowhere else their verifiers say.
TEST_P(ProgramOfATable, CarvesTheSurfaceOfItsJobWithinTheToleranceAndAPulse) {
    const std::string job_path = job("3", "40");
    const auto snapshot = load_snapshot(job_path);
    ASSERT_TRUE(snapshot) << snapshot.error().message;
    const JobView table = JobView::check(snapshot->job_blob).value();
    const Profile profile;
    write("table.ngc", program_of_table(table, profile, "G64 P" + std::to_string(GetParam())));
    const Outcome done =
        run({"gcode", "run", file("table.ngc"), "--simulate", "--trace", file("pins.trace"), "--json"});
    ASSERT_EQ(done.exit_code, 0) << done.error << done.out;
    ASSERT_NE(done.out.find("\"verified\":true"), std::string::npos) << done.out;
    const Outcome carved = run({"carve", job_path, "--trace", file("job.trace")});
    ASSERT_EQ(carved.exit_code, 0) << carved.error << carved.out;

    EXPECT_LE(furthest_mm(table, profile, places_carved(file("job.trace"), profile)),
              profile.job.path_tolerance_mm);
    const double apart_mm = furthest_mm(table, profile, places_carved(file("pins.trace"), profile));
    EXPECT_LE(apart_mm, GetParam());
    EXPECT_GT(apart_mm, 0.0) << "corners are rounded";
}

}  // namespace
}  // namespace psicarve::test
