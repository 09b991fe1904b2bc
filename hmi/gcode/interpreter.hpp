// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hmi/gcode/active_modes.hpp"
#include "hmi/gcode/arc.hpp"
#include "hmi/gcode/block.hpp"
#include "hmi/gcode/block_meaning.hpp"
#include "hmi/gcode/canon.hpp"
#include "hmi/gcode/drawing_machine.hpp"
#include "hmi/gcode/interpreter_parts.hpp"
#include "hmi/gcode/modal_state.hpp"
#include "hmi/gcode/polar_way.hpp"
#include "hmi/gcode/problem.hpp"
#include "hmi/gcode/program_state.hpp"
#include "hmi/gcode/work_offsets.hpp"

namespace psicarve::gcode {

struct InterpreterOptions {
    Dialect dialect = Dialect::ngc;
    bool skips_deleted = false;    ///< blocks that begin with / are left out
    bool ends_with_input = false;  ///< of a stream: its end is the program's, too, unless a % began it
    Position reference{};          ///< where G28 and G30 go until G28.1 or G30.1 sets it, machine coordinates
    KeptOffsets offsets{};         ///< that it begins with
    Position start{};              ///< where the machine stands, machine coordinates
    bool is_start_known = true;    ///< it stands there; false: anywhere
    DrawingMachine drawing{};
    /// Loops and calls may have so many blocks executed in all, each piece of a drawn way being one, and so
    /// many in a row that make neither a move, a dwell nor a stop.
    std::uint64_t most_repeated_blocks = 100'000'000;
    std::uint64_t most_idle_blocks = 1'000'000;
};

/// Executes blocks in the order of RS274/NGC, one after the other, and gives their meaning to a sink. A wrong
/// block is reported once; faults that follow from it are not.
class Interpreter : public ProgramState {
public:
    /// Sink and list outlive the interpreter.
    Interpreter(const InterpreterOptions& options, CanonSink& sink, ProblemList& problems);

    /// `has_doubt`: values in it are perhaps not those that the program means; no place is known by them.
    void run(const Block& block, bool has_doubt);
    /// A program may ask for the line that is being read.
    void begin_line(std::uint64_t line) noexcept { course_.line = line; }
    /// In place of run() for a block that could not be read.
    void pass_unreadable(std::string_view line) noexcept;
    /// What ends a program and is no block: its second %, or a stream's end.
    void end_without_block(std::uint64_t line);
    /// The lines that follow are not part of the program.
    bool has_ended() const noexcept { return course_.has_ended; }
    /// A line that could not be read may have been the end.
    bool is_end_doubtful() const noexcept { return doubts_.end; }
    /// Ways that drawn ones have become, from the program's begin.
    std::uint64_t drawn_chord_count() const noexcept { return course_.drawn_chords; }
    std::uint64_t motion_count() const noexcept { return course_.motions; }
    /// Moves that lead somewhere, dwells and stops.
    std::uint64_t action_count() const noexcept { return course_.actions; }
    /// Of the last block.
    const WantedJump& wanted_jump() const noexcept { return outcome_.jump; }

    StateAnswer numbered(std::uint32_t number) const override;
    StateAnswer named(std::string_view name) const override;

private:
    using Fault = std::optional<Problem>;
    /// A move's feed, and the length that it counts along: mm, or degrees.
    struct FeedAlong {
        double per_min = 0.0;
        double length = 0.0;
    };

    void pass_wrong() noexcept;
    void doubt_modes(char tens, char ones) noexcept;
    void doubt_drawing() noexcept;
    void pass_doubtful_move() noexcept;
    Fault judge();
    Fault judge_motion();
    Fault judge_claims();
    bool has_centre_for_arc() const noexcept;
    Fault judge_drawing();
    Fault judge_drawing_mode();
    Fault execute();
    bool may_be_long() const noexcept;
    Fault rehearse() const;

    void set_units();
    Fault set_feed();
    Fault set_outputs();
    void set_tool();
    void set_spindle();
    Fault set_switches();
    Fault dwell();
    void set_plane() noexcept;
    void set_distances() noexcept;
    Fault set_path();
    Fault set_length();
    void set_system();
    Fault do_once();
    Fault note_offsets();
    Fault set_coordinates();
    void set_shift();
    void note_unknown(AxisMask& zeros, AxisMask axes, AxisMask unplaced) const noexcept;
    void go_to_reference(std::size_t which);
    Fault set_drawing();
    Fault begin_drawing(DrawnMode mode);
    Fault begin_polar();
    void end_drawing() noexcept;
    Fault stop();
    Fault want_jump(int code);

    StateAnswer program_place(std::size_t axis) const noexcept;
    StateAnswer machine_place(std::size_t axis) const noexcept;
    StateAnswer mode(std::string_view name) const noexcept;

    Fault move();
    Fault move_straight(bool is_rapid);
    Fault move_on_arc(bool is_clockwise);
    Fault find_centre(const PlanePoint& start, const PlanePoint& end, bool is_clockwise, PlanePoint& centre);
    Fault read_centre_words(const PlanePoint& start, PlanePoint& centre) const;
    Fault read_turns(int& turns) const;
    /// In the modes of G7.1 and G12.1.
    Fault draw();
    Fault draw_in_polar();
    Fault draw_on_cylinder();
    const Plane* plane_by_words() const noexcept;
    Fault arc_in_plane(const PlanePoint& from, const PlanePoint& to, PlanePoint& centre, int& turns);
    Fault judge_core(const PolarWay& way) const;
    void locate_in_polar(const PlanePoint& to, Position& end) noexcept;
    Fault carry_out_polar(const PolarWay& way, const Position& end, AxisMask before);
    Fault carry_out_on_cylinder(const CanonRecord& arc, const Position& end, double length_mm);
    void emit_drawn(const Position& program, double share, const FeedAlong& along, bool is_first,
                    bool is_last);
    bool is_drawing(DrawnMode mode) const noexcept { return drawing_.mode == mode; }
    double chord_mm() const noexcept;
    double moved_mm(const Position& to, AxisMask letters) const noexcept;
    Fault drill();
    Fault read_cycle_words();
    void drill_hole(Position& at, double clear_mm, double depth_mm, double retract_mm);

    Fault check_feed();
    FeedAlong feed_of_line(const Position& from, const Position& to) const noexcept;
    double feed_of_length(double length) const noexcept;
    Position target() const noexcept;
    double axis_mm(std::size_t axis) const noexcept;
    void note_places(AxisMask axes, bool is_machine) noexcept;
    AxisMask unknown_zeros() const noexcept;
    AxisMask both_if_turned(AxisMask axes) const noexcept;

    bool may_change_modes() const noexcept;
    ActiveModes active_modes() const noexcept;
    void tell_modes();
    void give(const CanonRecord& given);
    CanonRecord record(CanonKind kind) const;
    void emit(CanonKind kind, int code, double value);
    void emit_move(CanonRecord& record, const Position& program, const FeedAlong& along);
    void rapid_to(const Position& program);
    void feed_to(const Position& program);
    void refresh_program() noexcept;
    Problem fault(std::uint32_t column, ProblemCode code, Phrase what) const;
    bool is_cycle(int motion) const noexcept { return motion >= 810; }

    InterpreterOptions options_;
    CanonSink* sink_;
    ProblemList& problems_;
    BlockMeaning words_;
    ModalState modes_;
    Drawing drawing_;
    CycleWords cycle_;
    WorkOffsets offsets_;
    std::array<ReferencePoint, 2> references_;
    MachinePlace place_;
    UnknownZeros unknown_;
    Doubts doubts_;
    BlockOutcome outcome_;
    ProgramCourse course_;
    ModeReport mode_report_;
};

}  // namespace psicarve::gcode
