// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "hmi/surface/carved_surface.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "hmi/verify/attempt_ledger.hpp"
#include "hmi/verify/job_follower.hpp"
#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/path/carve_progress.hpp"
#include "hmi/verify/path/carving_begins.hpp"

namespace psicarve::verify {

/// Rule 1: every point of the job is visited, in carving order and exactly; between two points of a layer
/// each head stays near the straight line; elsewhere (approach, links between layers, finish) no head stands
/// deeper than the job asks at that place. Carves the surface on the way.
///
/// An attempt at carving begins where the first point is reached with the spindle on, psi up to whole turns,
/// or where a later layer's first point is: then carving goes on with that layer; or where heads that go
/// in, psi and Y still, reach any other point but a layer's last: then it goes on within that layer. It ends
/// when the spindle stops or homing comes; a last way that only leads outward, psi and Y still, is the
/// retraction and not judged as a line. The last attempt that began with the first layer and left its first
/// point counts, and all attempts that went on from it: breaches before are dropped, and a layer, or points,
/// that none of them carved are a breach. After a breach the rule goes on with the next point, so that one
/// lost pulse does not hide all that follows.
///
/// JobFollower judges the ways of an attempt; this class says where attempts begin and end. Its members: its
/// parts, the attempt at hand, what was there before it should it be none, and how many there were.
class PathRule {
public:
    /// All three outlive it.
    PathRule(const JobGeometry& geometry, CarvedSurface& surface, OffenceLog& log);

    /// The layers to be judged are all that the trace was to carve: what comes behind them is judged as
    /// behind a whole job.
    void end_with_last_layer() noexcept { ends_there_ = true; }

    /// How many attempts a flight recorder tells of.
    struct Runs {
        /// That only go in, behind all others.
        std::uint64_t most_in_vain = std::numeric_limits<std::uint64_t>::max();
        std::uint64_t least_carving = 0;  ///< that come to a second point
    };
    void expect(const Runs& runs) noexcept { expected_ = runs; }

    void begin(const Positions& positions, bool spindle_on);
    /// After each instant in which an axis stepped or the spindle was switched.
    void settle(std::int64_t time_ns, const Positions& positions, bool spindle_on);
    /// Homing defined the positions anew.
    void redefine(std::int64_t time_ns, const Positions& positions);
    void finish(std::int64_t time_ns);
    /// Whether telling a trial of this rule would count a breach. The rule itself stays as it is.
    bool objects_to(const std::function<void(PathRule& trial)>& tell) const;

    const CarvePlace& place() const noexcept { return follower_.place(); }
    std::uint64_t points_visited() const noexcept { return follower_.progress().points(); }
    LineExtent line_extent() const noexcept { return follower_.findings().line_extent(); }
    double carve_seconds() const noexcept {
        return has_arrived() ? follower_.times().carve_seconds() : follower_.times().seconds_so_far();
    }
    /// The last attempt came to the last point.
    bool is_complete() const noexcept { return end_.is_complete; }
    /// The same, and reached one of the points behind its first.
    bool has_arrived() const noexcept { return is_complete() && follower_.times().carve_seconds() > 0.0; }
    /// For a job of several passes whose carving is complete.
    std::vector<PassTime> pass_times() const;
    /// A run that was to carve is not in the trace: what came before it stands for nothing. Once finished.
    bool lacks_run() const noexcept { return lacks_run_; }

private:
    using Phase = JobFollower::Phase;

    /// A breach that counts once the attempt carves.
    struct LeftOut {
        Offence offence;
        CarvePlace place;
    };
    /// The attempt that is on its way, or the last one.
    struct Attempt {
        CarvePoint begin;
        bool goes_on = false;               ///< with what others have carved
        bool is_guess = false;              ///< the path only passed near the first point
        bool has_left = false;              ///< psi turned away from the point with which it began
        bool was_elsewhere = false;         ///< layers that are not judged were being carved
        std::int64_t psi_offset = 0;        ///< whole turns between the trace's count and the job's angle
        std::optional<LeftOut> left_out{};  ///< layers or points before its begin
    };
    /// How the last attempt ended.
    struct End {
        std::optional<CarvePlace> early_at;  ///< nothing: at the last point, or there was none
        std::int64_t time_ns = 0;
        Nearest nearest;
        bool is_complete = false;
    };
    /// An attempt that came to no second point, as if it were all that counts.
    struct Vain {
        End end;
        CarveProgress::Kept progress;
    };
    /// What was there before the attempt, should it be none.
    struct Before {
        JobFollower::Kept follower;
        AttemptLedger::Kept ledger;
        End end;
    };

    Positions in_jobs_count(Positions positions) const noexcept;
    bool is_outward(const Positions& positions) const noexcept;
    bool has_only_gone_in() const noexcept;
    bool was_in_vain() const noexcept;
    bool stands_at_begin(const Positions& positions) const noexcept;
    bool has_only_passed(const Positions& positions) const noexcept;
    bool may_begin(const Positions& positions) const noexcept;
    bool begins_again(const Positions& positions);
    bool goes_in(const Positions& positions) const noexcept;
    std::uint32_t due_layer() const noexcept;
    std::optional<CarvePoint> begin_at(const Positions& positions);
    bool is_judged(CarvePoint begin) const noexcept;
    bool begin_attempt(std::int64_t time_ns, const Positions& positions);
    void start(CarvePoint begin, std::int64_t time_ns, std::int64_t psi_pulses);
    void leave_out(std::int64_t time_ns, Offence offence);
    void count_left_out(const Positions& positions);
    void restore_before();
    void follow(std::int64_t time_ns, const Positions& positions, bool spindle_on);
    void note_way(std::int64_t time_ns, const Positions& positions);
    void follow_approach(std::int64_t time_ns, const Positions& positions, bool spindle_on);
    void leave_first_point(std::int64_t time_ns, const Positions& positions);
    void end_attempt(std::int64_t time_ns);
    void end_in_vain();
    void count_attempt(std::int64_t time_ns);
    bool is_run_missing() const noexcept;
    void judge_by_missing_run();
    void end_behind_judged_layers();
    void report_missing_end(std::int64_t time_ns);

    const JobGeometry& geometry_;
    OffenceLog& log_;
    JobFollower follower_;
    CarvingBegins begins_;
    AttemptLedger ledger_;
    Attempt attempt_;
    End end_;
    Before before_;
    Runs expected_;
    std::optional<Vain> last_vain_;
    std::uint64_t in_vain_ = 0;  ///< attempts since one came to its second point
    std::uint64_t carving_ = 0;  ///< attempts that did
    RuleResult before_homing_;   ///< of motion that does not count
    RuleResult before_guess_;
    Positions last_{};
    bool spindle_on_ = false;
    bool has_turned_ = false;  ///< psi, with the spindle on, outside an attempt
    bool ends_there_ = false;
    bool lacks_run_ = false;
    bool is_elsewhere_ = false;  ///< carves layers that are not judged, until the spindle stops
};

}  // namespace psicarve::verify
