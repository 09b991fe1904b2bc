// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/cycle/lease.hpp"

namespace psicarve::cycle {

/// A move, a jog or the trial of a pin by hand: under a lease or (token 0) without one; and how the last of
/// them ended. RT: yes.
class LeasedMove {
public:
    /// `word`: the segment's jog_lease as it stands now.
    void begin(const Request& request, std::uint64_t word, std::uint64_t tick) noexcept {
        lease_.begin(request.lease_token, request.lease_ticks, word, tick);
        end_ = MoveEnd::none;
    }
    /// none: something else ended it, which tells so itself.
    void end(MoveEnd end) noexcept {
        lease_.forget();
        end_ = end;
    }
    /// It slows down for another reason than its lease.
    void forget_lease() noexcept { lease_.forget(); }

    bool has_lease() const noexcept { return lease_.is_held(); }
    bool is_of(std::uint32_t token) const noexcept { return lease_.is_of(token); }
    /// Every tick while has_lease(): why it must end, or none.
    MoveEnd due_end(std::uint64_t word, std::uint64_t tick) noexcept { return lease_.end_at(word, tick); }

    MoveEnd ended() const noexcept { return end_; }

private:
    Lease lease_;
    MoveEnd end_ = MoveEnd::none;
};

}  // namespace psicarve::cycle
