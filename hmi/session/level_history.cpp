// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/level_history.hpp"

namespace psicarve::session {

void LevelHistory::note(const CoreStatus& status, Clock::time_point now) {
    Look look{now, status.signals, {}};
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const std::uint64_t emitted = status.emitted_pulses[k];
        // Counts begin anew with every job.
        if (!looks_.empty() && emitted > emitted_[k]) look.pulses[k] = emitted - emitted_[k];
        emitted_[k] = emitted;
    }
    looks_.push_back(look);
    // One sample older than shown: the line begins there.
    while (looks_.size() > 2 && now - looks_[1].time > kLength) looks_.pop_front();
}

void LevelHistory::forget() noexcept {
    looks_.clear();
}

}  // namespace psicarve::session
