// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/pulse_times.hpp"

#include <algorithm>
#include <cstddef>

namespace psicarve::port {
namespace {

constexpr std::size_t kFirstDirBit = index_of(Signal::r1_dir);

}  // namespace

std::int64_t PulseTimes::earliest_ns(SignalWord from, SignalWord to) const noexcept {
    const bool is_safe = (to & kOutputMask & ~kDirMask) == 0;
    std::int64_t result_ns = kLongAgo_ns;
    if (is_safe) return result_ns;
    const SignalWord changed = from ^ to;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const Edges& edges = edges_[k];
        if ((changed >> (kFirstDirBit + k) & 1U) != 0) {
            result_ns = std::max(result_ns, edges.rose_ns + hold_ns_);
        }
        if ((changed >> k & 1U) == 0) continue;
        const bool rises = (to >> k & 1U) != 0;
        result_ns = std::max(result_ns, rises ? std::max(edges.fell_ns + low_ns_, edges.turned_ns + setup_ns_)
                                              : edges.rose_ns + high_ns_);
    }
    return result_ns;
}

void PulseTimes::note(SignalWord from, SignalWord to, std::int64_t now_ns) noexcept {
    const SignalWord changed = from ^ to;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        Edges& edges = edges_[k];
        if ((changed >> (kFirstDirBit + k) & 1U) != 0) edges.turned_ns = now_ns;
        if ((changed >> k & 1U) == 0) continue;
        ((to >> k & 1U) != 0 ? edges.rose_ns : edges.fell_ns) = now_ns;
    }
}

}  // namespace psicarve::port
