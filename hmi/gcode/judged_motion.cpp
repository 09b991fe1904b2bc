// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/judged_motion.hpp"

namespace psicarve::gcode {

JudgedMotion::JudgedMotion(const Profile& profile, ProblemList& problems, RecordMaker& maker,
                           KeptOffsets& offsets, ModesTrail& trail)
    : machine_(profile, problems), problems_(problems), maker_(maker), offsets_(offsets), trail_(trail) {}

bool JudgedMotion::is_right(const CanonRecord& record) {
    if (!is_wrong()) machine_.take(record);
    return !is_wrong();
}

void JudgedMotion::take(const CanonRecord& record) {
    if (is_rehearsed_) {
        if (!is_wrong()) give(record);
        return;
    }
    if (is_right(record)) held_.push_back(record);
}

void JudgedMotion::set_modes(const ActiveModes& modes) {
    if (is_rehearsed_) return trail_.set_modes(modes);
    held_modes_.emplace_back(held_.size(), modes);
}

void JudgedMotion::set_offsets(const KeptOffsets& kept) {
    if (!is_wrong()) offsets_ = kept;
}

CanonSink* JudgedMotion::rehearsal() {
    give_held();
    is_rehearsed_ = true;
    return &rehearsal_;
}

void JudgedMotion::end_block() {
    give_held();
    is_rehearsed_ = false;
    maker_.end_block();
}

/// All that is held of a block that is right.
void JudgedMotion::give_held() {
    auto modes = held_modes_.begin();
    for (std::size_t n = 0; n < held_.size() && wants_more(); ++n) {
        for (; modes != held_modes_.end() && modes->first <= n; ++modes) trail_.set_modes(modes->second);
        give(held_[n]);
    }
    for (; modes != held_modes_.end(); ++modes) trail_.set_modes(modes->second);
    held_.clear();
    held_modes_.clear();
}

void JudgedMotion::give(const CanonRecord& record) {
    if (!record.begins_within) trail_.begin_way(maker_.record_count() + 1);
    maker_.take(record);
}

}  // namespace psicarve::gcode
