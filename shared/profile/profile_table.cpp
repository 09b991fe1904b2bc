// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/profile/profile_table.hpp"

#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace psicarve::profile_detail {
namespace {

constexpr bool kMotion = true;
constexpr bool kNoMotion = false;  // a job made for another value runs all the same

template <typename T>
constexpr std::uint8_t number_of(T value) noexcept {
    return static_cast<std::uint8_t>(value);
}

constexpr Word kLevelWords[]{{"high", 1}, {"low", 0}};
constexpr Word kScheduleWords[]{{"single", number_of(Schedule::single)},
                                {"two-timer", number_of(Schedule::two_timer)}};
constexpr Word kPlannerWords[]{{"lookahead", number_of(Planner::lookahead)},
                               {"angle", number_of(Planner::angle)}};
constexpr Word kJoiningWords[]{{"continuous", number_of(Joining::continuous)},
                               {"zigzag", number_of(Joining::zigzag)},
                               {"spiral", number_of(Joining::spiral)}};
constexpr Word kToolShapeWords[]{{"point", number_of(ToolShape::point)},
                                 {"ball", number_of(ToolShape::ball)},
                                 {"flat", number_of(ToolShape::flat)},
                                 {"vee", number_of(ToolShape::vee)}};
constexpr Word kAxisNamesWords[]{{"machine", number_of(AxisNames::machine)},
                                 {"turning", number_of(AxisNames::turning)}};
constexpr Word kSecondHeadWords[]{{"own", number_of(SecondHead::own)},
                                  {"follow", number_of(SecondHead::follow)}};
constexpr Word kRapidPsiWords[]{{"shortest", 1}, {"written", 0}};
constexpr Word kFeedOverWords[]{{"axes", 0}, {"surface", 1}};
constexpr Word kInterpolationWords[]{{"path", 0}, {"stepwise", 1}};
constexpr Word kPulseFormWords[]{{"over-ticks", number_of(PulseForm::over_ticks)},
                                 {"within-tick", number_of(PulseForm::within_tick)}};
constexpr Word kOnHoldWords[]{{"lift", 1}, {"stay", 0}};
constexpr Word kLinearHomeWords[]{{"min", number_of(HomeSensor::min)},
                                  {"max", number_of(HomeSensor::max)},
                                  {"none", number_of(HomeSensor::none)}};
constexpr Word kRotaryHomeWords[]{{"index", number_of(HomeSensor::index)},
                                  {"none", number_of(HomeSensor::none)}};

/// Collects keys; `part` reaches from the profile to the struct that holds them.
template <typename Part>
class TableSection {
public:
    TableSection(std::vector<KeySpec>& keys, std::string table, std::function<Part&(Profile&)> part)
        : keys_(keys), table_(std::move(table)), part_(std::move(part)) {}

    template <typename Member>
    void number(Member Part::*member, const char* leaf, const char* unit, Bounds bounds, bool motion,
                const char* explanation) {
        add(member, leaf, unit, bounds, {}, motion, explanation);
    }
    template <typename Member>
    void word(Member Part::*member, const char* leaf, std::span<const Word> words, bool motion,
              const char* explanation) {
        add(member, leaf, "", {}, words, motion, explanation);
    }

private:
    template <typename Member>
    void add(Member Part::*member, const char* leaf, const char* unit, Bounds bounds,
             std::span<const Word> words, bool motion, const char* explanation) {
        auto field = [part = part_, member](Profile& profile) -> Field { return &(part(profile).*member); };
        keys_.push_back({table_.empty() ? leaf : table_ + "." + leaf, unit, bounds, words, explanation,
                         motion, std::move(field)});
    }

    std::vector<KeySpec>& keys_;
    std::string table_;
    std::function<Part&(Profile&)> part_;
};

void add_top(std::vector<KeySpec>& keys) {
    TableSection<Profile> top(keys, "", [](Profile& p) -> Profile& { return p; });
    top.number(&Profile::name, "name", "", {1, 64}, kNoMotion, "Name of the machine, for people.");
    top.number(&Profile::core_radius_mm, "core_radius_mm", "mm", {0, 1000}, kMotion,
               "Nothing is carved closer to the axis.");
    top.number(&Profile::head_clearance_mm, "head_clearance_mm", "mm", {0, 1000}, kMotion,
               "Least distance between the two tool tips.");
}

void add_tick(std::vector<KeySpec>& keys) {
    TableSection<TickProfile> tick(keys, "tick", [](Profile& p) -> TickProfile& { return p.tick; });
    tick.number(&TickProfile::period_us, "period_us", "us", {1, 10'000}, kMotion,
                "Period of the core's base tick; pins change only at ticks.");
    tick.word(&TickProfile::schedule, "schedule", kScheduleWords, kMotion,
              "One timer for everything, or the original's two.");
    tick.number(&TickProfile::interpolation_us, "interpolation_us", "us", {1, 100'000}, kMotion,
                "Schedule two-timer: period of the interpolation.");
    tick.number(&TickProfile::io_us, "io_us", "us", {1, 100'000}, kMotion,
                "Schedule two-timer: period of inputs and pulses, at most one pulse in each.");
    tick.number(&TickProfile::missed_alarm_per_s, "missed_alarm_per_s", "ticks/s", {0, 1'000'000}, kNoMotion,
                "Controlled stop above this many missed ticks a second; 0: never.");
}

void add_linear_axis(std::vector<KeySpec>& keys, const char* table,
                     std::function<LinearAxisProfile&(Profile&)> part) {
    using A = LinearAxisProfile;
    TableSection<A> axis(keys, table, std::move(part));
    axis.number(&A::pulses_per_mm, "pulses_per_mm", "pulses/mm", {0.1, 100'000}, kMotion,
                "Motor pulses for one millimetre.");
    axis.number(&A::travel_mm, "travel_mm", "mm", {-10'000, 10'000}, kMotion, "Lowest and highest position.");
    axis.number(&A::speed_mm_s, "speed_mm_s", "mm/s", {0.001, 10'000}, kMotion,
                "Top speed that the motor follows (v_k).");
    axis.number(&A::accel_mm_s2, "accel_mm_s2", "mm/s^2", {0.001, 1'000'000}, kMotion,
                "Acceleration that the motor follows (a_k).");
    axis.number(&A::start_stop_mm_s, "start_stop_mm_s", "mm/s", {0.0001, 10'000}, kMotion,
                "Pull-in speed: what the motor may jump to from rest (j_k).");
    axis.word(&A::positive_is_high, "positive", kLevelWords, kMotion,
              "Level of the direction pin that means positive.");
    axis.word(&A::home, "home", kLinearHomeWords, kMotion, "End at which the limit sensor stands.");
    axis.number(&A::home_position_mm, "home_position_mm", "mm", {-10'000, 10'000}, kMotion,
                "Position at the sensor's edge.");
    axis.number(&A::home_speed_mm_s, "home_speed_mm_s", "mm/s", {0.001, 10'000}, kNoMotion,
                "Speed of homing and of backing off.");
    axis.number(&A::overtravel_mm, "overtravel_mm", "mm", {0, 100}, kNoMotion,
                "How far past the sensor the mechanics allow.");
    axis.number(&A::backlash_mm, "backlash_mm", "mm", {0, 10}, kMotion,
                "Play that a reversal takes up before the axis moves.");
    axis.number(&A::tip_offset_mm, "tip_offset_mm", "mm", {-100, 100}, kMotion,
                "Touch-off: the real tip stands this much further out than counted.");
    axis.number(&A::tool_wear_mm, "tool_wear_mm", "mm", {0, 20}, kMotion,
                "The tool has become this much shorter since the touch-off; added to the tip offset.");
}

void add_rotary_axis(std::vector<KeySpec>& keys) {
    using A = RotaryAxisProfile;
    TableSection<A> psi(keys, "axis.psi", [](Profile& p) -> A& { return p.psi; });
    psi.number(&A::pulses_per_rev, "pulses_per_rev", "pulses", {2, 100'000'000}, kMotion,
               "Motor pulses for one turn of the table; even.");
    psi.number(&A::speed_deg_s, "speed_deg_s", "deg/s", {0.001, 100'000}, kMotion,
               "Top speed that the motor follows (v_k).");
    psi.number(&A::accel_deg_s2, "accel_deg_s2", "deg/s^2", {0.001, 10'000'000}, kMotion,
               "Acceleration that the motor follows (a_k).");
    psi.number(&A::start_stop_deg_s, "start_stop_deg_s", "deg/s", {0.0001, 100'000}, kMotion,
               "Pull-in speed: what the motor may jump to from rest (j_k).");
    psi.word(&A::positive_is_high, "positive", kLevelWords, kMotion,
             "Level of the direction pin that means positive.");
    psi.word(&A::home, "home", kRotaryHomeWords, kMotion, "Whether the table has an index sensor.");
    psi.number(&A::home_position_deg, "home_position_deg", "deg", {-360, 360}, kMotion,
               "Position at the index.");
    psi.number(&A::home_speed_deg_s, "home_speed_deg_s", "deg/s", {0.001, 100'000}, kNoMotion,
               "Speed of homing.");
    psi.number(&A::index_tolerance_pulses, "index_tolerance_pulses", "pulses", {0, 1'000'000}, kNoMotion,
               "Greatest difference at an index pass that is not the alarm steps lost.");
    psi.number(&A::backlash_deg, "backlash_deg", "deg", {0, 10}, kMotion,
               "Play that a reversal takes up before the table turns.");
}

void add_head_and_job(std::vector<KeySpec>& keys) {
    TableSection<Profile> head(keys, "head.r2", [](Profile& p) -> Profile& { return p; });
    head.number(&Profile::head_r2_angle_error_deg, "angle_error_deg", "deg", {-45, 45}, kMotion,
                "Direction of R2 minus 180 degrees, measured once.");
    head.number(&Profile::head_r2_height_error_mm, "height_error_mm", "mm", {-100, 100}, kMotion,
                "How much higher R2 stands than R1, measured once.");

    using J = JobProfile;
    TableSection<J> job(keys, "job", [](Profile& p) -> J& { return p.job; });
    job.number(&J::feed_mm_s, "feed_mm_s", "mm/s", {0.001, 10'000}, kNoMotion,
               "Tool over surface; a job carries its own.");
    job.number(&J::plunge_mm_s, "plunge_mm_s", "mm/s", {0.001, 10'000}, kMotion,
               "A head moving in to its first point.");
    job.number(&J::clearance_mm, "clearance_mm", "mm", {0, 1000}, kMotion,
               "Positioning keeps the heads this far outside the blank.");
    job.number(&J::retract_mm, "retract_mm", "mm", {0, 1000}, kMotion,
               "Heads move out this far after the last point, on stop, and on hold if on_hold says so.");
    job.word(&J::lifts_on_hold, "on_hold", kOnHoldWords, kNoMotion,
             "On hold the heads stay in the cut, or leave it by retract_mm and come back before it goes on.");
    job.number(&J::spindle_spinup_s, "spindle_spinup_s", "s", {0, 600}, kNoMotion,
               "Wait from spindle on to the first move inwards.");
    job.number(&J::base_height_mm, "base_height_mm", "mm", {-10'000, 10'000}, kNoMotion,
               "Lowest point of the model above the table; baked into a job's heights.");
    job.word(&J::planner, "planner", kPlannerWords, kMotion,
             "As fast as every motor can follow, or the original's acceleration segments.");
    job.number(&J::corner_deg, "corner_deg", "deg", {0.001, 180}, kMotion,
               "Planner angle: directions that differ by less belong to one segment.");
    job.number(&J::path_tolerance_mm, "path_tolerance_mm", "mm", {0.000001, 10}, kMotion,
               "Between two points the path may leave the straight line by this.");
    job.word(&J::joining, "joining", kJoiningWords, kNoMotion,
             "The table keeps turning, runs to and fro, or the heads rise as it turns, without links; a job "
             "carries "
             "its own.");
}

void add_tool_and_blank(std::vector<KeySpec>& keys) {
    using T = ToolProfile;
    TableSection<T> tool(keys, "tool", [](Profile& p) -> T& { return p.tool; });
    tool.word(&T::shape, "shape", kToolShapeWords, kNoMotion,
              "Cutting end of the tools; jobs keep all of it out of the model. A point has no size.");
    tool.number(&T::diameter_mm, "diameter_mm", "mm", {0.001, 1000}, kNoMotion,
                "Of the tool where it is widest.");
    tool.number(&T::angle_deg, "angle_deg", "deg", {1, 179}, kNoMotion, "Shape vee: between the flanks.");
    tool.number(&T::flute_mm, "flute_mm", "mm", {0, 1000}, kNoMotion,
                "How deep the tool can cut; 0: deeper than any cut.");

    using B = BlankProfile;
    TableSection<B> blank(keys, "blank", [](Profile& p) -> B& { return p.blank; });
    blank.number(&B::radius_mm, "radius_mm", "mm", {0, 10'000}, kNoMotion,
                 "Radius of the cylinder that is carved, which the heads keep out of; 0: the job's largest.");
    blank.number(&B::height_mm, "height_mm", "mm", {0, 10'000}, kNoMotion,
                 "Top of the cylinder above the table; 0: not known.");
    constexpr Bounds kOffset{-10'000, 10'000};
    blank.number(&B::offset_x_mm, "offset_x_mm", "mm", kOffset, kNoMotion,
                 "Where the cylinder's axis stands off the table's, towards direction 0.");
    blank.number(&B::offset_z_mm, "offset_z_mm", "mm", kOffset, kNoMotion,
                 "Where the cylinder's axis stands off the table's, towards direction 90.");
    blank.number(&B::depth_limit_mm, "depth_limit_mm", "mm", {0, 10'000}, kNoMotion,
                 "No tip goes deeper than this below the cylinder's surface; 0: no limit.");
}

void add_roughing(std::vector<KeySpec>& keys) {
    using R = RoughingProfile;
    TableSection<R> roughing(keys, "roughing", [](Profile& p) -> R& { return p.roughing; });
    roughing.number(&R::stepdown_mm, "stepdown_mm", "mm", {0, 10'000}, kNoMotion,
                    "How much further in each roughing pass goes; 0: the finishing pass alone.");
    roughing.number(&R::allowance_mm, "allowance_mm", "mm", {0, 10'000}, kNoMotion,
                    "What roughing leaves for the finishing pass, along the radius.");
    roughing.number(&R::stepover_mm, "stepover_mm", "mm", {0, 1000}, kNoMotion,
                    "The most between two of roughing's layers; 0: as the tool allows.");
}

void add_gcode(std::vector<KeySpec>& keys) {
    using G = GcodeProfile;
    TableSection<G> gcode(keys, "gcode", [](Profile& p) -> G& { return p.gcode; });
    gcode.word(&G::letters, "letters", kAxisNamesWords, kNoMotion,
               "Letters for R1, R2, Y and Psi: X, Z, Y and C, or, as lathes have them, X, U, Z and C.");
    gcode.word(&G::second_head, "second_head", kSecondHeadWords, kNoMotion,
               "R2 has a letter of its own, or goes where the letter of R1 says.");
    gcode.word(&G::turns_shortest, "rapid_psi", kRapidPsiWords, kNoMotion,
               "G0 of C turns as it is written, or the shortest way to the same direction.");
    gcode.word(&G::feeds_over_surface, "feed_over", kFeedOverWords, kNoMotion,
               "F is along X, Y and Z, or of the faster tool over the piece, which turns under it.");
    gcode.word(&G::is_stepwise, "interpolation", kInterpolationWords, kNoMotion,
               "Feeds along a path through all points, or, of a head and Y, by point-by-point comparison.");
}

void add_port(std::vector<KeySpec>& keys) {
    using P = PortProfile;
    TableSection<P> port(keys, "port", [](Profile& p) -> P& { return p.port; });
    constexpr Bounds kTime{0, 10'000'000};
    port.number(&P::dir_setup_ns, "dir_setup_ns", "ns", kTime, kMotion,
                "Direction stands at least this long before a step's edge.");
    port.number(&P::dir_hold_ns, "dir_hold_ns", "ns", kTime, kMotion,
                "Direction stands at least this long after a step's edge.");
    port.number(&P::step_high_ns, "step_high_ns", "ns", {1, kTime.greatest}, kMotion,
                "A step pulse lasts at least this long.");
    port.number(&P::step_low_ns, "step_low_ns", "ns", {1, kTime.greatest}, kMotion,
                "The gap between two step pulses lasts at least this long.");
    port.word(&P::pulses, "pulses", kPulseFormWords, kMotion,
              "A step pulse ends at a later tick, or after a wait inside its own: one pulse a tick.");
    port.number(&P::input_filter_us, "input_filter_us", "us", {0, 100'000}, kNoMotion,
                "A sensor counts once it has stood this long; the emergency stop is never filtered.");
}

std::string pin_explanation(Signal signal) {
    return is_output(signal) ? "Output pin 1..9, 14, 16 or 17; 0: not wired; minus: active low."
                             : "Input pin 10..13 or 15; 0: not wired; minus: active low.";
}

void add_pins(std::vector<KeySpec>& keys) {
    using enum Signal;  // the order of the listing in the machine's description
    constexpr std::array kOrder{r1_step,  r1_dir,  r1_enable,  r2_step,   r2_dir,   r2_enable,
                                psi_step, psi_dir, psi_enable, y_step,    y_dir,    y_enable,
                                spindle,  y_limit, r2_limit,   psi_index, r1_limit, estop,
                                mist,     flood,   output_0,   output_1,  output_2, output_3};
    static_assert(kOrder.size() == kSignalCount);
    for (const Signal signal : kOrder) {
        auto field = [signal](Profile& profile) -> Field { return &profile.port.pins[index_of(signal)]; };
        keys.push_back({"port.pins." + std::string(name_of(signal)),
                        "pin",
                        {-17, 17},
                        {},
                        pin_explanation(signal),
                        kNoMotion,
                        field});
    }
    keys.push_back({"port.pins.charge_pump",
                    "pin",
                    {-17, 17},
                    {},
                    pin_explanation(charge_pump),
                    kNoMotion,
                    [](Profile& profile) -> Field { return &profile.port.charge_pump_pin; }});
}

std::vector<KeySpec> make_table() {
    std::vector<KeySpec> keys;
    add_top(keys);
    add_tick(keys);
    add_linear_axis(keys, "axis.r1", [](Profile& p) -> LinearAxisProfile& { return p.r1; });
    add_linear_axis(keys, "axis.r2", [](Profile& p) -> LinearAxisProfile& { return p.r2; });
    add_rotary_axis(keys);
    add_linear_axis(keys, "axis.y", [](Profile& p) -> LinearAxisProfile& { return p.y; });
    add_head_and_job(keys);
    add_tool_and_blank(keys);
    add_roughing(keys);
    add_gcode(keys);
    add_port(keys);
    add_pins(keys);
    return keys;
}

}  // namespace

const std::vector<KeySpec>& key_table() {
    static const std::vector<KeySpec> table = make_table();
    return table;
}

const KeySpec* find_key(std::string_view path) {
    static const std::unordered_map<std::string_view, const KeySpec*> by_path = [] {
        std::unordered_map<std::string_view, const KeySpec*> found;
        for (const KeySpec& key : key_table()) found.emplace(key.path, &key);
        return found;
    }();
    const auto found = by_path.find(path);
    return found == by_path.end() ? nullptr : found->second;
}

Field field_of(const KeySpec& key, const Profile& profile) {
    // The accessors only form addresses; this one's callers only read.
    return key.field(const_cast<Profile&>(profile));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

}  // namespace psicarve::profile_detail

namespace psicarve {

namespace {

template <typename Enum>
std::string_view word_of(std::span<const profile_detail::Word> words, Enum value) noexcept {
    for (const profile_detail::Word& word : words) {
        if (word.value == profile_detail::number_of(value)) return word.text;
    }
    return {};
}

template <typename Enum>
std::optional<Enum> from_word(std::span<const profile_detail::Word> words, std::string_view text) noexcept {
    for (const profile_detail::Word& word : words) {
        if (word.text == text) return static_cast<Enum>(word.value);
    }
    return std::nullopt;
}

}  // namespace

std::string_view name_of(Joining joining) noexcept {
    return word_of(profile_detail::kJoiningWords, joining);
}

std::optional<Joining> joining_from_name(std::string_view name) noexcept {
    return from_word<Joining>(profile_detail::kJoiningWords, name);
}

std::string_view name_of(ToolShape shape) noexcept {
    return word_of(profile_detail::kToolShapeWords, shape);
}

std::optional<ToolShape> tool_shape_from_name(std::string_view name) noexcept {
    return from_word<ToolShape>(profile_detail::kToolShapeWords, name);
}

}  // namespace psicarve
