// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/angle_planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "rtcore/plan/speed_drift.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

std::int64_t capacity_of(const TableLine& line) {
    std::int64_t capacity = 0;
    for (const std::int64_t delta : line.delta_pulses) capacity = std::max(capacity, std::abs(delta));
    return capacity;
}

struct Direction {
    double x_mm;
    double y_mm;
};

Direction direction(const MachineLimits& limits, const TableLine& line, std::size_t head) {
    return {line.radius_mm[head] * rad_from_pulses(line.delta_pulses[kPsi], limits.pulses_per_rev),
            static_cast<double>(line.delta_pulses[head]) / limits.axes[head].pulses_per_unit};
}

/// The fastest iterations at which no head that may touch something moves faster over the surface than the
/// feed.
double feed_limit_per_s(const MachineLimits& limits, const TableLine& line, double capacity) {
    double least = limits.max_iterations_per_s;
    for (std::size_t head = 0; head < kHeads; ++head) {
        if (line.is_outside[head]) continue;
        const Direction way = direction(limits, line, head);
        const double length_mm = std::sqrt(way.x_mm * way.x_mm + way.y_mm * way.y_mm);
        if (length_mm > 0.0) least = std::min(least, limits.feed_mm_s * capacity / length_mm);
    }
    return least;
}

/// The fastest iterations at which no axis jumps by more than its start-stop speed between two lines.
double joint_limit_per_s(const MachineLimits& limits, const TableLine& before, const TableLine& after) {
    double least = limits.max_iterations_per_s;
    const auto capacity_before = static_cast<double>(capacity_of(before));
    const auto capacity_after = static_cast<double>(capacity_of(after));
    if (capacity_before == 0.0 || capacity_after == 0.0) return least;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double jump = std::fabs(static_cast<double>(before.delta_pulses[k]) / capacity_before -
                                      static_cast<double>(after.delta_pulses[k]) / capacity_after);
        if (jump > 0.0) least = std::min(least, limits.axes[k].start_stop_pps / jump);
    }
    return least;
}

/// One acceleration segment while it grows.
class GroupBuilder {
public:
    GroupBuilder(const MachineLimits& limits, std::size_t first)
        : limits_(&limits),
          group_{first, 0, GroupLimits{limits.max_iterations_per_s, limits.max_iterations_per_s, 0.0}, 0} {}

    void add(const TableLine& line) {
        ++group_.count;
        const std::int64_t capacity = capacity_of(line);
        if (capacity == 0) return;
        GroupLimits& group = group_.limits;
        const GroupLimits own = line_limits(*limits_, line.delta_pulses);
        group.max_per_s = std::min({group.max_per_s, own.max_per_s,
                                    feed_limit_per_s(*limits_, line, static_cast<double>(capacity))});
        group.start_per_s = std::min(group.start_per_s, own.start_per_s);
        group.accel_per_s2 =
            group_.iterations == 0 ? own.accel_per_s2 : std::min(group.accel_per_s2, own.accel_per_s2);
        group_.iterations += static_cast<std::uint64_t>(capacity);
    }
    void limit_speed(double max_per_s) {
        group_.limits.max_per_s = std::min(group_.limits.max_per_s, max_per_s);
    }
    LineGroup finish() {
        group_.limits.start_per_s = std::min(group_.limits.start_per_s, group_.limits.max_per_s);
        return group_;
    }

private:
    const MachineLimits* limits_;
    LineGroup group_;
};

/// Where an axis that has backlash turns round, or moves for the first time: there its gap is taken up, at
/// rest.
class Reversals {
public:
    explicit Reversals(const MachineLimits& limits) : limits_(&limits) {}

    bool at(const TableLine& line) {
        bool reverses = false;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const std::int64_t delta = line.delta_pulses[k];
            if (delta == 0 || limits_->axes[k].backlash_pulses == 0) continue;
            const int direction = delta > 0 ? 1 : -1;
            reverses = reverses || direction != last_[k];
            last_[k] = direction;
        }
        return reverses;
    }

private:
    const MachineLimits* limits_;
    std::array<int, kAxisCount> last_{};
};

/// Lines [first, end), whatever corners there are.
LineGroup group_of(const MachineLimits& limits, std::span<const TableLine> lines, std::size_t first,
                   std::size_t end) {
    GroupBuilder builder(limits, first);
    for (std::size_t i = first; i < end; ++i) {
        if (i > first) builder.limit_speed(joint_limit_per_s(limits, lines[i - 1], lines[i]));
        builder.add(lines[i]);
    }
    LineGroup group = builder.finish();
    GroupLimits& speed = group.limits;
    speed.max_per_s = std::min(speed.max_per_s, drift_limit_per_s(limits, lines.subspan(first, end - first)));
    speed.start_per_s = std::min(speed.start_per_s, speed.max_per_s);
    return group;
}

/// Appends lines [first, end) as one group, or cut wherever a head goes outside or comes back, whichever is
/// sooner.
void add_groups(const MachineLimits& limits, std::span<const TableLine> lines, std::size_t first,
                std::size_t end, std::vector<LineGroup>& groups) {
    const LineGroup whole = group_of(limits, lines, first, end);
    const std::size_t before = groups.size();
    double parts_s = 0.0;
    for (std::size_t begin = first, i = first + 1; i <= end; ++i) {
        if (i < end && lines[i].is_outside == lines[i - 1].is_outside) continue;
        if (begin == first && i == end) break;
        groups.push_back(group_of(limits, lines, begin, i));
        parts_s += group_seconds(groups.back().limits, groups.back().iterations);
        begin = i;
    }
    if (groups.size() > before && parts_s < group_seconds(whole.limits, whole.iterations)) return;
    groups.resize(before);
    groups.push_back(whole);
}

}  // namespace

bool is_corner(const MachineLimits& limits, const TableLine& before, const TableLine& after,
               std::size_t head) {
    Direction a = direction(limits, before, head);
    Direction b = direction(limits, after, head);
    // Seen along the way, whichever way the table turns: x forwards.
    if (a.x_mm < 0.0 || (a.x_mm == 0.0 && b.x_mm < 0.0)) {
        a.x_mm = -a.x_mm;
        b.x_mm = -b.x_mm;
    }
    const double turn = a.x_mm * b.y_mm - a.y_mm * b.x_mm;
    // The middle point moves half a pulse one way, its neighbours the other: each dR changes by a whole one.
    const double pulse_mm = (turn > 0.0 ? 1.0 : -1.0) / limits.axes[head].pulses_per_unit;
    a.y_mm += pulse_mm;
    b.y_mm -= pulse_mm;
    const double least_turn = a.x_mm * b.y_mm - a.y_mm * b.x_mm;
    if (turn == 0.0 || (least_turn > 0.0) != (turn > 0.0)) return a.x_mm * b.x_mm + a.y_mm * b.y_mm < 0.0;
    const double along = a.x_mm * b.x_mm + a.y_mm * b.y_mm;
    // angle >= corner  <=>  sin(angle - corner) >= 0, both below a half turn.
    return std::fabs(least_turn) * limits.cos_corner - along * limits.sin_corner >= 0.0;
}

std::vector<LineGroup> plan_by_angle(const MachineLimits& limits, std::span<const TableLine> lines) {
    std::vector<LineGroup> groups;
    if (lines.empty()) return groups;
    Reversals reversals(limits);
    reversals.at(lines[0]);
    std::size_t first = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const bool reverses = reversals.at(lines[i]);
        if (!reverses && !is_corner(limits, lines[i - 1], lines[i], 0) &&
            !is_corner(limits, lines[i - 1], lines[i], 1))
            continue;
        add_groups(limits, lines, first, i, groups);
        first = i;
    }
    add_groups(limits, lines, first, lines.size(), groups);
    return groups;
}

}  // namespace psicarve::plan
