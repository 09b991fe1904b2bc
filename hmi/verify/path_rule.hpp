// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "hmi/surface/carved_surface.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/path_segment.hpp"

namespace psicarve::verify {

/// Rule 1: every point of the job is visited, in carving order and exactly; between two points of a layer
/// each head stays near the straight line; elsewhere (approach, links between layers, finish) no head stands
/// deeper than the job asks at that place. Carves the surface on the way.
///
/// An attempt at carving begins where the first point is reached with the spindle on, psi up to whole turns,
/// or where a later layer's first point is: then carving goes on with that layer; or where heads that go
/// in, psi and Y still, reach any other point but a layer's last: then it goes on within that layer. It ends
/// when the spindle stops or homing comes; a last way that only leads outward, psi and Y still, is the
/// retraction and not judged as a line. The last attempt that began with the first layer counts, and all
/// attempts that went on from it: breaches before are dropped, and a layer, or points, that none of them
/// carved are a breach. After a breach the rule goes on with the next point, so that one lost pulse does not
/// hide all that follows.
class PathRule {
public:
    PathRule(const JobGeometry& geometry, CarvedSurface& surface, OffenceLog& log);

    void begin(const Positions& positions, bool spindle_on);
    /// After each instant in which an axis stepped or the spindle was switched.
    void settle(std::int64_t time_ns, const Positions& positions, bool spindle_on);
    /// Homing defined the positions anew.
    void redefine(std::int64_t time_ns, const Positions& positions);
    void finish(std::int64_t time_ns);
    /// Whether telling a trial of this rule would count a breach. The rule itself stays as it is.
    bool objects_to(const std::function<void(PathRule& trial)>& tell) const;

    const CarvePlace& place() const noexcept { return place_; }
    std::uint64_t points_visited() const noexcept { return visited_; }
    double max_line_deviation_mm() const noexcept { return max_line_mm_; }
    double max_line_deviation_pulses() const noexcept { return max_line_pulses_; }
    double carve_seconds() const noexcept;
    /// For a job of several passes whose carving is complete.
    std::vector<PassTime> pass_times() const;

private:
    /// How far off a point a path still counts as on its way there.
    static constexpr std::int64_t kNearPulses = 64;
    /// Strays kept for one link; further ones count at once.
    static constexpr std::size_t kMostHeld = 16;

    enum class Phase { approach, segment, link, done };
    struct Heading {
        PathLine line;
        std::uint32_t surface_layer = 0;  ///< row of the carved surface that the tip is carving
        bool has_surface = false;
        std::uint32_t from_layer = 0;  ///< for a spiral: the row at the point that the tip comes from
        std::uint32_t from_cell = 0;
        std::uint32_t cell = 0;
        bool is_too_deep = false;  ///< reported already for this stay
        std::optional<std::int64_t>
            closest;  ///< radius nearest to the wanted one, while psi stood at the point's
    };

    /// The instant at which the axes were nearest to the target point.
    struct Nearest {
        Positions at{};
        std::int64_t most_off = std::numeric_limits<std::int64_t>::max();  ///< by any axis
        unsigned axes_off = 0;                                             ///< bit by axis

        void note(const Positions& now, const Positions& wanted) noexcept;
        /// Nothing when several axes were off, or one was far off.
        std::optional<Axis> only_axis_off() const noexcept;
    };
    struct Stray {
        Offence offence;
        CarvePlace place;
        std::int64_t most_off = 0;  ///< greatest depth of a head while it was too deep [pulses]
    };
    /// Breaches found while the heads only went outward: they do not count if the attempt ends so.
    struct Retraction {
        std::optional<Stray> stray;
        double max_line_mm = 0.0;
        double max_line_pulses = 0.0;
    };

    bool is_outward_from_last(const Positions& positions) const noexcept;
    void keep_retraction();
    void count(const Stray& stray);
    void hold_attempt();
    void count_held_attempt();
    using OnLines = std::array<bool, kHeadCount>;
    OnLines on_lines(std::int64_t time_ns, const Positions& at);
    void note_cells(const Positions& at);
    void carve(std::size_t h, const Positions& at);
    bool has_only_passed(const Positions& at) const noexcept;
    void follow_segment(std::int64_t time_ns, const Positions& at);
    void follow_link(std::int64_t time_ns, const Positions& at);
    void follow_approach(std::int64_t time_ns, const Positions& at, bool spindle_on);
    /// A point in the order of carving.
    struct Begin {
        std::uint32_t layer;
        std::uint32_t step;
    };

    bool is_begin_of(std::uint32_t layer, const Positions& at) const noexcept;
    bool is_first_point(const Positions& at) const noexcept {
        return is_begin_of(geometry_.first_layer(), at);
    }
    std::optional<std::uint32_t> layer_that_begins(const Positions& at);
    bool may_begin(const Positions& at) const noexcept;
    bool begin_layer(std::int64_t time_ns, const Positions& at);
    std::optional<std::uint32_t> step_at(std::uint32_t layer, const Positions& at) const noexcept;
    std::optional<Begin> point_that_begins(const Positions& at);
    void look_for_points(const Positions& at);
    void keep_before();
    void restore_before();
    bool is_judged(Begin begin) const noexcept;
    void forget_from(Begin begin);
    void follow(std::int64_t time_ns, const Positions& positions, bool spindle_on);
    std::uint32_t due_layer() const noexcept;
    bool was_near_first_point() const noexcept;
    void start(Begin begin, std::int64_t time_ns, std::int64_t psi_pulses);
    void leave_out(std::int64_t time_ns, std::uint32_t due);
    void leave_out_points(std::int64_t time_ns, Begin begin, std::uint32_t due);
    void count_point(std::uint32_t layer);
    void end_attempt(std::int64_t time_ns);
    void aim(std::uint32_t layer, std::uint32_t step);
    void advance();
    void reach(std::int64_t time_ns);
    void miss(std::int64_t time_ns, const Positions& at);
    Offence missed_by(Axis axis, std::int64_t measured) const;
    std::optional<Axis> axis_short_of_layers_end() const noexcept;
    void miss_rest_of_layer(std::int64_t time_ns, const Positions& at);
    void note_closest(const Positions& at);
    void stray(std::int64_t time_ns, std::size_t h, const PathLine::Distance& distance);
    /// Where Y should be on the straight way between two points [pulses], and how far off it may be.
    struct HeightLine {
        double at;
        double allowed;
    };
    HeightLine height_line(std::int64_t psi_pulses) const noexcept;
    void stray_in_height(std::int64_t time_ns, const Positions& at);
    void aim_surface(std::uint32_t layer, std::uint32_t point);
    void wrong_layer(std::int64_t time_ns, const Positions& at, std::uint32_t layer);
    void touch(std::int64_t time_ns, const Positions& at);
    void touch_head(std::size_t h, std::int64_t time_ns, const Positions& at);
    void keep_link();
    void excuse_link(Axis lost);
    bool is_where_it_ended(std::size_t h, const Positions& at) const noexcept;
    std::optional<double> floor_of_way(std::size_t h, const Positions& at, std::int64_t direction) const;
    void end_early(std::int64_t time_ns);
    void report(std::int64_t time_ns, Offence offence);
    /// The layer of the finishing pass at this height; nothing during roughing.
    std::optional<std::uint32_t> layer_at(const Positions& at) const noexcept;
    std::int64_t forward(std::int64_t psi_pulses) const noexcept;
    void mark(std::uint32_t layer, std::uint32_t cell, double radius_mm) noexcept {
        if (surface_ != nullptr) surface_->touch(layer, cell, static_cast<float>(radius_mm));
    }
    void note_deviation(std::uint32_t layer, std::uint32_t cell, std::int64_t pulses) noexcept {
        if (surface_ != nullptr) surface_->note_deviation(layer, cell, pulses);
    }

    JobGeometry geometry_;
    CarvedSurface* surface_;  ///< null: a trial carves nothing
    OffenceLog& log_;
    Phase phase_ = Phase::approach;
    Positions last_{};
    bool spindle_on_ = false;
    std::int64_t psi_offset_ = 0;  ///< whole turns between the trace's count and the job's angle
    Positions from_{};             ///< job's counts
    Positions to_{};
    std::uint32_t layer_ = 0;  ///< of the target point
    std::uint32_t step_ = 0;
    std::optional<Positions>
        link_from_;  ///< of a pass' first point, until the next one is aimed at: where it came from
    std::int64_t psi_sign_ = 1;  ///< which way this layer turns
    std::int64_t cells_at_psi_ = 0;
    std::array<Heading, kHeadCount> headings_;
    Nearest near_;
    bool strayed_ = false;       ///< reported already for this segment or link
    bool is_miss_told_ = false;  ///< reported already for the target point
    bool is_guess_ = false;      ///< the path only passed near the first point
    CarvePlace place_;
    RuleResult before_attempt_;
    RuleResult before_guess_;
    RuleResult at_start_;            ///< when the attempt began
    RuleResult held_;                ///< of the last attempt, which has ended: counts unless another follows
    std::uint64_t held_before_ = 0;  ///< offences before that attempt
    bool is_holding_ = false;
    bool is_complete_ = false;  ///< the last attempt reached the last point
    bool is_outward_ = false;   ///< this instant
    Retraction retraction_;
    std::vector<Stray> too_deep_in_link_;  ///< dropped if one axis alone missed the link's end
    std::optional<CarvePlace> ended_at_;   ///< where the last attempt ended early
    std::int64_t ended_ns_ = 0;
    Nearest ended_near_;
    std::optional<Positions> on_path_;       ///< last position on the lines: the attempt's, or by the trace's
                                             ///< count the last attempt's
    std::vector<std::uint32_t> visited_of_;  ///< points, by layer; those that are left out count
    /// What was there before the attempt, should it be none.
    struct Before {
        std::vector<std::uint32_t> visited_of;
        std::uint64_t visited = 0;
        RuleResult result;
        RuleResult held;
        std::uint64_t held_before = 0;
        bool is_holding = false;
        double max_line_mm = 0.0;
        double max_line_pulses = 0.0;
    };
    Before before_;
    bool goes_on_ = false;  ///< the attempt, with what others have carved
    std::optional<std::pair<std::int64_t, std::int64_t>> plunge_;  ///< psi and y of `plunge_points_`
    std::vector<Begin> plunge_points_;                             ///< where heads that go in may begin
    std::uint64_t visited_ = 0;                                    ///< in the layers that are to be carved
    std::uint32_t begun_layer_ = 0;                                ///< first layer of the attempt
    std::uint32_t begun_step_ = 0;                                 ///< and which of its points it began with
    bool has_turned_ = false;               ///< psi, with the spindle on, outside an attempt
    bool is_elsewhere_ = false;             ///< carves layers that are not judged, until the spindle stops
    std::optional<std::int64_t> begins_y_;  ///< height at which `beginning_` begin
    std::vector<std::uint32_t> beginning_;  ///< layers
    bool has_left_ = false;
    std::int64_t left_ns_ = 0;     ///< when the first point was left
    std::int64_t arrived_ns_ = 0;  ///< when the last point was reached
    std::vector<std::int64_t> pass_ended_ns_;
    double max_line_mm_ = 0.0;
    double max_line_pulses_ = 0.0;
};

}  // namespace psicarve::verify
