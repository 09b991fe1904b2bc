// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "rtcore/cycle/motion_block.hpp"

namespace psicarve::cycle {

/// Takes the plan's motion blocks from their queue, one after another, and holds the block at hand. Blocks of
/// dropped plans never become it. A group of lines or path segments begins once all of it is queued, or
/// kGroupStartBlocks of it: then it cannot run dry. Groups may follow one another without a rest. The queue
/// outlives it. RT: yes.
class BlockFeed {
public:
    explicit BlockFeed(BlockRing& blocks) noexcept : blocks_(&blocks) {}

    /// Only blocks of this epoch come from now on; a pause and the group at hand end.
    void reset(std::uint32_t epoch) noexcept {
        epoch_ = epoch;
        pause_ticks_left_ = 0;
        group_blocks_left_ = 0;
        set_program_line(block_, 0);
        block_.marks = 0;
    }

    /// All that is queued of other epochs at once, however much: for virtual time, not in the tick.
    void drop_overtaken() noexcept;

    /// At rest, every tick. True: the block at hand is the next of the plan, the first of its group. False:
    /// there is none, its group is not queued yet, or a pause goes on.
    bool take_first() noexcept;
    /// For so many ticks take_first() says no.
    void pause(std::int64_t ticks) noexcept { pause_ticks_left_ = ticks; }

    /// At rest: no block is queued, nor does a pause go on.
    bool has_run_out() const noexcept { return pause_ticks_left_ == 0 && blocks_->front() == nullptr; }

    /// The block at hand is the last of its group.
    bool is_last_of_group() const noexcept { return group_blocks_left_ == 0; }
    /// Requires !is_last_of_group(). False: the group breaks off here, and the block at hand stays.
    bool take_next_of_group() noexcept;
    /// That which comes next without a rest, or nullptr if it is not queued.
    const MotionBlock* next_of_group() const noexcept;

    /// The group at hand goes on in the next one.
    bool goes_on() const noexcept { return (block_.joints & kGoesOn) != 0; }
    /// The block at hand carries on a group that has ended before it.
    bool carries_on() const noexcept { return (block_.joints & kCarriesOn) != 0; }
    /// It goes on, and the next group may begin: all of that is queued, or kGroupGoesOnBlocks of it.
    bool has_next_group() const noexcept;
    /// Requires is_last_of_group(). False: there is no next group yet, or none; the block at hand stays.
    bool take_next_group() noexcept;
    const MotionBlock& block() const noexcept { return block_; }
    /// How many blocks were taken, that at hand included: its number.
    std::uint64_t number() const noexcept { return number_; }
    /// The block at hand or one that is queued behind it; nullptr: not queued.
    const MotionBlock* numbered(std::uint64_t number) const noexcept;
    /// Of the group, behind the block at hand.
    std::uint32_t blocks_left() const noexcept { return group_blocks_left_; }
    /// At rest: all marks of the block at hand if one of them is wanted and nothing of it goes on; else, and
    /// asked again: 0.
    std::uint8_t take_marks(std::uint8_t wanted) noexcept {
        if (pause_ticks_left_ > 0 || (block_.marks & wanted) == 0) return 0;
        return std::exchange(block_.marks, std::uint8_t{0});
    }
    /// Of a halt: it is decided, and nothing waits behind it.
    void forget_marks() noexcept { block_.marks = 0; }
    /// An axis of the block at hand goes so much further.
    void lengthen(std::size_t axis, std::int64_t extra_pulses) noexcept {
        block_.delta_pulses[axis] += extra_pulses;
    }
    /// How many points of the job the block at hand reaches with its end; asked again: 0.
    std::uint32_t take_points() noexcept { return std::exchange(block_.reaches_points, std::uint8_t{0}); }

private:
    void take(const MotionBlock& front) noexcept;
    bool drop_foreign_blocks() noexcept;

    BlockRing* blocks_;
    MotionBlock block_{};
    std::uint32_t epoch_ = 0;
    std::uint64_t number_ = 0;
    std::uint32_t group_blocks_left_ = 0;
    std::int64_t pause_ticks_left_ = 0;
};

}  // namespace psicarve::cycle
