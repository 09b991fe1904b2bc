// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/verifier.hpp"

#include <bit>
#include <utility>
#include <vector>

#include "hmi/trace/backlash.hpp"
#include "hmi/verify/lift_filter.hpp"
#include "hmi/verify/motor_rule.hpp"
#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/path_rule.hpp"
#include "hmi/verify/permission_rule.hpp"
#include "hmi/verify/timing_rule.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {
constexpr SignalWord kPermissionMask = kEnableMask | kInputMask | bit_of(Signal::spindle);
constexpr std::size_t kEventsAtOnce = 1024;
}  // namespace

/// Makes pulses and positions of pins and hands each to the rules. A rule that judges single pulses is called
/// in `pulse`; one that judges positions, in `settle`.
struct Verifier::State {
    State(const JobGeometry& geometry, const Profile& profile)
        : surface(geometry),
          path(geometry, surface, log),
          to_path(path, profile),
          timing(profile.port, log),
          motors(profile, log),
          permission(profile, log),
          backlash(profile),
          first_layer(geometry.first_layer()),
          layer_count(geometry.end_layer() - geometry.first_layer()),
          is_whole_job(layer_count == geometry.layer_count()),
          points_total(geometry.total_points()) {
        log.set_judged(2);
        log.set_judged(4);
    }

    void pins(const TraceEvent& event);
    void pulse(Axis axis);
    void settle();
    void redefine(const TraceEvent& event);
    bool spindle_on() const noexcept { return (levels & spindle_bit) != 0 || spindle_bit == 0; }

    OffenceLog log;
    CarvedSurface surface;
    PathRule path;
    LiftFilter to_path;
    TimingRule timing;
    MotorRule motors;
    PermissionRule permission;
    Backlash backlash;
    SignalWord levels = 0;
    SignalWord spindle_bit = 0;  ///< 0: not in the trace
    std::int64_t instant_ns = 0;
    bool unsettled = false;  ///< the instant moved an axis or switched the spindle
    Positions positions{};
    std::array<std::uint64_t, kAxisCount> pulses{};
    std::uint64_t events = 0;
    std::uint32_t first_layer;
    std::uint32_t layer_count;
    bool is_whole_job;
    std::uint64_t points_total;
    Follower follower;
};

void Verifier::State::pulse(Axis axis) {
    const std::size_t a = index_of(axis);
    const bool positive = (levels & bit_of(dir_of(axis))) != 0;
    timing.rising(axis, instant_ns, path.place());
    permission.rising(axis, positive, instant_ns, path.place());
    motors.pulse(axis, positive, instant_ns, path.place());
    const std::int64_t moved = backlash.step(axis, positive);
    positions[a] += moved;
    ++pulses[a];
    unsettled = unsettled || moved != 0;
}

void Verifier::State::pins(const TraceEvent& event) {
    const SignalWord changed = levels ^ event.levels;
    if (changed == 0) return;
    ++events;
    const SignalWord before = std::exchange(levels, event.levels);
    if ((changed & kPermissionMask) != 0) {
        permission.levels_changed(before, levels, instant_ns);
        motors.levels_changed(before, levels, instant_ns);
        unsettled = unsettled || (changed & spindle_bit) != 0;
    }
    for (SignalWord turned = (changed & kDirMask) >> kAxisCount; turned != 0; turned &= turned - 1)
        timing.direction_changed(static_cast<Axis>(std::countr_zero(turned)), instant_ns, path.place());
    for (SignalWord fell = changed & ~levels & kStepMask; fell != 0; fell &= fell - 1)
        timing.falling(static_cast<Axis>(std::countr_zero(fell)), instant_ns, path.place());
    for (SignalWord rose = changed & levels & kStepMask; rose != 0; rose &= rose - 1)
        pulse(static_cast<Axis>(std::countr_zero(rose)));
}

/// All pulses of one instant belong together: only now are the positions judged.
void Verifier::State::settle() {
    if (!std::exchange(unsettled, false)) return;
    const std::uint64_t visited = path.points_visited();
    to_path.settle(instant_ns, positions, spindle_on());
    if (follower) follower(positions, spindle_on());
    if (path.points_visited() != visited) motors.point_reached(instant_ns, path.place());
}

void Verifier::State::redefine(const TraceEvent& event) {
    settle();
    positions = event.position_pulses;
    to_path.redefine(event.time_ns, positions);
    permission.positions_redefined();
}

Result<Verifier> Verifier::make(const JobView& job, const Profile& profile, const LayerRange& layers) {
    auto geometry = JobGeometry::make(job, profile, layers);
    if (!geometry) return geometry.error();
    return Verifier(std::make_unique<State>(*geometry, profile));
}

Verifier::Verifier(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
Verifier::Verifier(Verifier&&) noexcept = default;
Verifier& Verifier::operator=(Verifier&&) noexcept = default;
Verifier::~Verifier() = default;

const CarvedSurface& Verifier::surface() const noexcept {
    return state_->surface;
}

void Verifier::set_follower(Follower follower) {
    state_->follower = std::move(follower);
}

void Verifier::begin(const TraceStart& start) {
    State& s = *state_;
    s.levels = start.initial_levels;
    s.spindle_bit = start.present & bit_of(Signal::spindle);
    s.positions = start.position_pulses;
    s.permission.begin(start.initial_levels, start.present, start.period_ns);
    s.motors.begin(start.period_ns);
    s.to_path.begin(s.positions, s.spindle_on());
}

void Verifier::feed(std::span<const TraceEvent> events) {
    State& s = *state_;
    for (const TraceEvent& event : events) {
        if (event.time_ns != s.instant_ns) {
            s.settle();
            s.instant_ns = event.time_ns;
        }
        if (event.kind == TraceEvent::Kind::pins)
            s.pins(event);
        else
            s.redefine(event);
    }
}

VerifyReport Verifier::finish() {
    State& s = *state_;
    s.settle();
    s.to_path.finish(s.instant_ns);
    s.permission.finish();
    s.motors.finish(s.instant_ns);
    VerifyReport report;
    report.rules = s.log.rules();
    report.pulses = s.pulses;
    report.points_visited = s.path.points_visited();
    report.points_total = s.points_total;
    report.first_layer = s.first_layer;
    report.layer_count = s.layer_count;
    report.is_whole_job = s.is_whole_job;
    report.max_deviation_pulses = s.surface.max_deviation_pulses();
    report.uncarved_cells = s.surface.uncarved_cells();
    report.max_line_deviation_mm = s.path.max_line_deviation_mm();
    report.max_line_deviation_pulses = s.path.max_line_deviation_pulses();
    report.carve_seconds = s.path.carve_seconds();
    report.passes = s.path.pass_times();
    report.trace_seconds = seconds_from_ns(s.instant_ns);
    report.events = s.events;
    report.ok = report.first_offence() == nullptr && report.points_visited == report.points_total;
    return report;
}

Result<VerifyReport> verify_trace(Verifier& verifier, TraceReader& trace,
                                  const std::function<bool()>& goes_on) {
    verifier.begin(trace.start());
    std::vector<TraceEvent> events(kEventsAtOnce);
    for (;;) {
        if (goes_on && !goes_on()) return Error{ErrorCode::cancelled, "verification was cancelled"};
        auto count = trace.read(events);
        if (!count) return count.error();
        if (*count == 0) return verifier.finish();
        verifier.feed(std::span(events).first(*count));
    }
}

}  // namespace psicarve::verify
