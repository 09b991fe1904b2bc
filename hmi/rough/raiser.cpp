// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/rough/raiser.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::rough {
namespace {

constexpr double kSpeedShare = 0.9;
constexpr double kRiseAccelShare = 0.7;
constexpr double kLeastGain_s = 0.05;

/// A motion from rest to rest over a way, at the limits of speed and acceleration.
class Rise {
public:
    Rise(double way_mm, double speed_mm_s, double accel_mm_s2)
        : way_mm_(way_mm),
          speed_mm_s_(std::min(speed_mm_s, std::sqrt(way_mm * accel_mm_s2))),
          accel_mm_s2_(accel_mm_s2) {}

    double seconds() const { return way_mm_ > 0.0 ? way_mm_ / speed_mm_s_ + ramp_s() : 0.0; }
    double after_mm(double time_s) const {
        if (time_s >= seconds()) return way_mm_;
        const double left_s = seconds() - time_s;
        if (time_s <= ramp_s()) return 0.5 * accel_mm_s2_ * time_s * time_s;
        if (left_s <= ramp_s()) return way_mm_ - 0.5 * accel_mm_s2_ * left_s * left_s;
        return speed_mm_s_ * (time_s - 0.5 * ramp_s());
    }

private:
    double ramp_s() const { return speed_mm_s_ / accel_mm_s2_; }

    double way_mm_;
    double speed_mm_s_;
    double accel_mm_s2_;
};

}  // namespace

Raiser::Raiser(const Rings& rings, const Profile& profile, double feed_mm_s, double known_blank_mm)
    : rings_(rings),
      outside_(heads_outside(known_blank_mm, outside_rule(profile))),
      motion_{axis_motion(profile, Axis::r1), axis_motion(profile, Axis::r2)},
      line_rad_(rings.direction_rad(1)),
      feed_mm_s_(feed_mm_s),
      stops_at_changes_(profile.job.planner == Planner::angle) {
    const AxisMotion psi = axis_motion(profile, Axis::psi);
    const double pulse_rad = rad_from_pulses(1, profile.psi.pulses_per_rev);
    speed_rad_s_ = psi.speed_pps * pulse_rad;
    start_stop_rad_s_ = psi.start_stop_pps * pulse_rad;
    accel_rad_s2_ = psi.accel_pps2 * pulse_rad;
    for (std::size_t h = 0; h < kHeads; ++h) {
        if (outside_.from_pulses[h] > rings.head(h).travel) outside_.from_pulses[h] = HeadsOutside::kNever;
    }
}

double Raiser::raise(ByPoint<std::int32_t>& radii, const ByPoint<char>& cuts) const {
    const double before_s = seconds(radii);
    double least_s = before_s;
    for (const Run& run : runs(cuts)) {
        ByPoint<std::int32_t> raised = radii;
        bool is_lifted = true;
        for (std::size_t h = 0; h < kHeads; ++h)
            is_lifted = is_lifted && (!run.of_head[h] || lift(raised[h], h, run));
        if (!is_lifted) continue;
        const double raised_s = seconds(raised);
        if (raised_s > least_s - kLeastGain_s) continue;
        least_s = raised_s;
        radii = std::move(raised);
    }
    return before_s - least_s;
}

// First where both are clear, then for each head alone.
std::vector<Raiser::Run> Raiser::runs(const ByPoint<char>& cuts) const {
    std::vector<Run> found;
    const auto add = [&](bool of_left, bool of_right) {
        const auto is_clear = [&](std::size_t point) {
            return !(of_left && cuts[0][point] != 0) && !(of_right && cuts[1][point] != 0);
        };
        const std::size_t points = cuts[0].size();
        for (std::size_t first = 0; first < points;) {
            std::size_t end = first;
            while (end < points && is_clear(end)) ++end;
            if (end > first) found.push_back({first, end, {{of_left, of_right}}});
            first = end + 1;
        }
    };
    add(true, true);
    add(true, false);
    add(false, true);
    return found;
}

// False where the head does not get out within the run, or not at all.
bool Raiser::lift(std::vector<std::int32_t>& radii, std::size_t head, const Run& run) const {
    if (outside_.from_pulses[head] == HeadsOutside::kNever) return false;
    const RoughHead& scale = rings_.head(head);
    const auto out = static_cast<std::int32_t>(outside_.from_pulses[head]);
    const auto rise_from = [&](std::int32_t radius) {
        return Rise(std::max(0, out - radius) / scale.pulses_per_mm,
                    kSpeedShare * motion_[head].speed_pps / motion_[head].pulses_per_unit,
                    kRiseAccelShare * motion_[head].accel_pps2 / motion_[head].pulses_per_unit);
    };
    // How long a line takes at the feed, or as fast as the table turns.
    const auto line_seconds = [&](std::int32_t radius) {
        const double radius_mm = std::max(0.0, scale.real_mm(radius));
        return line_rad_ * std::max(radius_mm / feed_mm_s_, 1.0 / speed_rad_s_);
    };
    const std::size_t last = run.end - 1;
    const std::int32_t begin = radii[run.first];
    const std::int32_t end = radii[last];
    const Rise up = rise_from(begin);
    const Rise down = rise_from(end);
    const double up_lines = std::ceil(up.seconds() / line_seconds(begin));
    const double down_lines = std::ceil(down.seconds() / line_seconds(end));
    if (up_lines + down_lines + 1.0 > static_cast<double>(last - run.first)) return false;
    for (std::size_t point = run.first + 1; point < last; ++point) {
        const auto from = static_cast<double>(point - run.first);
        const auto to = static_cast<double>(last - point);
        double radius = out;
        if (from < up_lines)
            radius = begin + std::ceil(up.after_mm(from * line_seconds(begin)) * scale.pulses_per_mm);
        if (to < down_lines)
            radius = end + std::ceil(down.after_mm(to * line_seconds(end)) * scale.pulses_per_mm);
        // By rounding the last step of a rise may be a pulse too much.
        radii[point] = std::max(radii[point], std::min(out, static_cast<std::int32_t>(radius)));
    }
    return true;
}

double Raiser::line_speed(const ByPoint<std::int32_t>& radii, std::size_t line) const {
    double speed_rad_s = speed_rad_s_;
    for (std::size_t h = 0; h < kHeads; ++h) {
        const std::int32_t from = radii[h][line];
        const std::int32_t to = radii[h][line + 1];
        const double way_pulses = std::abs(static_cast<double>(to) - from);
        if (way_pulses > 0.0)
            speed_rad_s = std::min(speed_rad_s, line_rad_ * motion_[h].speed_pps / way_pulses);
        if (outside_.holds(h, from, to)) continue;
        const RoughHead& head = rings_.head(h);
        const double arc_mm = std::max(0.0, head.real_mm(std::max(from, to))) * line_rad_;
        const double length_mm = std::hypot(arc_mm, way_pulses / head.pulses_per_mm);
        if (length_mm > 0.0) speed_rad_s = std::min(speed_rad_s, line_rad_ * feed_mm_s_ / length_mm);
    }
    return speed_rad_s;
}

bool Raiser::changes_outside(const ByPoint<std::int32_t>& radii, std::size_t point) const {
    for (std::size_t h = 0; h < kHeads; ++h) {
        if (outside_.holds(h, radii[h][point - 1], radii[h][point]) !=
            outside_.holds(h, radii[h][point], radii[h][point + 1]))
            return true;
    }
    return false;
}

double Raiser::seconds(const ByPoint<std::int32_t>& radii) const {
    const std::size_t lines = radii[0].size() - 1;
    std::vector<double> speed2(lines + 1, 0.0);
    double before = line_speed(radii, 0);
    for (std::size_t point = 1; point < lines; ++point) {
        const double after = line_speed(radii, point);
        double speed = std::min(before, after);
        if (stops_at_changes_ && changes_outside(radii, point)) speed = std::min(speed, start_stop_rad_s_);
        speed2[point] = speed * speed;
        before = after;
    }
    const double gain2 = 2.0 * accel_rad_s2_ * line_rad_;
    for (std::size_t point = 1; point <= lines; ++point)
        speed2[point] = std::min(speed2[point], speed2[point - 1] + gain2);
    double sum_s = 0.0;
    for (std::size_t point = lines; point-- > 0;) {
        speed2[point] = std::min(speed2[point], speed2[point + 1] + gain2);
        const double both = std::sqrt(speed2[point]) + std::sqrt(speed2[point + 1]);
        // A layer of one line from rest to rest.
        sum_s += both > 0.0 ? 2.0 * line_rad_ / both : 2.0 * std::sqrt(line_rad_ / accel_rad_s2_);
    }
    return sum_s;
}

}  // namespace psicarve::rough
