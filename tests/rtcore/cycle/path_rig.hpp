// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/executor.hpp"
#include "rtcore/cycle/inputs.hpp"
#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/cycle/pulse_stage.hpp"

namespace psicarve::cycle {

using Deltas = std::array<std::int64_t, kAxisCount>;

inline constexpr double kPathTick_s = 5e-5;

/// Which axes stepped at which tick.
struct Iteration {
    std::uint64_t tick;
    std::uint32_t axes;
};

/// An executor that is fed hand-made path blocks and ticked until they are done.
class PathRig {
public:
    explicit PathRig(const CycleConfig& cycle_config = {})
        : config(cycle_config),
          blocks(std::make_unique<BlockRing>()),
          pulses(config),
          inputs(config),
          executor(config, *blocks, pulses, inputs) {}

    Executor::Progress tick() {
        while (next_ < program.size() && blocks->push(program[next_])) ++next_;
        pulses.begin_tick(now);
        const std::array<std::uint64_t, kAxisCount> before = pulses.emitted();
        const Executor::Progress progress = executor.step(now);
        std::uint32_t axes = 0;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if (pulses.emitted()[k] != before[k]) axes |= 1U << k;
        }
        if (axes != 0) iterations.push_back({now, axes});
        if ((progress & Executor::kGroupStarted) != 0) start_tick = now;
        if ((progress & Executor::kPoint) != 0) points.push_back({now, executor.progress().point()});
        seen |= progress;
        ++now;
        return progress;
    }
    /// Until the program's end; false when it does not come.
    bool run(std::uint64_t most_ticks = 100'000'000) {
        for (std::uint64_t n = 0; n < most_ticks; ++n) {
            if ((tick() & Executor::kProgramEnd) != 0) return true;
            if ((seen & Executor::kStarved) != 0) return false;
        }
        return false;
    }

    CycleConfig config;
    std::unique_ptr<BlockRing> blocks;
    PulseStage pulses;
    Inputs inputs;
    Executor executor;
    std::vector<MotionBlock> program;
    std::vector<Iteration> iterations;
    std::vector<Iteration> points;  ///< `axes` is the point's number
    std::uint64_t now = 0;
    std::uint64_t start_tick = 0;
    Executor::Progress seen = 0;

private:
    std::size_t next_ = 0;
};

/// Speeds in u per tick at 100 %; twice that at 200 %.
inline MotionBlock path_block(const Deltas& delta_pulses, double length, double start_speed,
                              double end_speed) {
    MotionBlock block{};
    block.kind = BlockKind::path;
    block.delta_pulses = delta_pulses;
    block.path.length = length;
    for (std::size_t p = 0; p < 2; ++p) {
        const double scale = p == 0 ? 1.0 : 2.0;
        block.path.start_speed2[p] = scale * scale * start_speed * start_speed / (kPathTick_s * kPathTick_s);
        block.path.end_speed2[p] = scale * scale * end_speed * end_speed / (kPathTick_s * kPathTick_s);
    }
    block.path.accel_free.fill(static_cast<float>(1e-4 / (kPathTick_s * kPathTick_s)));
    block.path.start_stop_speed = static_cast<float>(0.02 / kPathTick_s);
    return block;
}

/// The blocks as one run, with the program's end behind it.
inline std::vector<MotionBlock> as_run(std::vector<MotionBlock> blocks) {
    blocks.front().group_blocks = static_cast<std::uint32_t>(blocks.size());
    MotionBlock end{};
    end.kind = BlockKind::program_end;
    blocks.push_back(end);
    return blocks;
}

}  // namespace psicarve::cycle
