// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/offsets_log.hpp"

#include <algorithm>

namespace psicarve::gcode {

OffsetsLog::OffsetsLog(const KeptOffsets& begin) : states_{{0, begin}} {}

void OffsetsLog::set(const KeptOffsets& offsets, std::uint64_t records) {
    const std::lock_guard lock{mutex_};
    if (offsets == states_.back().offsets) return;
    if (states_.back().first == records + 1) {
        states_.back().offsets = offsets;
    } else {
        states_.push_back({records + 1, offsets});
    }
}

void OffsetsLog::note(std::uint64_t line) {
    const std::lock_guard lock{mutex_};
    ++noted_;
    const bool goes_on = !runs_.empty() && runs_.back().line == line && states_.back().first != noted_;
    if (goes_on) {
        runs_.back().last = noted_;
    } else {
        runs_.push_back({noted_, noted_, line});
    }
}

void OffsetsLog::reach(std::uint64_t line, std::uint64_t taken) {
    const std::lock_guard lock{mutex_};
    const std::uint64_t least = std::max(reached_, taken > kMostAhead ? taken - kMostAhead : 0);
    forget_before(least);
    const auto found = std::ranges::find_if(
        runs_, [&](const Run& run) { return run.line == line && run.first <= taken && run.last >= least; });
    if (found == runs_.end()) return;
    reached_ = std::max(reached_, found->first);
    while (states_.size() > 1 && states_[1].first <= reached_) states_.pop_front();
}

void OffsetsLog::forget_before(std::uint64_t record) {
    while (!runs_.empty() && runs_.front().last < record) runs_.pop_front();
}

KeptOffsets OffsetsLog::reached() const {
    const std::lock_guard lock{mutex_};
    return states_.front().offsets;
}

KeptOffsets OffsetsLog::last() const {
    const std::lock_guard lock{mutex_};
    return states_.back().offsets;
}

bool OffsetsLog::has_reached() const {
    const std::lock_guard lock{mutex_};
    return reached_ > 0;
}

}  // namespace psicarve::gcode
