// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/block_feed.hpp"

#include <algorithm>

namespace psicarve::cycle {
namespace {

// Dropping a whole queue of another epoch in one tick would take too long.
constexpr int kDropsPerTick = 64;

}  // namespace

bool BlockFeed::take_first() noexcept {
    if (pause_ticks_left_ > 0) {
        --pause_ticks_left_;
        return false;
    }
    if (!drop_foreign_blocks()) return false;
    const MotionBlock& front = *blocks_->front();
    if ((front.kind == BlockKind::line || front.kind == BlockKind::path) &&
        blocks_->size() < std::min<std::size_t>(front.group_blocks, kGroupStartBlocks)) {
        return false;
    }
    take(front);
    group_blocks_left_ = block_.group_blocks > 0 ? block_.group_blocks - 1 : 0;
    return true;
}

bool BlockFeed::take_next_of_group() noexcept {
    const MotionBlock* const next = next_of_group();
    if (next == nullptr) return false;
    take(*next);
    --group_blocks_left_;
    return true;
}

const MotionBlock* BlockFeed::next_of_group() const noexcept {
    if (is_last_of_group()) return has_next_group() ? blocks_->front() : nullptr;
    const MotionBlock* const next = blocks_->front();
    const bool belongs = next != nullptr && next->epoch == epoch_ && next->kind == block_.kind;
    return belongs ? next : nullptr;
}

bool BlockFeed::has_next_group() const noexcept {
    if (!goes_on()) return false;
    const MotionBlock* const first = blocks_->ahead(group_blocks_left_);
    if (first == nullptr || first->epoch != epoch_ || (first->joints & kCarriesOn) == 0) return false;
    return blocks_->size() - group_blocks_left_ >=
           std::min<std::size_t>(first->group_blocks, kGroupGoesOnBlocks);
}

bool BlockFeed::take_next_group() noexcept {
    if (!has_next_group()) return false;
    take(*blocks_->front());
    group_blocks_left_ = block_.group_blocks - 1;
    return true;
}

void BlockFeed::take(const MotionBlock& front) noexcept {
    block_ = front;
    blocks_->pop();
    ++number_;
}

const MotionBlock* BlockFeed::numbered(std::uint64_t number) const noexcept {
    if (number == number_) return &block_;
    const MotionBlock* const queued = blocks_->ahead(static_cast<std::size_t>(number - number_ - 1));
    return queued != nullptr && queued->epoch == epoch_ ? queued : nullptr;
}

void BlockFeed::drop_overtaken() noexcept {
    while (blocks_->front() != nullptr && blocks_->front()->epoch != epoch_) blocks_->pop();
}

bool BlockFeed::drop_foreign_blocks() noexcept {
    for (int i = 0; i < kDropsPerTick; ++i) {
        const MotionBlock* const front = blocks_->front();
        if (front == nullptr) return false;
        if (front->epoch == epoch_) return true;
        blocks_->pop();
    }
    return false;
}

}  // namespace psicarve::cycle
