// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/planner.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "tests/rtcore/plan/scripted_source.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::plan {
namespace {

using Blocks = std::vector<cycle::MotionBlock>;

struct OwnedJob {
    std::vector<std::byte> blob;
    JobView view;
};

constexpr std::uint32_t kLayers = 6;

std::shared_ptr<const JobView> some_job(std::uint32_t layers = kLayers) {
    JobTable table;
    table.layer_count = layers;
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
        planner.set_job(some_job(), 0);
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

// The next job is offered while the tick may already have taken a start of the last one.
TEST(Planner, CarvesTheJobThatTheTickWasAskedToStart) {
    const auto io = std::make_unique<cycle::CycleIo>();
    Planner sut{Profile{}, *io};
    const auto carve = [&](std::uint64_t generation, std::uint32_t layers) {
        cycle::PlanRequest request{};
        request.kind = cycle::PlanKind::position;
        request.job_generation = generation;
        request.end_layer = layers;
        ++request.epoch;
        io->plan_requests.push(request);
        sut.poll();
        request.kind = cycle::PlanKind::carve;
        ++request.epoch;
        io->plan_requests.push(request);
        sut.poll();
        return sut.points_total();
    };
    const std::shared_ptr<const JobView> first = some_job();
    const std::shared_ptr<const JobView> second = some_job(2);
    sut.set_job(first, 7);
    sut.set_job(second, 8);
    EXPECT_EQ(carve(7, 1), first->point_count());
    EXPECT_EQ(carve(8, 2), 2U * 60U);
    sut.set_job(first, 7);  // the second was refused
    EXPECT_EQ(carve(7, 1), first->point_count());
    sut.set_job(second, 9);
    EXPECT_EQ(carve(8, 2), 0U) << "no longer known: no program";
}

// Once each, and by its number.
TEST(Planner, RunsTheProgramThatTheTickWasAskedFor) {
    const auto io = std::make_unique<cycle::CycleIo>();
    Planner sut{Profile{}, *io};
    cycle::PlanRequest request{};
    request.kind = cycle::PlanKind::program;
    request.position_pulses = {6000, 6000, 0, 1000};
    request.program = 4;
    const auto blocks_made = [&] {
        ++request.epoch;
        io->plan_requests.push(request);
        sut.poll();
        cycle::MotionBlock block;
        std::size_t count = 0;
        while (io->blocks.pop_into(block)) ++count;
        return count;
    };
    test::Script script{request.position_pulses};
    script.way({-50, 0, 0, 0}, 0.0).end();
    const auto source = std::make_shared<test::ScriptedSource>(script.steps);
    sut.set_source(source, 5);
    EXPECT_EQ(blocks_made(), 0U) << "another one";
    request.program = 5;
    source->written = 1;
    EXPECT_GT(blocks_made(), 0U);
    EXPECT_EQ(source->start, request.position_pulses);
    EXPECT_TRUE(sut.is_waiting());
    EXPECT_TRUE(sut.wants_poll());
    source->written = 2;
    sut.poll();
    EXPECT_FALSE(sut.is_waiting());
    EXPECT_FALSE(sut.wants_poll());
    EXPECT_EQ(io->blocks.size(), 2U);
    cycle::MotionBlock block;
    while (io->blocks.pop_into(block)) {
    }
    EXPECT_EQ(blocks_made(), 0U) << "it was run already";
}

}  // namespace
}  // namespace psicarve::plan
