// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/line_stop.hpp"

#include "rtcore/cycle/braking.hpp"

namespace psicarve::cycle {
namespace {

// A little slower than what may end in a jump, so that rounding does not go past it.
constexpr double kRestShare2 = 0.98;

}  // namespace

void LineStop::seek(const BlockFeed& feed) noexcept {
    state_ = State::seeking;
    cursor_ = feed.number();
    left_ = feed.blocks_left();
    nearest_ = 0;
}

void LineStop::seek_next(const BlockFeed& feed) noexcept {
    if (end_ > feed.number()) nearest_ = end_ + (end_ - feed.number()) / 2;
    seek_behind(feed);
}

void LineStop::seek_behind(const BlockFeed& feed) noexcept {
    state_ = State::seeking;
    cursor_ = end_;
    if (!step_forward(feed)) state_ = State::idle;
}

bool LineStop::look(const BlockFeed& feed, int blocks) noexcept {
    if (is_passed(feed.number())) seek(feed);
    for (int i = 0; i < blocks; ++i) {
        if (state_ == State::seeking) {
            if (!seek_one(feed)) return false;
        } else if (state_ == State::braking) {
            if (brake_one(feed)) return true;
        } else {
            return false;
        }
    }
    return false;
}

// False: what comes next is not queued.
bool LineStop::seek_one(const BlockFeed& feed) noexcept {
    const MotionBlock* const block = feed.numbered(cursor_);
    if (block == nullptr) return false;
    const bool rests = left_ == 0 && (block->joints & kGoesOn) == 0;
    if (rests) {
        state_ = State::none;
        return true;
    }
    if ((block->marks & mark_) == 0 || cursor_ < nearest_) return step_forward(feed);
    state_ = State::braking;
    end_ = cursor_;
    const double jump = double{block->path.start_stop_speed};
    end2_ = kRestShare2 * jump * jump;
    braked2_ = end2_;
    return true;
}

// The block behind the cursor's; false: it is not queued.
bool LineStop::step_forward(const BlockFeed& feed) noexcept {
    const MotionBlock* const next = feed.numbered(cursor_ + 1);
    if (next == nullptr) return false;
    left_ = left_ > 0 ? left_ - 1 : next->group_blocks - 1;
    ++cursor_;
    return true;
}

// True: all that it takes is known.
bool LineStop::brake_one(const BlockFeed& feed) noexcept {
    if (cursor_ < feed.number()) {
        first_ = feed.number();
        state_ = State::found;
        return true;
    }
    const MotionBlock* const block = feed.numbered(cursor_);
    if (block == nullptr || end_ - cursor_ >= kMostBlocks - 1) {
        seek_behind(feed);
        return false;
    }
    braked2_ = braked_speed2(block->path, braked2_);
    begins2_[cursor_ % kMostBlocks] = braked2_;
    first_ = cursor_;
    if (braked2_ >= block->path.start_speed2[1] || cursor_ == feed.number()) {
        state_ = State::found;
        return true;
    }
    --cursor_;
    return false;
}

}  // namespace psicarve::cycle
