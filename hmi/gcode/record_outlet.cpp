// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/record_outlet.hpp"

#include <algorithm>
#include <utility>

namespace psicarve::gcode {

void RecordOutlet::put(const MotionRecord& record) {
    if (record.kind != MotionKind::way) narrow(0.0);
    if (held_ && held_->line != record.line) end_block();
    give();
    held_ = record;
}

void RecordOutlet::narrow(double tolerance_mm) noexcept {
    if (held_ && held_->kind == MotionKind::way)
        held_->tolerance_mm = std::min(held_->tolerance_mm, tolerance_mm);
}

void RecordOutlet::end_block() noexcept {
    if (held_) held_->flags |= kEndsBlock;
}

void RecordOutlet::flush() {
    narrow(0.0);
    end_block();
    give();
}

void RecordOutlet::fail(Error error) {
    if (!failure_) failure_ = std::move(error);
}

void RecordOutlet::give() {
    if (!held_) return;
    MotionRecord record = *held_;
    held_.reset();
    if (failure_) return;
    record.program = program_;
    record.sequence = ++sequence_;
    record.check = record_check(record);
    if (const auto taken = sink_.take(record); !taken) fail(taken.error());
}

}  // namespace psicarve::gcode
