// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/canon.hpp"
#include "hmi/gcode/stepped_way.hpp"
#include "hmi/verify/program/canon_stream.hpp"
#include "hmi/verify/program/programmed_way.hpp"

namespace psicarve::verify {

/// A program to be judged by, and how it was read when it was run.
struct JudgedProgram {
    CanonStream::Opener open;
    gcode::InterpreterOptions language;  ///< but for where the machine stands
    double override_ratio = 1.0;         ///< the fastest that its feeds were run
};

/// The least that a way may take; all 0: as fast as the machine can.
struct WayTime {
    double programmed_s = 0.0;  ///< its length by its feed
    double stepped_s = 0.0;     ///< as long a part of that as its whole pulses are one of its length
    double before_s = 0.0;      ///< programmed for the ways before it that have no pulse
};

/// The spindle first, then the outputs that programs switch.
inline constexpr std::size_t kSwitchCount = 1 + kSwitchedOutputCount;
constexpr std::size_t index_of_switch(Signal wire) noexcept {
    return wire == Signal::spindle ? 0 : 1 + index_of(wire) - kFirstSwitchedOutput;
}

/// How a program has the spindle, coolant and outputs on a way.
struct SwitchDemand {
    SignalWord judged = 0;                            ///< those of which it says something
    SignalWord on = 0;                                ///< of these
    SignalWord turned_behind = 0;                     ///< at the rest at its end
    std::array<std::uint64_t, kSwitchCount> lines{};  ///< that switched each last
};

/// A way, and what a program asks of it.
struct WayDemand {
    ProgrammedWay way;
    std::uint64_t line = 0;
    double tolerance_mm = 0.0;  ///< how far off the way the path may be, besides pulses
    double slack_pulses = 1.5;  ///< rounding of the canonical ends, of the path, of its cuts: a half each
    bool is_exact = false;      ///< its end is reached to the pulse, at rest
    WayTime time{};
    bool asks_for_rest = false;  ///< at its end, besides coming to it
    double dwell_s = 0.0;        ///< the rest at its end, as far as it is known
    bool is_stepped = false;     ///< by point-by-point comparison, from rest to rest
    bool goes_on = false;        ///< a piece of a drawn way, and not its first
    SwitchDemand switches{};
};

/// Makes canonical motion into ways of the machine's axes, from where it stands.
class WayReader {
public:
    /// The scale outlives the reader and its ways.
    WayReader(const JudgedProgram& program, const Profile& profile, const WayScale& scale,
              const Positions& start);

    /// Nothing: the program has no more.
    std::optional<WayDemand> next();
    /// Reads the rest of the program: no more ways are wanted.
    void pass_rest();
    /// After pass_rest(), or when next() had nothing: why the program could not be read to its end.
    std::optional<Error> failure() const { return stream_.failure(); }

private:
    std::optional<WayDemand> way_of(const gcode::CanonRecord& record);
    std::optional<WayArc> arc_of(const gcode::CanonRecord& record) const;
    Place place_of(const Place& from, gcode::AxisMask placed, const gcode::Position& at) const noexcept;
    double stepped_share(const gcode::CanonRecord& record, const Place& from, const Place& to) const;
    double share_on_chords(const gcode::CanonRecord& record, const Place& from) const;
    void rest(const gcode::CanonRecord& record);
    void note_mode(const gcode::CanonRecord& record) noexcept;
    void note_switch(const gcode::CanonRecord& record);
    void turn(SignalWord wires, bool is_on, std::uint64_t line);

    CanonStream stream_;
    const WayScale& scale_;
    gcode::AxisLetters letters_;
    gcode::SteppedWays stepped_;
    bool turns_shortest_;
    SwitchedOutputs wired_outputs_;
    double own_tolerance_mm_;
    double tolerance_mm_;
    bool is_exact_ = false;
    SwitchDemand switches_;
    double psi_shift_deg_ = 0.0;
    Place at_;
    double without_pulse_s_ = 0.0;  ///< of the ways since the last one that had any
    std::optional<WayDemand> held_;
};

}  // namespace psicarve::verify
