// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/path.hpp"
#include "rtcore/plan/speed_profile.hpp"

namespace psicarve::plan {

/// Timings that every stretch has: [0] at the feed asked for, [1] at twice that (override).
inline constexpr std::size_t kTimingCount = 2;
inline constexpr std::array<double, kTimingCount> kFeedFactor{1.0, 2.0};
using Timings = std::array<double, kTimingCount>;

/// One DDA segment of a timed curve, with whole pulses at both ends; (du/dt)^2 is linear in it.
struct PathPiece {
    static constexpr std::uint32_t kNoPoint = ~std::uint32_t{0};

    Pulses4 delta_pulses;
    Pulses4 line_pulses;     ///< of whose pulses it has a part; 0: a line of its own
    std::int64_t line_done;  ///< DDA iterations of that line before it
    double length;           ///< of u [s]
    Timings begin_speed2;
    Timings end_speed2;
    Lanes slope;          ///< greatest |dq/du| in it [pulses/s]
    Lanes bend;           ///< greatest |d2q/du2| [pulses/s^2]
    std::uint32_t point;  ///< index of the path point it reaches, or kNoPoint
};

/// Into how many bits of equal length a part of a cell is cut, each as good as straight: DDA segments end at
/// such bits' ends alone.
std::size_t bits_in(const PathCell& cell, double length);

/// Cuts a timed curve into DDA segments: one from point to point where a straight line at an even
/// acceleration stays within half a pulse of the curve at every instant, more where it does not.
class PieceMaker {
public:
    PieceMaker(const MachineLimits& limits, std::span<const PathPoint> points, std::uint32_t first_point,
               const Lanes& start, std::vector<PathPiece>& pieces);

    /// The cell that the next add() is about: where it begins, and the speeds at its ends.
    void begin_cell(const PathCell& cell, const Lanes& at, const Timings& begin2, const Timings& end2);
    /// A part of the cell; `point` is what its end stands on, or kNoPoint. A point ends a segment.
    void add(double from, double to, std::uint32_t point);

private:
    /// A part of a cell that is as good as straight.
    struct Bit {
        double length;
        double seconds;
        double begin_speed;  ///< du/dt at 100 %
        double end_speed;
        Lanes end;  ///< position [pulses]
        Timings begin_speed2;
        Timings end_speed2;
        Lanes slope;
        Lanes bend;
    };

    void add_bit(double from, double to);
    void flush(std::uint32_t point);
    std::size_t longest(std::size_t first) const;
    bool is_straight(std::size_t first, std::size_t end) const;
    void keep_way(std::uint32_t point, Pulses4& pulses) const;
    bool is_cut_on_line(std::uint32_t point) const;
    Pulses4 line_to(std::uint32_t point) const;
    std::int64_t line_done(std::uint32_t point) const;
    Pulses4 cut_at(std::size_t end, std::uint32_t point) const;
    void add_piece(std::size_t first, std::size_t end, const Pulses4& to, std::uint32_t point);

    const MachineLimits& limits_;
    std::span<const PathPoint> points_;
    std::vector<PathPiece>& pieces_;
    Pulses4 at_pulses_;
    std::uint32_t last_point_;
    Lanes bits_begin_;
    std::vector<Bit> bits_;  ///< since the last point
    const PathCell* cell_ = nullptr;
    Lanes cell_at_{};
    Timings begin2_{};
    Timings rise2_{};  ///< of the speeds, per u
};

}  // namespace psicarve::plan
