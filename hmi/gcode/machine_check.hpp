// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/canon.hpp"
#include "hmi/gcode/problem.hpp"
#include "hmi/gcode/stepped_way.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::gcode {

/// Judges motion by a machine whose axes have the letters of the profile, as far as that is possible without
/// planning: letters, arcs, travel of ends and arcs, core radius, the tips' distance at ends, outputs, times
/// that no record can have. Does not judge axes whose place the program has not set yet.
class MachineCheck : public CanonSink {
public:
    /// The list outlives the check.
    MachineCheck(const Profile& profile, ProblemList& problems);

    void take(const CanonRecord& record) override;
    /// Where G28 goes: the axes' home positions.
    static Position reference_of(const Profile& profile) noexcept;

private:
    struct LinearAxis {
        Axis axis;
        AxisMotion motion;
        std::int64_t core_pulses;  ///< of a head
        std::string name;
    };

    void refuse(const CanonRecord& record, ProblemCode code, Phrase what);
    void judge_switches(const CanonRecord& record);
    void judge_coolant(const CanonRecord& record);
    void judge_override(const CanonRecord& record);
    bool lasts_no_day(const CanonRecord& record, double seconds);
    bool is_way_in_time(const CanonRecord& record);
    void judge_tolerance(const CanonRecord& record);
    bool has_only_our_letters(const CanonRecord& record);
    void judge_motion(const CanonRecord& record);
    void judge_arc(const CanonRecord& record);
    void judge_extents(const CanonRecord& record, const LinearAxis& axis, double least_mm, double most_mm);
    void judge_end(const CanonRecord& record, const LinearAxis& axis);
    void judge_tips(const CanonRecord& record);

    ProblemList& problems_;
    bool is_way_refused_ = false;  ///< the drawn one that is not at its end
    AxisLetters letters_;
    SteppedWays stepped_;
    SwitchedOutputs wired_outputs_;
    std::array<LinearAxis, 3> axes_;
    double tips_mm_;  ///< how much further out than counted both heads' tips stand, together
    double clearance_mm_;
};

}  // namespace psicarve::gcode
