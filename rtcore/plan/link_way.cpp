// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/link_way.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

/// From rest to rest as fast as an axis may.
class RestToRest {
public:
    RestToRest(std::int64_t pulses, double speed_pps, double accel_pps2)
        : way_(static_cast<double>(pulses)), accel_(accel_pps2) {
        const double length = std::abs(way_);
        speed_ = std::min(speed_pps, std::sqrt(length * accel_));
        rise_s_ = speed_ / accel_;
        seconds_ = length > 0.0 ? rise_s_ + length / speed_ : 0.0;
    }

    double seconds() const noexcept { return seconds_; }
    /// Pulses from where it began.
    double at(double after_s) const noexcept {
        if (after_s <= 0.0) return 0.0;
        if (after_s >= seconds_) return way_;
        const double length = std::abs(way_);
        const double left_s = seconds_ - after_s;
        double gone = speed_ * (after_s - 0.5 * rise_s_);
        if (after_s < rise_s_) gone = 0.5 * accel_ * after_s * after_s;
        if (left_s < rise_s_) gone = length - 0.5 * accel_ * left_s * left_s;
        return way_ < 0.0 ? -gone : gone;
    }

private:
    double way_;
    double accel_;
    double speed_ = 0.0;
    double rise_s_ = 0.0;
    double seconds_ = 0.0;
};

RestToRest move_of(const MachineLimits& limits, std::size_t axis, std::int64_t pulses) {
    const AxisMotion& motion = limits.axes[axis];
    return {pulses, std::min(motion.speed_pps, limits.feed_mm_s * motion.pulses_per_unit), motion.accel_pps2};
}

/// Where all axes are at each instant of it.
class LinkWay {
public:
    LinkWay(const MachineLimits& limits, const PathPoint& from, const PathPoint& to)
        : from_(from),
          heads_{move_of(limits, 0, to.pulses[0] - from.pulses[0]),
                 move_of(limits, 1, to.pulses[1] - from.pulses[1])},
          rise_(move_of(limits, kY, to.pulses[kY] - from.pulses[kY])) {
        from_.layer = to.layer;
        from_.is_on_the_way = true;
        middle_s_ = end_s_ = 0.5 * rise_.seconds();
        double after_s = middle_s_;
        for (std::size_t head = 0; head < kHeads; ++head) {
            is_outward_[head] = to.pulses[head] > from.pulses[head];
            moves_out_ = moves_out_ || is_outward_[head];
            moves_in_ = moves_in_ || to.pulses[head] < from.pulses[head];
            double& longest_s = is_outward_[head] ? middle_s_ : after_s;
            longest_s = std::max(longest_s, heads_[head].seconds());
        }
        end_s_ = middle_s_ + after_s;
        rise_pulses_ = to.pulses[kY] - from.pulses[kY];
    }

    double middle_s() const noexcept { return middle_s_; }
    double end_s() const noexcept { return end_s_; }
    bool moves_out() const noexcept { return moves_out_; }
    bool moves_in() const noexcept { return moves_in_; }

    /// Before or after Y is half-way up.
    PathPoint at(double time_s, bool is_before) const {
        PathPoint point = from_;
        for (std::size_t head = 0; head < kHeads; ++head) {
            const double begin_s = is_outward_[head] ? 0.0 : middle_s_;
            point.pulses[head] += round_to_pulse(heads_[head].at(time_s - begin_s));
        }
        const std::int64_t risen = round_to_pulse(rise_.at(time_s - (middle_s_ - 0.5 * rise_.seconds())));
        // A pulse lies between the two halves.
        const std::int64_t way = std::abs(rise_pulses_ / 2);
        const std::int64_t gone =
            is_before ? std::min(std::abs(risen), way) : std::max(std::abs(risen), way + 1);
        point.pulses[kY] += rise_pulses_ < 0 ? -gone : gone;
        return point;
    }

private:
    PathPoint from_;
    std::array<RestToRest, kHeads> heads_;
    RestToRest rise_;
    std::array<bool, kHeads> is_outward_{};
    bool moves_out_ = false;
    bool moves_in_ = false;
    double middle_s_ = 0.0;
    double end_s_ = 0.0;
    std::int64_t rise_pulses_ = 0;
};

}  // namespace

void add_link_way(const MachineLimits& limits, const PathPoint& from, const PathPoint& to, int parts,
                  std::vector<PathPoint>& points) {
    const LinkWay way(limits, from, to);
    const auto add = [&](const PathPoint& point) {
        if (point.pulses != points.back().pulses && point.pulses != to.pulses) points.push_back(point);
    };
    const double rest_s = way.end_s() - way.middle_s();
    for (int i = 1; way.moves_out() && i <= parts; ++i) add(way.at(way.middle_s() * i / parts, true));
    for (int i = 0; way.moves_in() && i < parts; ++i) add(way.at(way.middle_s() + rest_s * i / parts, false));
}

}  // namespace psicarve::plan
