// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "rtcore/cycle/motion_block.hpp"

namespace psicarve::plan {

/// How much of a table has been planned: for estimates of the time left.
struct PlannedSoFar {
    std::uint64_t points = 0;  ///< those of layers that are left out do not count
    double seconds = 0.0;
    bool is_reference = false;  ///< the seconds are the least that the limits allow: T_ref
};

/// Motion blocks in order, made as they are asked for. The last one is program_end, unless what makes them is
/// lost.
class Program {
public:
    virtual ~Program() = default;
    /// The next block but for its epoch; false when there is none, for good unless is_waiting().
    virtual bool next(cycle::MotionBlock& block) = 0;
    /// next() found nothing yet, but more may come: it is to be asked again.
    virtual bool is_waiting() const { return false; }
    virtual PlannedSoFar planned() const { return {}; }
};

/// A short program, made at once.
class ListProgram final : public Program {
public:
    explicit ListProgram(std::vector<cycle::MotionBlock> blocks) : blocks_(std::move(blocks)) {}
    bool next(cycle::MotionBlock& block) override {
        if (next_ == blocks_.size()) return false;
        block = blocks_[next_++];
        return true;
    }

private:
    std::vector<cycle::MotionBlock> blocks_;
    std::size_t next_ = 0;
};

}  // namespace psicarve::plan
