// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hmi/surface/carved_surface.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "hmi/verify/carve_times.hpp"
#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/path/carve_progress.hpp"
#include "hmi/verify/path/point_way.hpp"
#include "hmi/verify/path/surface_painter.hpp"
#include "hmi/verify/pending_findings.hpp"

namespace psicarve::verify {

/// Follows the axes from point to point of a job and judges the ways between them; carves the surface. Where
/// an attempt begins and ends it is told. Positions are in the job's counts: psi without the whole turns of
/// the attempt. After a breach it goes on with the next point.
class JobFollower {
public:
    enum class Phase {
        approach,  ///< no attempt: only depths are judged
        segment,   ///< on a straight line to a point
        link,      ///< to a layer's first point
        done       ///< behind the last point
    };

    /// All three outlive it.
    JobFollower(const JobGeometry& geometry, CarvedSurface& surface, OffenceLog& log);

    /// The surface stays as it is from now on.
    void stop_carving() noexcept { painter_.let_go(); }
    void make_blank() { painter_.make_blank(); }

    /// No attempt has begun yet; the first will be at this point.
    void wait_for(CarvePoint begin);
    /// An attempt begins; the caller tells next that this point is reached, or missed.
    void begin(CarvePoint begin);
    void reach(std::int64_t time_ns);
    /// The axes, now here, will not reach the point any more. Those that are beyond it go on to the next.
    void miss(std::int64_t time_ns, const Positions& at);
    /// The axes are here now. `psi_turned`: they were at another psi before.
    void follow(std::int64_t time_ns, const Positions& at, bool psi_turned);
    /// The attempt has ended; from now on positions are the trace's, psi greater by this.
    void end(std::int64_t psi_offset_pulses);
    /// What attempts have done, for when the one that begins turns out to be none.
    struct Kept {
        CarveProgress::Kept progress;
        CarveTimes times;
        LineExtent line;
        std::optional<Positions> on_path;
    };
    Kept kept() const;
    void restore(const Kept& earlier);

    /// Gives words to a breach that counted as the earliest.
    void report(std::int64_t time_ns, Offence offence);
    /// What is found from now on is found there.
    void set_place(const CarvePlace& place) noexcept { place_ = place; }
    /// The heads' depth where no attempt is on its way.
    void touch(std::int64_t time_ns, const Positions& at);

    Phase phase() const noexcept { return phase_; }
    const CarvePlace& place() const noexcept { return place_; }
    const CarveProgress& progress() const noexcept { return progress_; }
    CarveProgress& progress() noexcept { return progress_; }
    const CarveTimes& times() const noexcept { return times_; }
    CarveTimes& times() noexcept { return times_; }
    PendingFindings& findings() noexcept { return findings_; }
    const PendingFindings& findings() const noexcept { return findings_; }
    PointWay& way() noexcept { return way_; }
    const PointWay& way() const noexcept { return way_; }

private:
    void aim(CarvePoint point);
    void aim_surface();
    void advance();
    void follow_segment(std::int64_t time_ns, const Positions& at, bool psi_turned);
    void follow_link(std::int64_t time_ns, const Positions& at, bool psi_turned);
    bool is_off_height(const Positions& at) const noexcept;
    void stray_in_height(std::int64_t time_ns, const Positions& at);
    /// Which heads are near enough to their straight lines.
    std::array<bool, kHeadCount> on_lines(std::int64_t time_ns, const Positions& at);
    void stray(std::int64_t time_ns, std::size_t h, const PathLine::Distance& distance);
    void go_to_wrong_layer(std::int64_t time_ns, const Positions& at, std::uint32_t layer);
    void touch_head(std::size_t h, std::int64_t time_ns, const Positions& at);
    std::optional<Axis> axis_short_of_layers_end() const noexcept;
    bool is_where_it_ended(std::size_t h, const Positions& at) const noexcept;
    /// The layer of the finishing pass at this height; nothing during roughing.
    std::optional<std::uint32_t> layer_at(const Positions& at) const noexcept;
    std::uint32_t carved_point_of(CarvePoint point) const noexcept;

    const JobGeometry& geometry_;
    OffenceLog& log_;
    SurfacePainter painter_;
    CarveProgress progress_;
    CarveTimes times_;
    PendingFindings findings_;
    PointWay way_;
    Phase phase_ = Phase::approach;
    CarvePlace place_;
    bool strayed_ = false;              ///< reported already for this segment or link
    bool is_miss_told_ = false;         ///< reported already for the next point
    std::optional<Positions> on_path_;  ///< last position on the lines: the attempt's, or by the trace's
                                        ///< count the last attempt's
};

}  // namespace psicarve::verify
