// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve {

enum class Schedule : std::uint8_t { single, two_timer };
enum class HomeSensor : std::uint8_t { none, min, max, index };
enum class Planner : std::uint8_t { lookahead, angle };
enum class Joining : std::uint8_t { continuous, zigzag, spiral };
/// When a step pulse ends: at a later tick, or after a wait inside its own.
enum class PulseForm : std::uint8_t { over_ticks, within_tick };
/// Letters of a program for the axes r1, r2, y, psi.
enum class AxisNames : std::uint8_t {
    machine,  ///< X, Z, Y, C
    turning,  ///< X, U, Z, C, as ISO 841 has them
};
/// What moves r2.
enum class SecondHead : std::uint8_t { own, follow };
enum class ToolShape : std::uint8_t { point, ball, flat, vee };
std::string_view name_of(ToolShape shape) noexcept;  ///< as in a profile: "ball"
std::optional<ToolShape> tool_shape_from_name(std::string_view name) noexcept;
std::string_view name_of(Joining joining) noexcept;  ///< as in a profile: "continuous"
std::optional<Joining> joining_from_name(std::string_view name) noexcept;

struct TickProfile {
    double period_us = 50.0;
    Schedule schedule = Schedule::single;
    double interpolation_us = 100.0;  ///< two-timer only
    double io_us = 500.0;             ///< two-timer only
    std::int64_t missed_alarm_per_s = 50;

    friend bool operator==(const TickProfile&, const TickProfile&) = default;
};

/// R1, R2 or Y.
struct LinearAxisProfile {
    double pulses_per_mm = 400.0;
    std::array<double, 2> travel_mm{0.0, 60.0};
    double speed_mm_s = 10.0;
    double accel_mm_s2 = 100.0;
    double start_stop_mm_s = 1.0;
    bool positive_is_high = true;
    HomeSensor home = HomeSensor::max;
    double home_position_mm = 60.0;
    double home_speed_mm_s = 5.0;
    double overtravel_mm = 1.0;
    double backlash_mm = 0.0;
    double tip_offset_mm = 0.0;
    double tool_wear_mm = 0.0;

    /// How much further out a head's real tip stands than counted: as touched off, and by wear since.
    double tip_mm() const noexcept { return tip_offset_mm + tool_wear_mm; }

    friend bool operator==(const LinearAxisProfile&, const LinearAxisProfile&) = default;
};

/// Psi.
struct RotaryAxisProfile {
    std::int64_t pulses_per_rev = 6400;
    double speed_deg_s = 225.0;
    double accel_deg_s2 = 2250.0;
    double start_stop_deg_s = 22.5;
    bool positive_is_high = true;
    HomeSensor home = HomeSensor::index;
    double home_position_deg = 0.0;
    double home_speed_deg_s = 45.0;
    std::int64_t index_tolerance_pulses = 2;
    double backlash_deg = 0.0;

    friend bool operator==(const RotaryAxisProfile&, const RotaryAxisProfile&) = default;
};

struct JobProfile {
    double feed_mm_s = 20.0;
    double plunge_mm_s = 5.0;
    double clearance_mm = 2.0;
    double retract_mm = 5.0;
    bool lifts_on_hold = false;
    double spindle_spinup_s = 1.0;
    double base_height_mm = 0.0;
    Planner planner = Planner::lookahead;
    double corner_deg = 5.0;
    double path_tolerance_mm = 0.01;
    Joining joining = Joining::continuous;

    friend bool operator==(const JobProfile&, const JobProfile&) = default;
};

struct ToolProfile {
    ToolShape shape = ToolShape::point;
    double diameter_mm = 3.0;
    double angle_deg = 60.0;  ///< of a vee, between its flanks
    double flute_mm = 0.0;    ///< 0: longer than any cut

    friend bool operator==(const ToolProfile&, const ToolProfile&) = default;
};

/// The blank on the table. 0: not known.
struct BlankProfile {
    double radius_mm = 0.0;
    double height_mm = 0.0;  ///< above the table
    /// Position of its axis from the table's, towards direction 0 and 90 degrees.
    double offset_x_mm = 0.0;
    double offset_z_mm = 0.0;
    double depth_limit_mm = 0.0;  ///< no tip goes deeper below its surface; 0: no limit

    /// How far it reaches out from the table's axis, all round; 0: not known.
    double reach_mm() const noexcept;
    /// How far its surface is from the table's axis in a direction; 0: the blank is not there, or not known.
    double surface_mm(double direction_rad) const noexcept;

    friend bool operator==(const BlankProfile&, const BlankProfile&) = default;
};

/// How the blank that a job was made for differs from the one in a machine's profile.
struct BlankDifference {
    enum class In : std::uint8_t { radius, height, place };
    In in = In::radius;
    double job_mm = 0.0;
    double machine_mm = 0.0;  ///< place: distance between the two axes, and `job_mm` is 0
    /// The machine's blank stands where the job's does not, so that heads would go through it where they
    /// should be outside.
    bool is_in_the_way = false;
};
/// Nothing: the blanks are the same, or one of them is not known.
std::optional<BlankDifference> blank_difference(const BlankProfile& job, const BlankProfile& machine);
/// "the job was made for a blank of 9.00 mm radius, ..."
Message blank_difference_message(const BlankDifference& difference) noexcept;
std::string blank_difference_text(const BlankDifference& difference);

/// Passes before the finishing pass.
struct RoughingProfile {
    double stepdown_mm = 0.0;  ///< how much further in each goes; 0: none
    double allowance_mm = 0.3;
    double stepover_mm = 0.0;  ///< between layers; 0: as the tool allows

    friend bool operator==(const RoughingProfile&, const RoughingProfile&) = default;
};

/// How programs in G-code are meant.
struct GcodeProfile {
    AxisNames letters = AxisNames::machine;
    SecondHead second_head = SecondHead::own;
    bool turns_shortest = false;      ///< a G0 of C
    bool feeds_over_surface = false;  ///< F is the tool's speed over the piece, not that of X Y Z
    bool is_stepwise = false;         ///< lines and arcs of a head and Y by point-by-point comparison

    friend bool operator==(const GcodeProfile&, const GcodeProfile&) = default;
};

struct PortProfile {
    std::int64_t dir_setup_ns = 5000;
    std::int64_t dir_hold_ns = 5000;
    std::int64_t step_high_ns = 10000;
    std::int64_t step_low_ns = 10000;
    PulseForm pulses = PulseForm::over_ticks;
    double input_filter_us = 100.0;
    /// Pin of every signal as in [port.pins]: 1..17, negative: active low, 0: not wired. By Signal.
    std::array<int, kSignalCount> pins{5, 2, 3, 14, 9, 17, 8, 4, 6, 7, 6, 1, 16, 13, 11, 12, 10, 0};
    int charge_pump_pin = 0;  ///< key port.pins.charge_pump, the same way

    friend bool operator==(const PortProfile&, const PortProfile&) = default;
};

/// The machine profile: values of the specified keys, in the units users write. Defaults are the built-in
/// profile `default`.
struct Profile {
    std::string name = "default";
    double core_radius_mm = 1.5;
    double head_clearance_mm = 2.0;
    TickProfile tick;
    LinearAxisProfile r1;
    LinearAxisProfile r2;
    RotaryAxisProfile psi;
    LinearAxisProfile y{.travel_mm = {0.0, 150.0}, .home = HomeSensor::min, .home_position_mm = 0.0};
    double head_r2_angle_error_deg = 0.0;
    double head_r2_height_error_mm = 0.0;
    JobProfile job;
    ToolProfile tool;
    BlankProfile blank;
    RoughingProfile roughing;
    GcodeProfile gcode;
    PortProfile port;

    friend bool operator==(const Profile&, const Profile&) = default;
};

inline constexpr std::size_t kProfileTextBytes = 48 * 1024;  ///< a longer profile text is refused

/// Reads a profile; keys that are not given have the built-in profile's values. Unknown keys, wrong types and
/// impossible values (also of several keys together, and of the pin map) are refused: "FILE:LINE: key: what
/// is wrong; remedy". `file_name` only serves the message.
Result<Profile> parse_profile(std::string_view toml, std::string_view file_name);
/// The same for a file; the message names it as `path`.
Result<Profile> load_profile(const std::string& path);

/// Every key with its value, as TOML that parse_profile reads back to an equal profile, with comments (unit
/// and meaning) for people who edit the file. Deterministic.
std::string profile_to_toml(const Profile& profile);
/// XXH3 of that text: equal for equal profiles.
std::uint64_t profile_hash(const Profile& profile);

/// Everything that is wrong with a profile, in the order of its lines: all faults of single keys, or, where
/// there are none, the first contradiction between keys.
struct ProfileProblem {
    std::int64_t line;  ///< 0: the file gives none of the keys
    std::string key;    ///< empty: the text is no TOML
    std::string text;   ///< "what is wrong; remedy"
};
std::vector<ProfileProblem> profile_problems(std::string_view toml);

/// What could be read of a text. Keys with a wrong value have the built-in one in `profile`.
struct ProfileReading {
    Profile profile;
    std::vector<ProfileProblem> problems;  ///< the result of profile_problems()
    bool is_each_value_read;  ///< false: `problems` names the keys that are not; true: it names a
                              ///< contradiction between keys
};
ProfileReading read_profile(std::string_view toml);

enum class ProfileValue : std::uint8_t { number, integer, range, text, word };

/// One key, as `profile show`, the docs and a profile editor need it.
struct ProfileKey {
    std::string path;         ///< "axis.r1.speed_mm_s"
    std::string unit;         ///< "mm/s", empty for none
    std::string bounds;       ///< "0.001 <= value <= 10000", "min, max or none"
    std::string built_in;     ///< default, as TOML
    std::string explanation;  ///< one sentence
    bool matters_to_motion;   ///< a job made for another value is refused by the core
    ProfileValue value;
    std::vector<std::string> words;  ///< the words that are allowed
};
const std::vector<ProfileKey>& profile_keys();
/// Least and greatest value of a key that is a number, in its unit. Requires a key of profile_keys().
struct ProfileBounds {
    double least;
    double greatest;
    bool hold(double value) const noexcept { return value >= least && value <= greatest; }
};
ProfileBounds profile_bounds(std::string_view path);
/// The values of profile_keys(), as TOML: 10.0, 400, "max", [0.0, 60.0].
std::vector<std::string> profile_values(const Profile& profile);

/// The dotted paths of keys that matter to motion and whose values differ. Empty: a job made for one profile
/// runs on the other.
std::vector<std::string> motion_differences(const Profile& a, const Profile& b);
/// For what a machine refuses a job: motion_differences, and the blank's radius where the machine's profile
/// has one and the job's none. A job that knows its own blank is carved from that.
std::vector<std::string> job_differences(const Profile& job, const Profile& machine);
/// Those of motion_differences that say where on the workpiece a table's pulses are. Empty: either profile
/// can judge a job's pulses by its limits and its timing.
std::vector<std::string> place_differences(const Profile& a, const Profile& b);

/// Refuses a blank that reaches further out than a head of the machine can: the head would stand in the blank
/// before the carving begins.
Result<void> check_heads_clear(const BlankProfile& blank, const Profile& machine);

/// One axis in pulses: what planner, cycle, simulator and verifier work with.
struct AxisMotion {
    double pulses_per_unit = 0.0;  ///< pulses per mm, or per degree for psi
    double speed_pps = 0.0;        ///< v_k
    double accel_pps2 = 0.0;       ///< a_k
    double start_stop_pps = 0.0;   ///< j_k
    double home_speed_pps = 0.0;
    std::int64_t travel_min_pulses =
        0;  ///< lowest position the axis may be asked for (psi: none, see has_travel)
    std::int64_t travel_max_pulses = 0;  ///< highest; past a limit sensor's edge is outside
    /// The last position at which the limit sensor is clear: its edge lies between this and the next pulse.
    /// For an index: the first position at which it is tripped, turning positive.
    std::int64_t home_position_pulses = 0;
    std::int64_t overtravel_pulses = 0;
    std::int64_t backlash_pulses = 0;
    HomeSensor home = HomeSensor::none;
    bool has_travel = true;
    bool positive_is_high = true;
};
AxisMotion axis_motion(const Profile& profile, Axis axis);

/// The outputs that programs can switch: those with a pin.
SwitchedOutputs wired_outputs(const Profile& profile) noexcept;

/// The tick's period in whole nanoseconds.
std::int64_t tick_period_ns(const Profile& profile) noexcept;
/// Shortest time from one step pulse of an axis to the next that the ticks can make.
std::int64_t pulse_period_ns(const Profile& profile) noexcept;
/// Whole ticks, at least one, from an edge to the next that must come `time_ns` later, with room for the
/// write.
std::int64_t ticks_between_edges(std::int64_t time_ns, std::int64_t period_ns) noexcept;
/// How much of a tick a pulse within it takes, with room for the writes themselves.
std::int64_t pulse_within_tick_ns(const Profile& profile) noexcept;
/// Least counted position of a head: the core radius with the tip offset taken off, rounded as tables are.
std::int64_t core_radius_pulses(const Profile& profile, Axis head) noexcept;

}  // namespace psicarve
