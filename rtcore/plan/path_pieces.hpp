// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/path.hpp"
#include "rtcore/plan/speed_profile.hpp"
#include "rtcore/plan/wide.hpp"

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
    std::uint32_t point;  ///< index of the path point it reaches, or passes, or kNoPoint
    std::array<double, 2>
        rest_speed2{};   ///< at its begin and end: of the profile that comes to rest (PathTiming)
    bool rests = false;  ///< a run ends with it, and what comes behind is another
};

/// Into how many bits of equal length a part of a cell is cut, each as good as straight: DDA segments end at
/// such bits' ends alone.
std::size_t bits_in(const PathCell& cell, double length);

/// Cuts a timed curve into DDA segments: one from point to point where a straight line at an even
/// acceleration stays within a quarter of a pulse of the curve at every instant, at twice the feed and on the
/// way to a rest too, more where it does not. Its members: the path it is given, and the line that is being
/// tried.
class PieceMaker {
public:
    PieceMaker(const MachineLimits& limits, std::span<const PathPoint> points, std::uint32_t first_point,
               const Lanes& start, std::vector<PathPiece>& pieces);

    /// Before the first add(): the pieces begin here and not in the first point, which the curve passes.
    void begin_at(const Pulses4& pulses) { at_pulses_ = pulses; }
    /// Where the pieces made so far end.
    const Pulses4& at_pulses() const { return at_pulses_; }

    /// The cell that the next add() is about: where it begins, and the speeds at its ends.
    void begin_cell(const PathCell& cell, const Lanes& at, const Timings& begin2, const Timings& end2,
                    const std::array<double, 2>& rest2 = {});
    /// A part of the cell; `point` is what its end stands on, or kNoPoint. A point ends a segment.
    void add(double from, double to, std::uint32_t point);

private:
    /// A part of a cell that is as good as straight.
    struct Bit {
        Vec end;     ///< position [pulses]
        Vec middle;  ///< where it is after half its time at 100 %
        Vec slope;   ///< greatest |dq/du| [pulses/s]
        Vec bend;
        double length;
        double along;  ///< of u, from the last point to its end
        Timings seconds;
        Timings begin_speed;  ///< du/dt
        Timings end_speed;
        Timings begin_speed2;
        Timings end_speed2;
        std::array<double, 2> rest_speed2;
        double rest_seconds;  ///< by the profile that comes to rest, if there is one
    };
    /// Bits in a row, from one that a segment begins with: how long they take together.
    struct Together {
        Timings seconds;
        double rest_seconds;
        double length;
    };
    // So many bits are tried as one segment before a point's way is cut bit by bit.
    static constexpr std::size_t kMostBitsInALine = 16;

    void add_bit(double from, double to);
    void flush(std::uint32_t point);
    /// Bits as one segment at an even acceleration: where it is after t, as a part of its length, is
    /// t * (speed + t * accel / 2) / length.
    struct Line {
        double speed;
        double half_accel;
        double inverse_length;
        double time_share;  ///< what it takes over what the bits take
    };

    std::size_t longest(std::size_t first);
    bool set_line(std::size_t first, std::size_t end, std::size_t timing, Line& line) const;
    static Line line_of(double length, double speed, double end_speed, double bits_seconds);
    bool set_rest_line(std::size_t first, std::size_t end, Line& line) const;
    bool has_rest() const { return rest_begin2_ > 0.0; }
    bool is_straight(std::size_t first, std::size_t end);
    void keep_way(std::uint32_t point, Pulses4& pulses) const;
    void keep_travel(const Pulses4& from, const Pulses4& to, Pulses4& pulses) const;
    void keep_tips_apart(const Pulses4& from, const Pulses4& to, Pulses4& pulses) const;
    void keep_height(const Pulses4& from, const Pulses4& to, Pulses4& pulses) const;
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
    bool heads_are_coarse_;
    bool rounds_corners_;
    Vec bits_begin_;
    WideVector<Bit> bits_;  ///< since the last point
    std::array<Together, kMostBitsInALine> together_{};
    std::size_t worst_ = 0;  ///< the bit that was off a line when last one was tried
    const PathCell* cell_ = nullptr;
    Lanes cell_at_{};
    Timings begin2_{};
    Timings rise2_{};  ///< of the speeds, per u
    double rest_begin2_ = 0.0;
    double rest_rise2_ = 0.0;
};

}  // namespace psicarve::plan
