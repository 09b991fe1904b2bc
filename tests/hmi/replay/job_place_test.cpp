// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/job_place.hpp"

#include <gtest/gtest.h>

#include "shared/job/job.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::replay {
namespace {

/// Point counts that share no factor with the sweep's pulses.
TEST(JobPlaceOfPositions, FindsEveryPointOfEveryWayToJoinLayers) {
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        Profile profile;
        profile.job.joining = joining;
        const auto blob = job_blob_from_table(two_process::lobed_job(7, 47, profile));
        const auto view = JobView::check(blob);
        ASSERT_TRUE(view) << view.error().message;
        const auto geometry = verify::JobGeometry::make(*view, profile);
        ASSERT_TRUE(geometry);
        for (std::uint32_t layer = 0; layer < 7; ++layer) {
            // Where a spiral begins to rise it lies on the ring before it.
            for (std::uint32_t step = joining == Joining::spiral ? 6 : 1; step + 1 < 47; ++step) {
                const auto place = job_place(*geometry, geometry->target(layer, step));
                ASSERT_TRUE(place);
                EXPECT_EQ(place->layer, layer) << name_of(joining) << " " << step;
                EXPECT_EQ(place->point, step) << name_of(joining) << " " << layer;
            }
        }
        auto above = geometry->target(6, 0);
        above[index_of(Axis::y)] += 10'000;
        EXPECT_FALSE(job_place(*geometry, above));
    }
}

}  // namespace
}  // namespace psicarve::replay
