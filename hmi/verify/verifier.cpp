// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/verifier.hpp"

#include <optional>
#include <utility>

#include "hmi/verify/joint_finder.hpp"
#include "hmi/verify/judged_trace.hpp"
#include "hmi/verify/lift_filter.hpp"
#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/path_rule.hpp"
#include "hmi/verify/pin_rules.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {

/// Rule 1 by the job, and the others by PinRules.
struct Verifier::State : PositionJudge {
    State(const JobGeometry& of_job, const Profile& profile, const AskedCarving& what)
        : geometry(of_job),
          asked(what),
          surface(geometry),
          path(geometry, surface, log),
          to_path(path, profile),
          pins(profile, log, path.place(), *this) {
        if (asked.ends_there) path.end_with_last_layer();
        path.expect({asked.most_vain_starts, asked.least_runs});
        if (profile.job.planner == Planner::angle) joints.emplace(geometry, !asked.carves);
    }

    void settle(std::int64_t time_ns, const Positions& positions, SignalWord levels) override;
    void redefine(std::int64_t time_ns, const Positions& positions) override {
        stand_at(positions);
        to_path.redefine(time_ns, positions);
    }

    void stand_at(const Positions& positions) {
        last = positions;
        if (joints) joints->stand_at(positions);
    }
    std::uint32_t layer_count() const noexcept { return geometry.end_layer() - geometry.first_layer(); }
    bool is_whole_job() const noexcept {
        return layer_count() == geometry.layer_count() && geometry.first_step(geometry.first_layer()) == 0;
    }

    JobGeometry geometry;
    AskedCarving asked;
    Positions last{};
    std::optional<std::int64_t> spun_ns;  ///< the first motion with the spindle on
    OffenceLog log;
    CarvedSurface surface;
    PathRule path;
    LiftFilter to_path;
    PinRules pins;
    std::optional<JointFinder> joints;  ///< with planner "angle"
    Follower follower;
};

void Verifier::State::settle(std::int64_t time_ns, const Positions& positions, SignalWord levels) {
    const bool spindle_on = (levels & bit_of(Signal::spindle)) != 0;
    if (spindle_on && !spun_ns && positions != last) spun_ns = time_ns;
    last = positions;
    const std::uint64_t visited = path.points_visited();
    to_path.settle(time_ns, positions, spindle_on);
    if (follower) follower(positions, spindle_on);
    const bool is_joint = joints && joints->settle(time_ns, positions, spindle_on);
    if (path.points_visited() != visited || is_joint) pins.point_reached();
}

Result<Verifier> Verifier::make(const JobView& job, const Profile& profile, const LayerRange& layers) {
    return make_for(job, profile, {layers});
}

Result<Verifier> Verifier::make_for(const JobView& job, const Profile& profile, const AskedCarving& asked) {
    auto geometry = JobGeometry::make(job, profile, asked.layers);
    if (!geometry) return geometry.error();
    return Verifier(std::make_unique<State>(*geometry, profile, asked));
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

Result<void> Verifier::begin(const TraceStart& start) {
    if (const auto begun = state_->pins.begin(start); !begun) return begun;
    state_->stand_at(start.position_pulses);
    state_->to_path.begin(start.position_pulses, state_->pins.spindle_on());
    return {};
}

void Verifier::feed(std::span<const TraceEvent> events) {
    state_->pins.feed(events);
}

namespace {

/// The trace ends where the rule would go on.
bool is_end(const RuleResult& path) {
    return path.first && (path.first->fault == "ends-early" || path.first->fault == "no-carving");
}

void excuse_end(RuleResult& path) {
    if (--path.offences == 0) path.first.reset();
}

void add_offence(RuleResult& path, Offence offence) {
    ++path.offences;
    if (!path.first || offence.time_ns < path.first->time_ns) path.first = std::move(offence);
}

Offence dry_run_with_spindle(std::int64_t time_ns) {
    Offence offence;
    offence.rule = 1;
    offence.fault = "dry-run-carves";
    offence.time_ns = time_ns;
    offence.measured = 1.0;
    offence.unit = "spindle";
    offence.sentence = "rule 1: axes move with the spindle on, though it was a dry run";
    return offence;
}

/// What was asked for may have been less than to carve it to the end.
void judge_as_asked(VerifyReport& report, const AskedCarving& asked, bool lacks_run,
                    const std::optional<std::int64_t>& spun_ns) {
    RuleResult& path = report.rules[0];
    report.is_dry = !asked.carves;
    if (report.is_dry) {
        if (is_end(path)) excuse_end(path);
        if (spun_ns) add_offence(path, dry_run_with_spindle(*spun_ns));
        path.judged = path.offences != 0;
        report.points_total = report.points_visited;
        return;
    }
    const bool is_as_far =
        !lacks_run && report.points_visited > 0 && report.points_visited >= asked.least_points;
    report.is_cut = asked.may_end_early && is_as_far && report.points_visited != report.points_total;
    if (report.is_cut && is_end(path)) excuse_end(path);
}

}  // namespace

VerifyReport Verifier::finish() {
    State& s = *state_;
    s.pins.settle();
    s.to_path.finish(s.pins.instant_ns());
    s.pins.finish();
    VerifyReport report;
    report.rules = s.log.rules();
    report.pulses = s.pins.pulses();
    report.points_visited = s.path.points_visited();
    report.points_total = s.geometry.total_points();
    report.first_layer = s.geometry.first_layer();
    report.layer_count = s.layer_count();
    report.is_whole_job = s.is_whole_job();
    report.uncarved_cells = s.surface.uncarved_cells();
    const LineExtent line = s.path.line_extent();
    report.max_line_deviation_mm = line.mm;
    report.max_line_deviation_pulses = line.pulses;
    report.carve_seconds = s.path.carve_seconds();
    report.is_complete = s.path.has_arrived();
    report.passes = s.path.pass_times();
    report.trace_seconds = seconds_from_ns(s.pins.instant_ns());
    report.events = s.pins.events();
    report.first_point = s.asked.layers.first_point;
    judge_as_asked(report, s.asked, s.path.lacks_run(), s.spun_ns);
    report.max_deviation_pulses = report.is_of_carved_alone() ? s.surface.max_carved_deviation_pulses()
                                                              : s.surface.max_deviation_pulses();
    report.ok =
        report.first_offence() == nullptr && (report.is_cut || report.points_visited == report.points_total);
    return report;
}

Result<VerifyReport> verify_trace(Verifier& verifier, TraceReader& trace,
                                  const std::function<bool()>& goes_on) {
    return judged_trace(verifier, trace, goes_on);
}

}  // namespace psicarve::verify
