// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "hmi/verify/carved_surface.hpp"
#include "hmi/verify/job_geometry.hpp"
#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/path_segment.hpp"

namespace psicarve::verify {

/// Rule 1: every point of the job is visited, in carving order and exactly; between two points of a layer
/// each head stays near the straight line; elsewhere (approach, links between layers, finish) no head stands
/// deeper than the job asks at that place. Carves the surface on the way.
///
/// An attempt at carving begins where the first point is reached with the spindle on, psi up to whole turns.
/// It ends when the spindle stops or homing comes; a last way that only leads outward, psi and Y still, is
/// the retraction and not judged as a line. The last attempt counts: breaches within earlier ones are
/// dropped. After a breach the rule goes on with the next point, so that one lost pulse does not hide all
/// that follows.
class PathRule {
public:
    PathRule(const JobGeometry& geometry, CarvedSurface& surface, OffenceLog& log);

    void begin(const Positions& positions, bool spindle_on);
    /// After each instant in which an axis stepped or the spindle was switched.
    void settle(std::int64_t time_ns, const Positions& positions, bool spindle_on);
    /// Homing defined the positions anew.
    void redefine(std::int64_t time_ns, const Positions& positions);
    void finish(std::int64_t time_ns);

    const CarvePlace& place() const noexcept { return place_; }
    std::uint64_t points_visited() const noexcept { return visited_; }
    double max_line_deviation_mm() const noexcept { return max_line_mm_; }
    double max_line_deviation_pulses() const noexcept { return max_line_pulses_; }
    double carve_seconds() const noexcept;

private:
    enum class Phase { approach, segment, link, done };
    struct Heading {
        PathLine line;
        std::uint32_t surface_layer = 0;  ///< row of the carved surface that the tip works on
        bool has_surface = false;
        std::uint32_t from_layer = 0;  ///< of a spiral: on which it worked at the point it comes from
        std::uint32_t from_cell = 0;
        std::uint32_t cell = 0;
        bool is_too_deep = false;  ///< told already for this stay
        std::optional<std::int64_t>
            closest;  ///< radius nearest to the wanted one, while psi stood at the point's
    };

    /// The instant at which the axes were nearest to the point aimed at.
    struct Nearest {
        Positions at{};
        std::int64_t most_off = std::numeric_limits<std::int64_t>::max();  ///< by any axis
        unsigned axes_off = 0;                                             ///< bit by axis

        void note(const Positions& now, const Positions& wanted) noexcept;
        /// Nothing when several axes were off, or far.
        std::optional<Axis> only_axis_off() const noexcept;
    };
    struct Stray {
        std::int64_t time_ns;
        std::size_t head;
        PathLine::Distance distance;
        CarvePlace place;
    };
    /// What was found while the heads only went outward: nothing, should that be how the attempt ends.
    struct Retraction {
        std::optional<Stray> stray;
        double max_line_mm = 0.0;
        double max_line_pulses = 0.0;
    };

    bool is_outward_from_last(const Positions& positions) const noexcept;
    void keep_retraction();
    void hold_attempt();
    void count_held_attempt();
    bool is_on_lines(std::int64_t time_ns, const Positions& at);
    void carve(const Positions& at);
    void follow_segment(std::int64_t time_ns, const Positions& at);
    void follow_link(std::int64_t time_ns, const Positions& at);
    void follow_approach(std::int64_t time_ns, const Positions& at, bool spindle_on);
    bool is_first_point(const Positions& at) const noexcept;
    bool was_near_first_point() const noexcept;
    void start(std::int64_t psi_pulses);
    void end_attempt(std::int64_t time_ns);
    void aim(std::uint32_t layer, std::uint32_t step);
    void advance();
    void reach(std::int64_t time_ns);
    void miss(std::int64_t time_ns, const Positions& at);
    void miss_rest_of_layer(std::int64_t time_ns, const Positions& at);
    void note_closest(const Positions& at);
    void stray(std::int64_t time_ns, std::size_t h, const PathLine::Distance& distance);
    /// Where Y is to be on the straight way between two points [pulses], and how far off it may be.
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
    bool is_where_it_ended(std::size_t h, const Positions& at) const noexcept;
    void end_early(std::int64_t time_ns);
    void report(std::int64_t time_ns, Offence offence);
    std::int64_t forward(std::int64_t psi_pulses) const noexcept;

    JobGeometry geometry_;
    CarvedSurface& surface_;
    OffenceLog& log_;
    Phase phase_ = Phase::approach;
    Positions last_{};
    bool spindle_on_ = false;
    std::int64_t psi_offset_ = 0;  ///< whole turns between the trace's count and the job's angle
    Positions from_{};             ///< job's counts
    Positions to_{};
    std::uint32_t layer_ = 0;  ///< of the point aimed at
    std::uint32_t step_ = 0;
    std::int64_t psi_sign_ = 1;  ///< which way this layer turns
    std::int64_t cells_at_psi_ = 0;
    std::array<Heading, kHeadCount> headings_;
    Nearest near_;
    bool strayed_ = false;   ///< told already for this segment or link
    bool is_guess_ = false;  ///< the first point was only passed nearby
    CarvePlace place_;
    RuleResult before_attempt_;
    RuleResult before_guess_;
    RuleResult at_start_;            ///< when the attempt began
    RuleResult held_;                ///< of the last attempt, ended: counts unless another follows
    std::uint64_t held_before_ = 0;  ///< offences that were there before it
    bool is_holding_ = false;
    bool is_complete_ = false;  ///< the last attempt reached the last point
    bool is_outward_ = false;   ///< this instant
    Retraction retraction_;
    std::optional<CarvePlace> ended_at_;  ///< where the last attempt ended before its time
    std::int64_t ended_ns_ = 0;
    Nearest ended_near_;
    std::optional<Positions> ended_on_path_;  ///< as the trace counts, where it ended between two points
    std::uint64_t visited_ = 0;
    bool has_left_ = false;
    std::int64_t left_ns_ = 0;     ///< the first point
    std::int64_t arrived_ns_ = 0;  ///< at the last
    double max_line_mm_ = 0.0;
    double max_line_pulses_ = 0.0;
};

}  // namespace psicarve::verify
