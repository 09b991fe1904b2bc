// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve {

/// What a head's radii are when the machine counts them.
struct HeadScale {
    double pulses_per_mm = 1.0;
    double tip_mm = 0.0;  ///< the real tip stands so much further out than counted

    double real_mm(std::int64_t counted) const noexcept {
        return static_cast<double>(counted) / pulses_per_mm + tip_mm;
    }
};

/// What a machine makes of "outside": see heads_outside.
struct OutsideRule {
    std::array<HeadScale, 2> heads;
    double clearance_mm = 0.0;
    double path_tolerance_mm = 0.0;
    double machine_blank_mm = 0.0;  ///< how far the blank of its own profile reaches out; 0: not known
};
OutsideRule outside_rule(const Profile& machine);

/// How far out material is taken to stand before a job is carved [mm], all round, by ways into and out of it:
/// the most of the blank (`blank_mm`, 0: not known), of what each pass says, and of all tips of the table.
double assumed_blank_mm(const JobView& job, const std::array<HeadScale, 2>& heads, double blank_mm) noexcept;

/// How far out it stands at most: the most of what each pass says, of the blanks in the job's own profile and
/// the machine's, and of the finishing pass' tips, for a blank holds what is made of it. 0: not known, where
/// the job has one pass alone or any pass does not say it, whatever profiles do.
double known_blank_mm(const JobView& job, const OutsideRule& rule);

/// From which radius on, as counted, a head is outside: wherever the table turns, whatever its tool is and
/// whichever layers were carved before, it touches nothing.
///
///     tip >= known blank + clearance + path tolerance + a pulse
///
/// For a tool lies nowhere nearer to the axis than its tip, and the path between two points comes no nearer
/// than the nearer one of them by more than the tolerance and a pulse.
struct HeadsOutside {
    static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
    std::array<std::int64_t, 2> from_pulses{kNever, kNever};

    /// Head 0 is R1. On the whole way between two neighbouring points of a table. RT: yes.
    bool holds(std::size_t head, std::int64_t begin_pulses, std::int64_t end_pulses) const noexcept {
        return std::min(begin_pulses, end_pulses) >= from_pulses[head];
    }
};
/// Of a machine around whose table material stands no further out than that; 0: not known, and nowhere is
/// outside.
HeadsOutside heads_outside(double standing_mm, const OutsideRule& rule) noexcept;
/// Nowhere, too, where a whole pass of the job would be outside: then it lies.
HeadsOutside heads_outside(const JobView& job, const OutsideRule& rule);

}  // namespace psicarve
