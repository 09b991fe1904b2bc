// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "hmi/surface/job_geometry.hpp"
#include "hmi/verify/path/carve_progress.hpp"
#include "hmi/verify/path/path_line.hpp"

namespace psicarve::verify {

/// How far off a point a path still counts as on its way there [pulses].
inline constexpr std::int64_t kNearPulses = 64;

/// The instant at which the axes were nearest to a point.
struct Nearest {
    Positions at{};
    std::int64_t most_off = std::numeric_limits<std::int64_t>::max();  ///< by any axis [pulses]
    unsigned axes_off = 0;                                             ///< bit by axis

    void note(const Positions& now, const Positions& wanted) noexcept;
    /// Nothing when several axes were off, or one was far off.
    std::optional<Axis> only_axis_off() const noexcept;
};

/// The straight way to the next point of a job, and how near the axes have come to it. Positions are in the
/// job's counts: psi without the trace's whole turns.
class PointWay {
public:
    /// The geometry outlives it.
    explicit PointWay(const JobGeometry& geometry) noexcept : geometry_(geometry) {}

    /// Makes a point the next one; the way begins at the one that was.
    void aim(CarvePoint point) noexcept;
    /// The point behind was reached on a link from there: a pass' first point may only have been passed.
    void note_link(const Positions& from) noexcept { link_from_ = from; }
    /// It was so: the next way that is aimed at begins where that link began.
    void go_back_to_link() noexcept { to_ = *link_from_; }

    CarvePoint point() const noexcept { return point_; }
    bool is_layers_last() const noexcept { return point_.step + 1 == geometry_.point_count(); }
    const Positions& from() const noexcept { return from_; }
    const Positions& to() const noexcept { return to_; }
    /// Psi is this much beyond the point, in the layer's sense of turning [pulses].
    std::int64_t beyond(std::int64_t psi_pulses) const noexcept {
        return (psi_pulses - to_[kPsi]) * psi_sign_;
    }

    const PathLine& line(std::size_t h) const noexcept { return lines_[h]; }
    PathLine::Distance distance(std::size_t h, const Positions& at) const noexcept {
        return lines_[h].distance(at[kPsi] - from_[kPsi],
                                  at[index_of(kHeads[h])] - from_[index_of(kHeads[h])]);
    }
    /// Where Y should be [pulses], and how far off it may be.
    struct HeightLine {
        double at;
        double allowed;
    };
    HeightLine height_line(std::int64_t psi_pulses) const noexcept;
    /// From the way's begin the heads go straight out, psi and Y still, where no line leads.
    bool leads_not_out(const Positions& at) const noexcept;
    /// A pass whose first point lies where the heads go out from the pass before: there they were on their
    /// way, and still are.
    bool has_only_passed_link(const Positions& at) const noexcept {
        return link_from_.has_value() && leads_not_out(at);
    }

    /// The axes are here and not at the point.
    void note(const Positions& at) noexcept { near_.note(at, to_); }
    /// The same, psi standing at the point's.
    void note_radii(const Positions& at) noexcept;
    const Nearest& nearest() const noexcept { return near_; }
    /// The radius nearest to the wanted one while psi stood at the point's, or this one.
    std::int64_t closest(std::size_t h, const Positions& at) const noexcept {
        return closest_[h].value_or(at[index_of(kHeads[h])]);
    }
    /// The axis that was furthest off, the point being missed.
    struct Miss {
        Axis axis = Axis::psi;
        std::int64_t off = 0;  ///< 0: every axis was there, at different instants
        std::int64_t measured = 0;
    };
    Miss miss(const Positions& at) const noexcept;

private:
    const JobGeometry& geometry_;
    CarvePoint point_;
    Positions from_{};
    Positions to_{};
    std::optional<Positions> link_from_;
    std::int64_t psi_sign_ = 1;  ///< which way this layer turns
    std::array<PathLine, kHeadCount> lines_;
    std::array<std::optional<std::int64_t>, kHeadCount> closest_;
    Nearest near_;
};

}  // namespace psicarve::verify
