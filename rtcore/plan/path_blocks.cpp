// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/path_blocks.hpp"

#include <algorithm>
#include <utility>

#include "rtcore/cycle/braking.hpp"
#include "rtcore/plan/wide.hpp"

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;

// Stands for "no limit" where an axis does not move.
constexpr double kNoLimit = 1e30F;

PSICARVE_FOR_WIDE_REGISTERS
void set_timing(const MachineLimits& limits, const PathPiece& piece, cycle::PathTiming& timing) {
    timing.length = piece.length;
    for (std::size_t k = 0; k < timing.start_speed2.size(); ++k) {
        timing.start_speed2[k] = limits.pace * limits.pace * piece.begin_speed2[k];
        timing.end_speed2[k] = limits.pace * limits.pace * piece.end_speed2[k];
        timing.rest_speed2[k] = limits.pace * limits.pace * piece.rest_speed2[k];
    }
    Vec slope, bend;
    load(piece.slope, slope);
    load(piece.bend, bend);
    Vec accel, jump;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        accel[k] = limits.axes[k].accel_pps2;
        jump[k] = limits.axes[k].start_stop_pps;
    }
    const Vec accel_free = slope > 0.0 ? accel / slope : Vec{} + kNoLimit;
    const Vec accel_bend = slope > 0.0 ? bend / slope : Vec{};
    Vec start_stop = slope > 0.0 ? jump / slope : Vec{} + 1.0;
    lower_to(start_stop, Vec(Vec{} + 1.0));
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        timing.accel_free[k] = static_cast<float>(accel_free[k]);
        timing.accel_bend[k] = static_cast<float>(accel_bend[k]);
    }
    timing.start_stop_speed = static_cast<float>(least_of(start_stop));
}

}  // namespace

MotionBlock path_block(const MachineLimits& limits, const PathPiece& piece) {
    MotionBlock block{};
    block.kind = BlockKind::path;
    block.delta_pulses = piece.delta_pulses;
    for (std::size_t k = 0; k < kAxisCount; ++k)
        block.line_pulses[k] = static_cast<std::int32_t>(piece.line_pulses[k]);
    block.line_done = piece.line_done;
    set_timing(limits, piece, block.path);
    return block;
}

void note_gaps(const MachineLimits& limits, std::span<MotionBlock> run) {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (limits.tick.axes[k].backlash_pulses == 0) continue;
        const auto moves = [k](const MotionBlock& block) { return block.delta_pulses[k] != 0; };
        const auto first = std::find_if(run.begin(), run.end(), moves);
        if (first == run.end()) continue;
        std::uint8_t& axes = first->delta_pulses[k] > 0 ? run.front().up_axes : run.front().down_axes;
        axes = static_cast<std::uint8_t>(axes | 1U << k);
    }
}

// From the end, as fast as a brake to rest where the last way in the material begins could be.
void note_feed_ahead(std::span<MotionBlock> run, bool feed_follows) {
    double braked2 = 0.0;
    bool is_ahead = feed_follows;
    for (std::size_t i = run.size(); i-- > 0;) {
        MotionBlock& block = run[i];
        if (block.way == cycle::WayKind::feed) {
            is_ahead = true;
            braked2 = 0.0;
            continue;
        }
        is_ahead = is_ahead && braked2 < block.path.end_speed2[1];
        if (!is_ahead) continue;
        block.way = cycle::WayKind::to_feed;
        const double end2 = std::exchange(braked2, braked_speed2(block.path, braked2));
        const double above2 = braked2 - block.path.start_speed2[1];
        const double below2 = block.path.end_speed2[1] - end2;
        if (above2 > 0.0)
            block.path.feed_from = static_cast<float>(block.path.length * above2 / (above2 + below2));
    }
}

}  // namespace psicarve::plan
