// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "hmi/verify/path_rule.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// Stands before rule 1 and hides from it the lift that a hold makes on a machine that lifts its heads then:
/// after a rest both heads go outwards together, table and Y still, come back to the very pulse, and rest
/// again, or where a stop ended that, are still outside when the spindle stops. Slow carving over a crest
/// looks the same: so the filter hides only motion that rule 1 would object to, and hands on unchanged
/// whatever is not exactly such a lift.
class LiftFilter {
public:
    /// On a machine that does not lift, all is handed on.
    LiftFilter(PathRule& path, const Profile& profile) noexcept;

    void begin(const Positions& positions, bool spindle_on);
    /// As PathRule's, as are the next two.
    void settle(std::int64_t time_ns, const Positions& positions, bool spindle_on);
    void redefine(std::int64_t time_ns, const Positions& positions);
    void finish(std::int64_t time_ns);

private:
    struct Instant {
        std::int64_t time_ns;
        Positions positions;
        bool spindle_on;
    };
    bool goes_on_with_lift(const Instant& instant) const noexcept;
    bool is_back() const noexcept { return held_.back().positions == base_.positions; }
    bool went_together() const noexcept;
    bool ends_within_lift(const Instant& instant);
    bool is_objected_to();
    void take(const Instant& instant);
    void look_again(const Instant& instant);
    void hand_on();

    /// How a head lifts, in pulses.
    struct Head {
        std::int64_t lift = 0;
        std::int64_t travel_max = 0;
        std::int64_t backlash = 0;
    };

    PathRule& path_;
    bool lifts_;
    std::array<Head, kHeadCount> heads_;
    Instant last_{};
    Instant base_{};             ///< where the outward motion began
    std::vector<Instant> held_;  ///< since then: not known yet whether it is a lift
    std::deque<Instant> waiting_;
};

}  // namespace psicarve::verify
