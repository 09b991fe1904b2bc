// SPDX-License-Identifier: GPL-3.0-or-later
// How far tips go into the model between points, gap by gap, against a search of each gap of each row.
#include "hmi/cam/gap_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "hmi/tool/tool.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/shapes.hpp"
#include "tests/hmi/slice/oracle.hpp"
#include "tests/hmi/tool/brute_force.hpp"

namespace psicarve::cam {
namespace {

constexpr std::uint32_t kGapLayers = 6;
constexpr std::uint32_t kGapPoints = 13;
constexpr double kColumnRadius = 6.0;

shapes::Point at(double direction_deg, double radius, double z) {
    const double angle = rad_from_deg(direction_deg);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// A spike out of the column, level or rising, with its point at a height.
void add_spike(shapes::Builder& body, double direction_deg, double foot_z, double z) {
    const shapes::Point point = at(direction_deg, 11.0, z);
    const shapes::Point a = at(direction_deg - 3.0, 5.0, foot_z - 0.3);
    const shapes::Point b = at(direction_deg + 3.0, 5.0, foot_z - 0.3);
    const shapes::Point c = at(direction_deg, 5.0, foot_z + 0.3);
    body.facet(a, b, point).facet(b, c, point).facet(c, a, point).facet(a, c, b);
}

void add_blade(shapes::Builder& body, double from_deg, double to_deg, double z) {
    const shapes::Point low_a = at(from_deg - 1.0, 5.0, z - 0.4), low_b = at(to_deg + 1.0, 5.0, z - 0.4);
    const shapes::Point high_a = at(from_deg - 1.0, 5.0, z + 0.4), high_b = at(to_deg + 1.0, 5.0, z + 0.4);
    const shapes::Point edge_a = at(from_deg, 10.0, z), edge_b = at(to_deg, 10.0, z);
    body.quad(low_a, low_b, edge_b, edge_a).quad(edge_a, edge_b, high_b, high_a);
    body.facet(low_a, edge_a, high_a).facet(low_b, high_b, edge_b).quad(low_a, high_a, high_b, low_b);
}

/// Spikes between the layers, which lie 2 mm apart from 1 mm on: just above and just below one, above the
/// highest and below the lowest, rising steeply through some; a level blade through several gaps; an
/// upright fin.
model::Mesh spiky() {
    shapes::Builder body;
    body.add(shapes::cylinder(kColumnRadius, 0.0, 12.0, 16));
    add_spike(body, 22.0, 5.3, 5.3);
    add_spike(body, 67.0, 6.7, 6.7);
    add_spike(body, 111.0, 11.5, 11.5);
    add_spike(body, 142.0, 0.5, 0.5);
    add_spike(body, 188.0, 2.5, 9.2);
    add_spike(body, 203.0, 8.7, 8.7);
    add_spike(body, 352.5, 4.6, 4.6);
    // Exactly where a gap ends, and where the first begins.
    add_spike(body, 45.0, 9.4, 9.4);
    add_spike(body, 0.0, 7.2, 7.2);
    add_blade(body, 232.0, 288.0, 7.4);
    add_blade(body, 168.0, 183.0, 3.4);
    const auto corner = [](double direction_deg, double radius) {
        return std::pair{at(direction_deg, radius, 0.5), at(direction_deg, radius, 11.5)};
    };
    const auto [low_a, high_a] = corner(320.0, 5.0);
    const auto [low_b, high_b] = corner(324.0, 5.0);
    const auto [low_end, high_end] = corner(322.0, 10.0);
    body.quad(low_a, low_end, high_end, high_a).quad(low_end, low_b, high_b, high_end);
    body.quad(low_b, low_a, high_a, high_b).facet(low_a, low_b, low_end).facet(high_a, high_end, high_b);
    return body.mesh();
}

struct Searched {
    double most_mm = 0.0;
    double at_rad = 0.0;
};

/// Every gap of each row and head, in many places, by the tool's definition.
class GapOracle {
public:
    /// Also where `told` says that it is.
    GapOracle(const model::Mesh& mesh, const Profile& profile, const JobTable& table,
              const std::vector<Gap>& told)
        : mesh_(mesh),
          told_(told),
          profile_(profile),
          table_(table),
          tool_(tool::tool_of(profile.tool, 1.0)),
          gaps_(2 * std::size_t{kGapPoints - 1}) {}

    std::vector<Searched> search() {
        const bool is_spiral = table_.joining == Joining::spiral;
        const std::uint32_t end = is_spiral ? kGapLayers : table_.layer_count;
        for (std::uint32_t row = is_spiral ? 1 : 0; row < end; ++row) {
            for (std::uint32_t point = 0; point + 1 < kGapPoints; ++point) {
                look(row, point, profile_.r1, table_.r_left_pulses, 0.0, 0.0, 0.0);
                look(row, point, profile_.r2, table_.r_right_pulses, kPi,
                     rad_from_deg(profile_.head_r2_angle_error_deg), profile_.head_r2_height_error_mm);
            }
        }
        return gaps_;
    }

private:
    double tip_mm(double direction_rad, double z) const {
        if (tool_.shape == tool::Shape::point) return oracle::radius(mesh_, 0.0, 0.0, direction_rad, z);
        const auto rise = [this](double s) { return tool::rise(tool_, s); };
        return brute::tip_radius(mesh_, direction_rad, z, brute::Shape<decltype(rise)>{tool_.radius, rise});
    }
    double psi_rad(std::uint32_t row, std::uint32_t point) const {
        return rad_from_pulses(
            table_angle_pulses(table_.joining, table_.psi_sweep_pulses, kGapPoints, row, point),
            profile_.psi.pulses_per_rev);
    }
    double z_mm(std::uint32_t row, double part) const {
        const double pitch_mm = 12.0 / kGapLayers;
        if (table_.joining != Joining::spiral) return (row + 0.5) * pitch_mm;
        return (row - 0.5 + part) * pitch_mm;
    }
    void look(std::uint32_t row, std::uint32_t point, const LinearAxisProfile& head,
              const std::vector<std::int32_t>& radii, double facing_rad, double error_rad, double up_mm) {
        const int steps = tool_.shape == tool::Shape::point ? 60 : 6;
        const std::int32_t* const pair = radii.data() + std::size_t{row} * kGapPoints + point;
        const double from_rad = psi_rad(row, point);
        const double to_rad = psi_rad(row, point + 1);
        const double turns = (0.5 * (from_rad + to_rad) + facing_rad) / (2.0 * kPi);
        const auto gap =
            static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(gaps_.size()));
        const auto look_at = [&](double share) {
            const double seen_rad = from_rad + share * (to_rad - from_rad) + facing_rad;
            const double straight = pair[0] + share * (pair[1] - pair[0]);
            const double tip = straight / head.pulses_per_mm + head.tip_mm();
            const double sunk_mm =
                tip_mm(seen_rad + error_rad, z_mm(row, (point + share) / (kGapPoints - 1.0)) + up_mm) - tip;
            if (sunk_mm > gaps_[gap].most_mm) gaps_[gap] = {sunk_mm, seen_rad};
        };
        for (int k = 0; k <= steps; ++k) look_at(static_cast<double>(k) / steps);
        if (told_[gap].sunk_mm <= 0.0) return;
        const double ahead_rad = std::remainder(told_[gap].direction_rad - from_rad - facing_rad, 2.0 * kPi);
        // A hair to both sides: a search along one ray may miss the very edge.
        for (const double off_rad : {-1e-5, 0.0, 1e-5}) look_at((ahead_rad + off_rad) / (to_rad - from_rad));
    }

    const model::Mesh& mesh_;
    const std::vector<Gap>& told_;
    const Profile& profile_;
    const JobTable& table_;
    tool::Tool tool_;
    std::vector<Searched> gaps_;
};

/// Where spikes and the fin stand [deg].
constexpr double kAbove_deg = 111.0;  ///< higher than a spiral comes there
constexpr double kSpikes_deg[] = {22.0, 67.0, 111.0, 142.0, 188.0, 203.0, 240.0, 260.0, 280.0, 322.0, 352.5};

std::size_t gap_at(double direction_rad) {
    const double turns = direction_rad / (2.0 * kPi);
    return static_cast<std::size_t>((turns - std::floor(turns)) * 2.0 * (kGapPoints - 1));
}

/// The least share that must be told of what is there: of all gaps together, and of each spike's.
struct Share {
    double of_all;
    double of_a_spike;
};

/// All that is told is there, and so much of what is there is told.
void expect_known(const Profile& profile, Joining joining, Share share) {
    const model::Mesh mesh = spiky();
    JobOptions options = small(kGapLayers, kGapPoints);
    options.axis_at = AxisAt::origin;
    options.joining = joining;
    SliceReport report;
    const auto plan = plan_job(mesh, profile, options, report);
    ASSERT_TRUE(plan.has_value()) << plan.error().message;
    const JobTable table = built(mesh, profile, options).table;
    const std::vector<Gap> sut = sunk_at_edges(mesh, profile, *plan, table);
    const std::vector<Searched> searched = GapOracle(mesh, profile, table, sut).search();
    ASSERT_EQ(sut.size(), searched.size());
    double most_mm = 0.0;
    for (const Gap& gap : sut) most_mm = std::max(most_mm, gap.sunk_mm);
    EXPECT_EQ(most_sunk_at_edges_mm(mesh, profile, *plan, table), most_mm) << name_of(joining);
    // A spiral crosses an edge that is taken for straight over a whole gap.
    const double slack_mm = joining == Joining::spiral ? 0.15 : 0.01;
    for (std::size_t k = 0; k < sut.size(); ++k)
        EXPECT_LE(sut[k].sunk_mm, searched[k].most_mm + slack_mm) << "gap " << k << ' ' << name_of(joining);
    const auto sum_mm = [](const auto& gaps, const auto& part) {
        return std::accumulate(gaps.begin(), gaps.end(), 0.0,
                               [&part](double sum, const auto& gap) { return sum + gap.*part; });
    };
    EXPECT_GE(sum_mm(sut, &Gap::sunk_mm), share.of_all * sum_mm(searched, &Searched::most_mm))
        << name_of(joining);
    if (profile.head_r2_angle_error_deg != 0.0) return;  // a spike may stand in another gap of each head
    for (const double direction_deg : kSpikes_deg) {
        const std::size_t k = gap_at(rad_from_deg(direction_deg));
        if (searched[k].most_mm < 0.2 || (joining == Joining::spiral && direction_deg == kAbove_deg))
            continue;
        EXPECT_GE(sut[k].sunk_mm, share.of_a_spike * searched[k].most_mm)
            << direction_deg << " deg, " << name_of(joining);
    }
}

Profile askew(Profile profile) {
    profile.head_r2_angle_error_deg = 8.3;
    profile.head_r2_height_error_mm = 0.9;
    profile.r1.tip_offset_mm = 0.7;
    return profile;
}

TEST(GapSearch, KnowsWhatAPointGoesInto) {
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        expect_known({}, joining, {0.98, 0.9});
        expect_known(askew({}), joining, {0.98, 0.9});
    }
}

TEST(GapSearch, KnowsWhatAToolGoesInto) {
    for (const ToolShape shape : {ToolShape::ball, ToolShape::vee}) {
        SCOPED_TRACE(name_of(shape));
        Profile profile;
        profile.tool = {shape, 2.4, 60.0, 0.0};
        // A tool that is wider than a gap is held out by what stands in the next one, too.
        const Share share = shape == ToolShape::ball ? Share{0.6, 0.5} : Share{0.85, 0.5};
        for (const Joining joining : {Joining::continuous, Joining::spiral}) {
            expect_known(profile, joining, share);
            expect_known(askew(profile), joining, share);
        }
    }
}

}  // namespace
}  // namespace psicarve::cam
