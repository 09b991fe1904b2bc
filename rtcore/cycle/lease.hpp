// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shared/machine/jog_lease_word.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::cycle {

/// Whether the client that began a jog still wants it. RT: yes.
class Lease {
public:
    /// `word` as it stands now. `ticks` 0: the caller watches the time (on the virtual clock).
    void begin(std::uint32_t token, std::int64_t ticks, std::uint64_t word, std::uint64_t now_tick) noexcept {
        token_ = token;
        ticks_ = static_cast<std::uint64_t>(ticks);
        seen_ = word;
        until_tick_ = now_tick + ticks_;
        is_held_ = token != 0;
    }
    void forget() noexcept { is_held_ = false; }
    bool is_held() const noexcept { return is_held_; }
    bool is_of(std::uint32_t token) const noexcept { return is_held_ && token == token_; }

    /// At each tick while it is held: none as long as the jog may go on.
    MoveEnd end_at(std::uint64_t word, std::uint64_t now_tick) noexcept {
        const bool is_ours = jog_lease_token(word) == token_;
        if (is_ours && jog_lease_beat(word) == 0) return MoveEnd::released;
        if (is_ours && word != seen_) {
            seen_ = word;
            until_tick_ = now_tick + ticks_;
        }
        return ticks_ > 0 && now_tick >= until_tick_ ? MoveEnd::lease_gone : MoveEnd::none;
    }

private:
    std::uint64_t seen_ = 0;
    std::uint64_t ticks_ = 0;
    std::uint64_t until_tick_ = 0;
    std::uint32_t token_ = 0;
    bool is_held_ = false;
};

}  // namespace psicarve::cycle
