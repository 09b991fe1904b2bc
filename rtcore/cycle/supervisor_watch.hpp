// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::cycle {

/// Whether the supervisor, which hands requests on, still comes round. Ticks that did not come are not
/// counted: then the computer stood still, and the gap is told by itself. RT: yes.
class SupervisorWatch {
public:
    static constexpr std::int64_t kLongestSilence_ns = 1'000'000'000;

    /// Every tick. `rounds`: the word that the supervisor counts up; 0: it does not. True once, in the tick
    /// in which the silence becomes too long.
    bool falls_silent(std::uint64_t rounds, std::int64_t tick_ns) noexcept {
        if (rounds != rounds_seen_ || rounds == 0) {
            rounds_seen_ = rounds;
            unheard_ns_ = 0;
            return false;
        }
        const bool was_heard = unheard_ns_ <= kLongestSilence_ns;
        unheard_ns_ += tick_ns;
        return was_heard && unheard_ns_ > kLongestSilence_ns;
    }

private:
    std::uint64_t rounds_seen_ = 0;
    std::int64_t unheard_ns_ = 0;  ///< so long no round was seen
};

}  // namespace psicarve::cycle
