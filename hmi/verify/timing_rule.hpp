// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "hmi/verify/offence_log.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// Rule 2: the times that the motor drivers need to see each pulse.
///
///     dir   ====X=====================X====
///     step  ________/--------\____________/----
///           |setup  | high   |   low       |
///                   |<-- hold -->|  (dir may change only after it)
class TimingRule {
public:
    TimingRule(const PortProfile& port, OffenceLog& log) : port_(port), log_(log) {}

    void rising(Axis axis, std::int64_t time_ns, const CarvePlace& place);
    void falling(Axis axis, std::int64_t time_ns, const CarvePlace& place);
    void direction_changed(Axis axis, std::int64_t time_ns, const CarvePlace& place);

private:
    static constexpr std::int64_t kLongAgo = std::numeric_limits<std::int64_t>::min() / 2;
    struct Wires {
        std::int64_t rose_ns = kLongAgo;
        std::int64_t fell_ns = kLongAgo;
        std::int64_t turned_ns = kLongAgo;
    };
    struct Fault {
        const char* name;
        const char* text;
    };
    void check(Axis axis, std::int64_t time_ns, std::int64_t since_ns, std::int64_t least_ns,
               const Fault& fault, const CarvePlace& place);

    PortProfile port_;
    OffenceLog& log_;
    std::array<Wires, kAxisCount> wires_;
};

}  // namespace psicarve::verify
