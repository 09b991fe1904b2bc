// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/offsets/source_numbers.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace psicarve::offsets {
namespace {

/// Another number in each place.
gcode::KeptOffsets all_unlike() {
    gcode::KeptOffsets kept;
    double next = 0.125;
    const auto fill = [&next](gcode::Position& place) {
        for (double& number : place) number = next++;
    };
    for (gcode::SystemOffset& system : kept.systems) {
        fill(system.origin);
        system.rotation_deg = next++;
    }
    fill(kept.shift);
    kept.is_shifted = true;
    fill(kept.references[0].emplace());
    return kept;
}

TEST(SourceNumbers, GiveBackTheOffsetsThatTheyStandFor) {
    for (gcode::KeptOffsets kept : {gcode::KeptOffsets{}, all_unlike()}) {
        EXPECT_EQ(kept_from(source_numbers(kept)), kept);
        kept.references[1] = gcode::Position{};
        kept.is_shifted = !kept.is_shifted;
        EXPECT_EQ(kept_from(source_numbers(kept)), kept);
    }
}

TEST(SourceNumbers, ThatNoProgramCanHaveBegunWithAreNone) {
    for (const double wrong : {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(), 2.0 * gcode::kMostOffset}) {
        SourceNumbers numbers = source_numbers(all_unlike());
        numbers[5] = wrong;
        EXPECT_FALSE(kept_from(numbers).has_value()) << wrong;
    }
}

}  // namespace
}  // namespace psicarve::offsets
