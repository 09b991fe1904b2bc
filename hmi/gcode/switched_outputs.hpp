// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <iterator>

#include "hmi/gcode/canon.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::gcode {

/// The outputs that a record switches, be they wired or not; none: it switches none that a machine can have.
constexpr SwitchedOutputs outputs_of(const CanonRecord& record) noexcept {
    constexpr SwitchedOutputs kMist = switched_bit(Signal::mist);
    constexpr SwitchedOutputs kFlood = switched_bit(Signal::flood);
    constexpr Signal kDigital[]{Signal::output_0, Signal::output_1, Signal::output_2, Signal::output_3};
    if (record.kind == CanonKind::coolant)
        return record.code == 7 ? kMist : record.code == 8 ? kFlood : kMist | kFlood;
    if (record.kind != CanonKind::output) return 0;
    for (std::size_t number = 0; number < std::size(kDigital); ++number)
        if (record.value == static_cast<double>(number)) return switched_bit(kDigital[number]);
    return 0;
}

/// Of a record of coolant or an output: it switches them on.
constexpr bool switches_on(const CanonRecord& record) noexcept {
    if (record.kind == CanonKind::coolant) return record.code != 9;
    return record.code == 62 || record.code == 64;
}

/// Which are on behind a record, where these were before it. Only those that are wired ever are.
constexpr SwitchedOutputs outputs_behind(const CanonRecord& record, SwitchedOutputs before,
                                         SwitchedOutputs wired) noexcept {
    const unsigned switched = outputs_of(record) & wired;
    return static_cast<SwitchedOutputs>(switches_on(record) ? before | switched : before & ~switched);
}

}  // namespace psicarve::gcode
