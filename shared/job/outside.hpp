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

/// A head's scale: how the machine counts its radii.
struct HeadScale {
    double pulses_per_mm = 1.0;
    double tip_mm = 0.0;  ///< the real tip stands further out than counted by this

    double real_mm(std::int64_t counted) const noexcept {
        return static_cast<double>(counted) / pulses_per_mm + tip_mm;
    }
};

/// What a machine needs to know where "outside" is: see heads_outside.
struct OutsideRule {
    std::array<HeadScale, 2> heads;
    double clearance_mm = 0.0;
    double path_tolerance_mm = 0.0;
    double machine_blank_mm = 0.0;  ///< how far the blank of the machine's profile reaches out; 0: not known
};
OutsideRule outside_rule(const Profile& machine);

/// The radius up to which ways into and out of a job assume material before it is carved [mm], all round: the
/// greatest of the blank (`blank_mm`, 0: not known), of what each pass says, and of all tips of the table.
double assumed_blank_mm(const JobView& job, const std::array<HeadScale, 2>& heads, double blank_mm) noexcept;

/// The radius that material cannot exceed: the greatest of what each pass says, of the blanks in the job's
/// own profile and the machine's, and of the finishing pass' tips, since a blank holds the piece that is made
/// of it. 0: not known, whatever profiles say, where the job has one pass alone or any pass does not say it.
double known_blank_mm(const JobView& job, const OutsideRule& rule);

/// From which radius on, as counted, a head is outside: there it touches nothing, wherever the table turns,
/// whatever its tool is and whichever layers were carved before.
///
///     tip >= known blank + clearance + path tolerance + a pulse
///
/// Proof: a tool lies nowhere nearer to the axis than its tip, and the path between two points comes no
/// nearer than the nearer one of them by more than the tolerance and a pulse.
struct HeadsOutside {
    static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
    std::array<std::int64_t, 2> from_pulses{kNever, kNever};

    /// Whether a head (0 is R1) is outside on the whole way between two neighbouring points of a table.
    /// RT: yes.
    bool holds(std::size_t head, std::int64_t begin_pulses, std::int64_t end_pulses) const noexcept {
        return std::min(begin_pulses, end_pulses) >= from_pulses[head];
    }
};
/// For a machine around whose table material stands no further out than `standing_mm`; 0: not known, and
/// nowhere is outside.
HeadsOutside heads_outside(double standing_mm, const OutsideRule& rule) noexcept;
/// Nowhere is outside, too, where a whole pass of the job would be: then the job's data is wrong.
HeadsOutside heads_outside(const JobView& job, const OutsideRule& rule);

}  // namespace psicarve
