// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/canon.hpp"
#include "hmi/gcode/record_outlet.hpp"
#include "hmi/gcode/stepped_way.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::gcode {

/// How a program is run.
struct RunOptions {
    std::uint64_t program = 0;       ///< the number that its records bear
    std::uint64_t from_line = 0;     ///< what lies before makes no motion, but counts; 0, 1: all is run
    bool stops_at_optional = false;  ///< the switch for M1 is on as it begins: each is planned as a rest
    bool has_optional_stops = true;  ///< the switch acts while it runs; false: as before layout 18
    bool is_dry = false;  ///< spindle and outputs off, heads outside the blank: only psi and y move
};

/// Makes canonical motion into the records that the core takes (docs/gcode.md). In constant memory, one
/// record behind. Requires a program that MachineCheck has nothing against, and whose start is known
/// (InterpreterOptions): what it cannot carry out ends it with an error. Its members: what the run and the
/// profile settle once, and the state of the motion so far, all of which each record needs.
class RecordMaker : public CanonSink {
public:
    /// The sink outlives the maker.
    RecordMaker(const Profile& profile, const RunOptions& options, RecordSink& sink) noexcept;

    void take(const CanonRecord& record) override;
    void begin_line(const ReachedLine& line) override;
    void end_block() override { outlet_.end_block(); }
    bool wants_more() const noexcept override { return !outlet_.has_failed(); }
    /// How many records there are until now, the one that is held back among them.
    std::uint64_t record_count() const noexcept { return outlet_.record_count(); }
    /// The program has been read; one without an end gets it here. The first failure, if any.
    Result<void> finish();

private:
    void begin(const CanonRecord& record);
    void approach(std::uint64_t line);
    void shorten_turn(const CanonRecord& record) noexcept;
    double turn_deg(const CanonRecord& record) const noexcept;
    bool stays_turned(const CanonRecord& record) const noexcept;
    void carry_out(const CanonRecord& record);
    void note(const CanonRecord& record) noexcept;

    bool can_move(const CanonRecord& record);
    void move(const CanonRecord& record);
    void move_on_chords(const CanonRecord& record, double seconds);
    bool move_by_steps(const CanonRecord& record, double seconds);
    void put_arcs(const CanonRecord& record, const SteppedArc& arc, double seconds);
    void put_way(std::uint64_t line, const Position& end, AxisMask letters, double seconds,
                 double tolerance_mm, bool is_rapid);
    void put_heads_out(std::uint64_t line);
    void stop(const CanonRecord& record);
    void put_optional_stop(std::uint64_t line);
    void switch_outputs(const CanonRecord& record);
    void put_outputs(std::uint64_t line, SwitchedOutputs outputs, bool is_on);
    void put(MotionKind kind, std::uint64_t line, std::uint8_t code, double seconds);
    void refuse(const CanonRecord& record, const std::string& what);

    /// How near the ends of the present mode must be passed.
    double end_tolerance_mm() const noexcept { return is_exact_ ? 0.0 : corner_tolerance_mm(); }
    /// Of an end between two ways, be they lines or chords: one for all, as the path rests where it changes.
    double corner_tolerance_mm() const noexcept;
    AxisMask moving_letters() const noexcept;

    RunOptions options_;
    RecordOutlet outlet_;
    AxisLetters letters_;
    SteppedWays stepped_;
    bool turns_shortest_;
    std::array<double, kHeads> out_mm_;  ///< where heads are outside everything
    double own_tolerance_mm_;            ///< the profile's
    SwitchedOutputs wired_outputs_;
    // What the program has said so far.
    double tolerance_mm_;  ///< where ends are exact it is that of arcs, the profile's
    bool is_exact_ = false;
    bool is_spindle_on_ = false;
    SwitchedOutputs outputs_on_ = 0;
    double psi_shift_deg_ = 0.0;  ///< whole turns that psi is further than C says
    Position place_{};
    AxisMask placed_ = 0;
    bool has_moved_ = false;
    std::uint64_t line_ = 1;
    bool has_come_;  ///< to the line to begin with
    bool has_begun_ = false;
    bool has_ended_ = false;
};

}  // namespace psicarve::gcode
