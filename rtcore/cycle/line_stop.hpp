// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/block_feed.hpp"
#include "rtcore/cycle/motion_block.hpp"

namespace psicarve::cycle {

/// Where a program can come to rest without leaving its curve: at the next block with its mark, as the end of
/// a line, that a brake from here reaches. Looks at a few queued blocks a tick, so that a tick stays
/// short:
///
///     (du/dt)^2  ~~~~~~~~~~~~~.           plan at 200 %           first it seeks the next end of a line,
///           |                   ` .  bounds                       then it goes back from there, as fast as a
///           |     at hand           ` .                           brake may begin, up to the block at hand
///           or |        |                  `|                        to where every plan is slower
///           +--------+-------------------+------- u
///                                        end of a line
///
/// Blocks are known by their number in BlockFeed. RT: yes.
class LineStop {
public:
    /// (du/dt)^2 at a block's begin and end that must not be exceeded there, for a rest at the line's end.
    struct Bounds {
        double begin2, end2;
    };
    static constexpr int kBlocksPerTick = 16;
    /// At rest, so that a short line is not over before its end is found.
    static constexpr int kBlocksAtRest = 64;

    explicit LineStop(std::uint8_t mark = kEndsLine) noexcept : mark_(mark) {}

    std::uint8_t mark() const noexcept { return mark_; }
    void forget() noexcept { state_ = State::idle; }
    /// From the block at hand on.
    void seek(const BlockFeed& feed) noexcept;
    /// Not there: it is too fast by now. One is sought that is half as far again: a look goes over all blocks
    /// up to it, and lines of a few blocks would be passed as fast as they are looked at.
    void seek_next(const BlockFeed& feed) noexcept;
    /// Looks at so many blocks; true once, when an end is found. The block at hand may have bounds already.
    bool look(const BlockFeed& feed, int blocks) noexcept;

    /// Whether the block has bounds.
    bool holds(std::uint64_t number) const noexcept {
        return state_ == State::found && number >= first_ && number <= end_;
    }
    /// Requires holds().
    Bounds bounds(std::uint64_t number) const noexcept {
        return {begins2_[number % kMostBlocks],
                number == end_ ? end2_ : begins2_[(number + 1) % kMostBlocks]};
    }
    /// It comes to rest where this block ends.
    bool ends_at(std::uint64_t number) const noexcept { return state_ == State::found && number == end_; }

private:
    /// More than a brake goes through; at the end of a line that asks for more it does not rest.
    static constexpr std::size_t kMostBlocks = 4096;

    enum class State : std::uint8_t {
        idle,
        seeking,
        braking,
        found,
        none,  ///< the run comes to rest before a line ends in it
    };

    bool is_passed(std::uint64_t number) const noexcept {
        if (state_ == State::idle) return true;
        return state_ == State::seeking ? cursor_ < number : state_ != State::none && end_ < number;
    }
    void seek_behind(const BlockFeed& feed) noexcept;
    bool seek_one(const BlockFeed& feed) noexcept;
    bool brake_one(const BlockFeed& feed) noexcept;
    bool step_forward(const BlockFeed& feed) noexcept;

    std::uint8_t mark_;
    State state_ = State::idle;
    std::uint64_t cursor_ = 0;   ///< the block to be looked at next
    std::uint64_t end_ = 0;      ///< with which the line ends
    std::uint64_t nearest_ = 0;  ///< ends before it are not looked at
    std::uint64_t first_ = 0;    ///< of those with bounds
    std::uint32_t left_ = 0;     ///< blocks of its group behind the one that is sought at, or behind end_
    double end2_ = 0.0;
    double braked2_ = 0.0;
    std::array<double, kMostBlocks> begins2_{};
};

}  // namespace psicarve::cycle
