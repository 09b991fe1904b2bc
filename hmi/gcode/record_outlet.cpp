// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/record_outlet.hpp"

#include <utility>

namespace psicarve::gcode {

void RecordOutlet::put(const MotionRecord& record) {
    if (held_ && held_->line != record.line) end_block();
    give();
    held_ = record;
}

void RecordOutlet::end_block() {
    if (held_) held_->flags |= kEndsBlock;
    give();
}

void RecordOutlet::flush() {
    end_block();
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
