// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/bending_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "rtcore/plan/lookahead_program.hpp"
#include "rtcore/plan/speed_up.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"
#include "tests/places.hpp"
#include "tests/reference/table_csv.hpp"

namespace psicarve::plan {
namespace {

constexpr Lanes kFourAccels{100.0, 200.0, 400.0, 800.0};

PathCell bent_cell(double length, const Lanes& slope_begin, const Lanes& bend) {
    PathCell cell{length, slope_begin, slope_begin, bend};
    for (std::size_t k = 0; k < kAxisCount; ++k) cell.slope_end[k] += length * bend[k];
    return cell;
}

TEST(BendingWeights, GrowWithWhatAnAxisAccelerates) {
    // x = 4 at an even speed: q'' * x is half, all, twice and none of what the axes may.
    const std::vector<PathCell> cells{bent_cell(0.1, {}, {12.5, -50.0, 200.0, 0.0})};
    std::vector<Lanes> weights;
    EXPECT_EQ(weigh_bending(cells, std::vector<double>{4.0, 4.0}, kFourAccels, weights), 1.0);
    ASSERT_EQ(weights.size(), 1U);
    EXPECT_NEAR(weights[0][0], 0.5625, 1e-12);
    EXPECT_NEAR(weights[0][1], 1.0, 1e-12);
    EXPECT_NEAR(weights[0][2], 1.0, 1e-12);
    EXPECT_NEAR(weights[0][3], 0.25, 1e-12);
}

TEST(BendingWeights, CountWhatTheSpeedAlongTheWayTakes) {
    // x' = 10 along a slope of 10: q' * x' / 2 = 50, less what bending by -10 takes at x = 1.5 in the middle.
    const std::vector<PathCell> cells{bent_cell(0.1, {10.0, 10.5, 0.0, 0.0}, {0.0, -10.0, 0.0, 0.0})};
    std::vector<Lanes> weights;
    EXPECT_EQ(weigh_bending(cells, std::vector<double>{1.0, 2.0}, kFourAccels, weights), 0.0);
    EXPECT_NEAR(weights[0][0], 0.5625, 1e-12);
    EXPECT_NEAR(weights[0][1], std::pow(0.5 + 0.5 * (10.0 * 10.0 / 2.0 - 15.0) / 200.0, 2.0), 1e-12);
}

TEST(BendingWeights, TellTheTimeThatAnAxisIsAtItsLimit) {
    // One second at x = 4 with 0.91 of an axis' acceleration, then slowing down to x = 1 with 0.89 of
    // another's at most.
    const std::vector<PathCell> cells{bent_cell(1e-9, {}, {25.0, 0.0, 0.0, 0.0}),
                                      bent_cell(2.0, {}, {22.75, 0.0, 0.0, 0.0}),
                                      bent_cell(3.0, {}, {0.0, 0.0, 356.0, 0.0})};
    std::vector<Lanes> weights;
    const std::vector<double> speed2{4.0, 4.0, 4.0, 1.0};
    const double seconds = 2.0 * 3.0 / 3.0;
    EXPECT_NEAR(weigh_bending(cells, speed2, {100.0, 1000.0, 1000.0, 1.0}, weights), 1.0 / (1.0 + seconds),
                1e-6);
}

// The straight way at full acceleration: no curve is faster.
TEST(BendingWeights, TellThatNothingIsToBeGainedWhereNothingBends) {
    std::vector<PathCell> cells{bent_cell(0.1, {2000.0, 0.0, 0.0, 0.0}, {0.9, 0.0, 0.0, 0.0})};
    std::vector<Lanes> weights;
    EXPECT_EQ(weigh_bending(cells, std::vector<double>{0.0, 0.01}, kFourAccels, weights), 0.0);
    cells[0] = bent_cell(0.1, {2000.0, 0.0, 0.0, 0.0}, {2500.0, 0.0, 0.0, 0.0});
    EXPECT_EQ(weigh_bending(cells, std::vector<double>{0.0, 0.01}, kFourAccels, weights), 1.0);
}

TEST(EvenBending, CountsWhereItIsWithinItsTubeAndFasterAtEveryOverride) {
    const FittedTimes least{true, {1.0, 0.8}};
    EXPECT_TRUE(is_worthwhile({true, {0.997, 0.8}}, least));
    EXPECT_FALSE(is_worthwhile({true, {0.999, 0.7}}, least));
    EXPECT_FALSE(is_worthwhile({true, {0.9, 0.801}}, least));
    EXPECT_FALSE(is_worthwhile({false, {0.9, 0.7}}, least));
}

TEST(EvenBending, ReplacesACurveThatLeftItsTube) {
    EXPECT_TRUE(is_worthwhile({true, {1.1, 1.1}}, {false, {1.0, 0.8}}));
    EXPECT_FALSE(is_worthwhile({false, {0.9, 0.7}}, {false, {1.0, 0.8}}));
}

/// A layer, and the least time over all curves and timings that docs/motion_yardstick.md has for it.
struct KnownLayer {
    const char* table;
    const char* machine;  ///< of examples/; "": the built-in profile
    double least_s;
    double most;  ///< of T_ref over that
};

void PrintTo(const KnownLayer& layer, std::ostream* out) {
    *out << layer.table;
}

class KnownLayers : public ::testing::TestWithParam<KnownLayer> {};

TEST_P(KnownLayers, AreWithinFivePerCentOfTheLeastTimeFound) {
    const KnownLayer& known = GetParam();
    const Profile profile = *known.machine == '\0' ? Profile{} : load_profile(example(known.machine)).value();
    const std::string file = in_source("tests/motion/tables/") + known.table + ".csv";
    const std::vector<std::byte> blob = job_blob_from_table(table_from_csv(file, profile, {2, 2}).value());
    LookaheadProgram program(machine_limits(profile),
                             std::make_shared<const JobView>(JobView::check(blob).value()));
    double seconds = 0.0;
    cycle::MotionBlock block;
    while (program.next(block)) {
        if (block.kind == cycle::BlockKind::path) seconds += path_seconds(block.path);
    }
    EXPECT_LT(seconds, known.most * known.least_s) << seconds;
    EXPECT_GT(seconds, 0.95 * known.least_s) << seconds << ": is it the layer that was measured?";
}

INSTANTIATE_TEST_SUITE_P(Yardstick, KnownLayers,
                         ::testing::Values(KnownLayer{"vase", "", 2.794, 1.002},
                                           KnownLayer{"figurine", "", 6.722, 1.01},
                                           KnownLayer{"gear", "", 7.983, 0.98},
                                           KnownLayer{"relief", "", 8.832, 1.025},
                                           KnownLayer{"scan", "", 5.188, 0.995},
                                           KnownLayer{"figurine_fine", "fine.toml", 5.445, 1.05},
                                           KnownLayer{"scan_fine", "fine.toml", 4.400, 1.05}),
                         [](const auto& each) { return std::string{each.param.table}; });

}  // namespace
}  // namespace psicarve::plan
