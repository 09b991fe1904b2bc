// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/pin_rules.hpp"
#include "hmi/verify/program/way_reader.hpp"
#include "shared/base/units.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// Ways of a program that took longer than their feeds ask for: limits of the axes, or acceleration.
struct LoweredFeed {
    std::uint64_t first_line = 0;
    std::uint64_t last_line = 0;
    double asked_s = 0.0;
    double taken_s = 0.0;

    double lost_s() const noexcept { return taken_s - asked_s; }
    /// By how much the feed was lowered.
    double share() const noexcept { return 1.0 - asked_s / taken_s; }
};
/// No more are kept: those that cost most time.
inline constexpr std::size_t kMostLowered = 20;

/// How long a program moved; what its run took beyond that are rests.
struct ProgramTimes {
    double feed_s = 0.0;   ///< along ways with a feed
    double rapid_s = 0.0;  ///< along the others
};

/// Where the axes were during a program.
struct ProgramBounds {
    Positions least_pulses{};
    Positions most_pulses{};
};

/// Rule 1 of a program: all its ways are gone along, in order, none of their ends is left out, at no place is
/// the path further off than their tolerance and 1.5 pulses of an axis, and no way takes less time than its
/// feed asks for. Ends at rest are reached to the pulse. Both heads are at one place of a way.
///
/// Where ways are shorter than their tolerance a place may be on several of them: the rule follows all that
/// the path may have come to by now.
///
///     way      k         k+1       k+2           a place goes on with each of its ways that it is near to,
///     and may be   yes ----> yes       no            with the next one where it is near the end between
///     both;
///                  end k is near                 where none is left, that is a breach
///
/// A program begins where the trace does, or where homing has last defined the positions. Its members: the
/// window of ways and the place in it, the state of the pins at the last instant, and what is counted for the
/// report; each instant reads and changes some of each.
class ProgramRule : public PositionJudge {
public:
    /// The log outlives the rule.
    ProgramRule(JudgedProgram program, const Profile& profile, OffenceLog& log);

    void begin(const TraceStart& start);
    void settle(std::int64_t time_ns, const Positions& positions, SignalWord levels) override;
    void redefine(std::int64_t time_ns, const Positions& positions) override;
    /// `levels` are the last ones: also where drives that went off settled nothing.
    void finish(std::int64_t time_ns, SignalWord levels);

    const CarvePlace& place() const noexcept { return place_; }
    std::uint64_t ways_done() const noexcept { return ways_done_; }
    /// How far the path was off its ways at most, but for 1.5 pulses.
    double most_off_mm() const noexcept { return most_off_mm_; }
    /// From leaving the program's begin to its end.
    double run_seconds() const noexcept { return seconds_from_ns(last_ns_ - left_ns_); }
    /// The worst first.
    const std::vector<LoweredFeed>& lowered() const noexcept { return lowered_; }
    /// How long ways with a feed took longer than they ask for, all together.
    double lowered_seconds() const noexcept { return lowered_s_; }
    /// How many stretches were lowered, those that are not kept among them.
    std::uint64_t lowered_count() const noexcept { return lowered_count_; }
    const ProgramTimes& times() const noexcept { return times_; }
    const ProgramBounds& bounds() const noexcept { return bounds_; }
    /// Why the program could not be read.
    std::optional<Error> failure() const { return ways_ ? ways_->failure() : std::nullopt; }

private:
    /// A way that the path may be on, or may come to.
    struct Live {
        explicit Live(const WayDemand& what) : demand(what) {}

        WayDemand demand;
        bool is_on = false;
        bool is_waiting = false;                  ///< at rest at its begin: it begins with the next pulse
        bool is_at_end = false;                   ///< to the pulse, where it ends at rest
        bool has_gone_on = false;                 ///< from there, and may have been on it still
        int passes = 0;                           ///< how often it has
        std::int64_t came_ns = 0;                 ///< when the path last came to be on it
        std::optional<std::int64_t> begun_ns;     ///< at the earliest, by work_ns()
        std::int64_t begun_at_ns = 0;             ///< when the path came to its begin then
        std::int64_t ended_ns = 0;                ///< when its end was last passed, or last reached at rest
        std::int64_t done_ns = 0;                 ///< the same by work_ns()
        std::int64_t rested_ns = 0;               ///< there, at the longest
        std::optional<std::int64_t> switched_ns;  ///< the spindle, first, there
        double dwells_s = 0.0;                    ///< that the rest there is for
        /// Shares of it that may have been gone along in rests, as no pulse is due for them.
        double hidden_begin = 0.0;
        double hidden_end = 0.0;
        std::array<double, kHeadCount> share{};  ///< at the most
        std::array<Reach, kHeadCount> reach{};   ///< on an arc
        /// To an end at rest, where the path came nearest to it.
        std::int64_t nearest_pulses = INT64_MAX;  ///< by the axis that was off most
        int nearest_axes = 0;                     ///< how many were off
        Axis nearest_axis = Axis::r1;
    };

    /// Ways that are judged together by their time, for a passage is known to a tolerance.
    struct Stretch {
        std::uint64_t ways = 0;
        std::uint64_t first_line = 0;
        std::int64_t begun_ns = 0;
        double programmed_s = 0.0;  ///< ways without a pulse among them
        double asked_s = 0.0;       ///< without those
        double stepped_s = 0.0;     ///< at their paces along whole pulses
        int passes = 0;             ///< of ends at rest that may have been none
        double hidden_s = 0.0;      ///< that may have been gone along in rests,
        double rests_s = 0.0;       ///< which had so much room for it
        double spent_s = 0.0;       ///< both, up to the last rest within
        double length_mm = 0.0;
        double tolerance_mm = 0.0;
        double slowest_s_per_mm = 0.0;
        double pulse_s = 0.0;  ///< the longest that one takes at the feed
        bool is_from_rest = true;
        bool goes_on = false;  ///< within a drawn way
    };

    void start(const Positions& positions);
    Live* live(std::size_t n);
    /// The time without the rests that the program asks for.
    std::int64_t work_ns(std::int64_t time_ns) const noexcept { return time_ns - rested_ns_; }
    void note_rested(std::int64_t time_ns, bool spindle_on) noexcept;
    bool rests_for_sure(const Positions& at) const noexcept;
    bool is_near_end(const Live& way, const Positions& at) const noexcept;
    void note_hidden(const Positions& at) noexcept;
    double near_share(const Live& way, const Positions& at) const noexcept;
    bool is_all_near(const Live& way, const Positions& at) const noexcept;
    double free_rest_s(const Live& way) const noexcept;
    double free_rest_behind_s(const Live& way) const noexcept;
    void begin_way(Live& way, std::int64_t time_ns);
    void follow(std::int64_t time_ns, const Positions& at, bool is_at_begin = false);
    bool stays_on(Live& way, const Positions& at);
    bool stays_on_line(Live& way, const Positions& at);
    bool stays_on_arc(Live& way, const Positions& at);
    double apart_mm(const Live& way, const Positions& at,
                    const std::array<double, kHeadCount>& shares) const noexcept;
    double apart_on_arc_mm(const Live& way, const Positions& at,
                           const std::array<Reach, kHeadCount>& reach) const noexcept;
    bool note_end(Live& way, std::int64_t time_ns, const Positions& at, bool comes);
    bool note_rest(Live& way, std::int64_t time_ns, const Positions& at, bool comes);
    bool has_come(const Live& way) const noexcept;
    bool may_go_on(const Live& way) const noexcept;
    bool has_missed(const Live& way) const noexcept;
    void leave_behind();
    void note_time(const Live& way);
    void note_kind(const Live& way);
    void judge_time(const Live& last);
    double pulse_seconds(const Live& way) const noexcept;
    double slack_seconds(const Live& last) const noexcept;
    void gather_lowered(const Live& last, double taken_s);
    void note_lowered();
    void judge_end(std::int64_t time_ns);
    void judge_rest(const Live& way, std::int64_t time_ns);
    Offence short_rest(const Live& way) const;
    bool is_too_short(const Live& way, std::int64_t rested_ns) const noexcept;
    bool leaves_too_soon(std::size_t n, std::int64_t time_ns, bool is_on_before);
    const Live* short_rest_at(std::size_t n) const noexcept;
    static void take_back(Live& way, std::int64_t since_ns) noexcept;
    SignalWord wrong_switches(const Live& way, SignalWord levels) const noexcept;
    void judge_switches(std::int64_t time_ns, SignalWord levels);
    void judge_last_switches(std::int64_t time_ns, SignalWord levels, bool is_done);
    Offence wrong_switch(Signal wire, bool is_on, const Live* way) const;
    void breach(std::size_t n, bool was_at_end, std::int64_t time_ns, const Positions& at);
    Offence missed_end(const Live& way) const;
    Offence off_the_way(const Live& way, const Positions& at) const;
    struct Back {
        double mm;
        double allowed_mm;
    };
    std::optional<Back> back_of(const Live& way, std::size_t head, const Positions& at,
                                double share) const noexcept;
    Offence goes_back(Offence offence, double back_mm, double allowed_mm) const;
    Offence heads_apart(Offence offence, double apart_mm) const;
    void find_again(std::int64_t time_ns, const Positions& at);
    void report(std::int64_t time_ns, Offence offence, std::uint64_t line);
    WayTolerance tolerance_of(const Live& way) const noexcept;

    JudgedProgram program_;
    Profile profile_;
    WayScale scale_;
    OffenceLog& log_;
    std::unique_ptr<WayReader> ways_;
    std::deque<Live> window_;  ///< from the first one that the path may be on
    Stretch stretch_;
    CarvePlace place_;
    std::int64_t tick_ns_ = 0;
    Positions start_{};
    std::uint64_t looks_ = 0;  ///< for the path, while it is lost
    enum class Phase : std::uint8_t { waiting, running, lost, over };
    Phase phase_ = Phase::waiting;
    std::int64_t left_ns_ = 0;
    std::int64_t last_ns_ = 0;
    std::int64_t seen_ns_ = 0;    ///< the last instant
    std::int64_t rested_ns_ = 0;  ///< at ends where the program asks for it, until then
    bool is_at_rest_ = false;     ///< since then
    bool was_spindle_on_ = false;
    Positions at_{};                   ///< at the last instant
    bool was_spindle_off_ = false;     ///< since the program's last pulse
    SignalWord present_ = 0;           ///< wires that the trace has
    SignalWord told_switches_ = 0;     ///< that are wrong, and were told
    std::int64_t spun_up_ns_ = 0;      ///< when the spindle was last switched on and had come to its speed
    double rest_before_s_ = INFINITY;  ///< the next stretch, and free for it
    std::uint64_t ways_done_ = 0;
    double most_off_mm_ = 0.0;
    std::optional<LoweredFeed> gathered_;  ///< of a drawn way, whose pieces are one
    std::vector<LoweredFeed> lowered_;
    double lowered_s_ = 0.0;
    std::uint64_t lowered_count_ = 0;
    ProgramTimes times_;
    std::int64_t way_over_ns_ = 0;  ///< the last way that is done
    bool is_way_from_rest_ = true;  ///< the next one
    ProgramBounds bounds_;
};

}  // namespace psicarve::verify
