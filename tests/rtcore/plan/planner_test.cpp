// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/planner.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::plan {
namespace {

using Blocks = std::vector<cycle::MotionBlock>;

struct OwnedJob {
    std::vector<std::byte> blob;
    JobView view;
};

constexpr std::uint32_t kLayers = 6;

std::shared_ptr<const JobView> some_job() {
    JobTable table;
    table.layer_count = kLayers;
    table.point_count = 60;
    table.psi_sweep_pulses = 3200;
    table.feed_mm_s = 20.0;
    table.profile_toml = profile_to_toml(Profile{});
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        table.layer_height_pulses.push_back(100 + 50 * layer);
        for (std::uint32_t point = 0; point < table.point_count; ++point) {
            const auto wave = static_cast<std::int32_t>((point * 37 + layer * 11) % 60);
            table.r_left_pulses.push_back(5000 + wave);
            table.r_right_pulses.push_back(5300 - wave);
        }
    }
    auto owned = std::make_shared<OwnedJob>();
    owned->blob = job_blob_from_table(table);
    owned->view = JobView::check(owned->blob).value();
    return {owned, &owned->view};
}

/// A planner that has been asked to carve, and what it queued.
struct AskedPlanner {
    AskedPlanner() : io(std::make_unique<cycle::CycleIo>()), planner(Profile{}, *io) {
        planner.set_job(some_job());
        cycle::PlanRequest request{};
        request.kind = cycle::PlanKind::position;
        io->plan_requests.push(request);
        request.kind = cycle::PlanKind::carve;
        request.end_layer = kLayers;
        io->plan_requests.push(request);
    }
    Blocks take() const {
        Blocks blocks;
        cycle::MotionBlock block;
        while (io->blocks.pop_into(block)) blocks.push_back(block);
        return blocks;
    }

    std::unique_ptr<cycle::CycleIo> io;
    Planner planner;
};

TEST(Planner, AsksAfterEachBlockWhetherThereIsTimeForMore) {
    AskedPlanner asked;
    std::size_t count = 0;
    asked.planner.poll([&] { return ++count < 7; });
    EXPECT_EQ(count, 7U);
    EXPECT_EQ(asked.take().size(), 7U);
    EXPECT_TRUE(asked.planner.wants_poll());
}

TEST(Planner, PlansTheSameInHoweverManyPieces) {
    AskedPlanner whole;
    whole.planner.poll();
    const Blocks expected = whole.take();
    ASSERT_GT(expected.size(), 1000U);

    AskedPlanner pieces;
    for (std::size_t round = 1; pieces.planner.wants_poll(); ++round) {
        std::size_t left = 1 + round * 31 % 97;
        pieces.planner.poll([&] { return --left > 0; });
    }
    const Blocks made = pieces.take();
    ASSERT_EQ(made.size(), expected.size());
    EXPECT_EQ(std::memcmp(made.data(), expected.data(), made.size() * sizeof made.front()), 0);
}

}  // namespace
}  // namespace psicarve::plan
