// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve {
namespace {

/// One head as its table uses it: counted positions, the tip's offset away from the real radius.
struct HeadLimits {
    Axis axis;
    double pulses_per_mm;
    double tip_offset_mm;
    std::int64_t least;  ///< pulses, counted
    std::int64_t core;
    std::int64_t most;

    double real_mm(std::int64_t counted) const {
        return mm_from_pulses(counted, pulses_per_mm) + tip_offset_mm;
    }
    bool allows(std::int64_t counted) const noexcept { return counted >= least && counted <= most; }
};

HeadLimits limits_of(const Profile& profile, Axis axis) {
    const LinearAxisProfile& head = axis == Axis::r2 ? profile.r2 : profile.r1;
    const AxisMotion motion = axis_motion(profile, axis);
    const std::int64_t core = core_radius_pulses(profile, axis);
    return {axis, head.pulses_per_mm,      head.tip_mm(), std::max(motion.travel_min_pulses, core),
            core, motion.travel_max_pulses};
}

Error problem(const Message& message) {
    return error_from(ErrorCode::bad_input, message);
}

Error radius_problem(std::uint32_t layer, std::size_t point, const HeadLimits& head, std::int64_t counted) {
    const auto beyond = [&](Message message, std::int64_t limit) {
        for (const Argument& one : {layer_argument(layer), point_argument(point), argument_of(head.axis),
                                    mm_argument(head.real_mm(counted)), pulses_argument(counted),
                                    mm_argument(head.real_mm(limit)), pulses_argument(limit)})
            message.arguments[message.argument_count++] = one;
        return problem(message);
    };
    if (counted < head.core) return beyond(message_of(MessageId::radius_inside_core), head.core);
    if (counted < head.least) return beyond(message_of(MessageId::radius_below_travel), head.least);
    return beyond(message_of(MessageId::radius_above_travel), head.most);
}

/// Both heads' radii of a layer against the limits and against each other.
class RadiusCheck {
public:
    explicit RadiusCheck(const Profile& profile)
        : left_(limits_of(profile, Axis::r1)),
          right_(limits_of(profile, Axis::r2)),
          left_mm_(1.0 / left_.pulses_per_mm),
          right_mm_(1.0 / right_.pulses_per_mm),
          clearance_mm_(profile.head_clearance_mm),
          // Radii are rounded to pulses: half a pulse of each head is no fault of the table.
          least_sum_mm_(clearance_mm_ - left_.tip_offset_mm - right_.tip_offset_mm -
                        0.5 * (left_mm_ + right_mm_) * (1.0 + 1e-9)) {}

    /// The usual case costs a few passes over rows that stay in the cache, without a branch per point.
    bool layer_is_fine(std::span<const std::int32_t> left,
                       std::span<const std::int32_t> right) const noexcept {
        return row_is_fine(left_, left) && row_is_fine(right_, right) && rows_are_apart(left, right);
    }

    Error first_problem(std::uint32_t layer, std::span<const std::int32_t> left,
                        std::span<const std::int32_t> right) const {
        for (std::size_t i = 0; i < left.size(); ++i) {
            if (!left_.allows(left[i])) return radius_problem(layer, i, left_, left[i]);
            if (!right_.allows(right[i])) return radius_problem(layer, i, right_, right[i]);
            if (!are_apart(left[i], right[i])) return apart_problem(layer, i, left[i], right[i]);
        }
        return bad_input("job: layer " + std::to_string(layer) + " is wrong");
    }

private:
    static bool row_is_fine(const HeadLimits& head, std::span<const std::int32_t> row) noexcept {
        std::int32_t least = row[0];
        std::int32_t most = row[0];
        for (const std::int32_t radius : row) {
            least = std::min(least, radius);
            most = std::max(most, radius);
        }
        return head.allows(least) && head.allows(most);
    }
    bool rows_are_apart(std::span<const std::int32_t> left,
                        std::span<const std::int32_t> right) const noexcept {
        unsigned close = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            close |= static_cast<unsigned>(!are_apart(left[i], right[i]));
        }
        return close == 0;
    }
    bool are_apart(std::int32_t left, std::int32_t right) const noexcept {
        return static_cast<double>(left) * left_mm_ + static_cast<double>(right) * right_mm_ >= least_sum_mm_;
    }
    Error apart_problem(std::uint32_t layer, std::size_t point, std::int32_t left, std::int32_t right) const {
        return problem(message_of(MessageId::tips_too_close, layer_argument(layer), point_argument(point),
                                  mm_argument(left_.real_mm(left)), pulses_argument(left),
                                  mm_argument(right_.real_mm(right)), pulses_argument(right),
                                  mm_argument(left_.real_mm(left) + right_.real_mm(right)),
                                  mm_argument(clearance_mm_)));
    }

    HeadLimits left_;
    HeadLimits right_;
    double left_mm_;
    double right_mm_;
    double clearance_mm_;
    double least_sum_mm_;
};

Result<void> check_turning(const JobView& job, const Profile& profile) {
    const std::int64_t half_turn = profile.psi.pulses_per_rev / 2;
    if (job.psi_sweep_pulses() != half_turn) {
        return problem(message_of(MessageId::sweep_of_other_machine, pulses_argument(job.psi_sweep_pulses()),
                                  pulses_argument(half_turn)));
    }
    if (std::int64_t{job.point_count()} - 1 > half_turn) {
        return problem(message_of(MessageId::more_points_than_pulses, count_argument(job.point_count()),
                                  pulses_argument(half_turn),
                                  count_argument(static_cast<std::uint64_t>(half_turn + 1))));
    }
    for (const Axis axis : kAllAxes) {
        const int own = axis_motion(profile, axis).positive_is_high ? 1 : -1;
        if (job.header().direction_sign[index_of(axis)] == own) continue;
        return problem(message_of(MessageId::direction_reversed, argument_of(axis)));
    }
    return {};
}

Result<void> check_heights(const JobView& job, const Profile& profile) {
    const AxisMotion y = axis_motion(profile, Axis::y);
    const auto mm_of = [&](std::int64_t height) {
        return mm_argument(mm_from_pulses(height, y.pulses_per_unit));
    };
    const Argument first_point = point_argument(0);
    const auto heights = job.layer_heights_pulses();
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        const std::int64_t height = heights[layer];
        if (height < y.travel_min_pulses || height > y.travel_max_pulses) {
            return problem(message_of(MessageId::height_outside_travel, layer_argument(layer), first_point,
                                      mm_of(height), pulses_argument(height), mm_of(y.travel_min_pulses),
                                      pulses_argument(y.travel_min_pulses), mm_of(y.travel_max_pulses),
                                      pulses_argument(y.travel_max_pulses)));
        }
        if (job.begins_pass(layer)) continue;
        const std::int64_t below = heights[layer - 1];
        if (job.joining() == Joining::spiral && layer + 1 == job.layer_count()) {
            if (height == below) continue;
            return problem(message_of(MessageId::ring_not_closed, layer_argument(layer), first_point,
                                      mm_of(height), pulses_argument(height), mm_of(below),
                                      pulses_argument(below)));
        }
        if (height <= below) {
            return problem(message_of(MessageId::layer_not_higher, layer_argument(layer), first_point,
                                      mm_of(height), pulses_argument(height), mm_of(below),
                                      pulses_argument(below)));
        }
    }
    return {};
}

/// Checks that the row ends in the point in which the next one of a spiral begins.
Result<void> check_joint(const JobView& job, std::uint32_t layer) {
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const auto row = [&](std::uint32_t of) {
            return head == Axis::r1 ? job.r_left_pulses(of) : job.r_right_pulses(of);
        };
        const std::int32_t end = row(layer - 1).back();
        const std::int32_t begin = row(layer).front();
        if (begin == end) continue;
        return problem(message_of(MessageId::spiral_not_joined, layer_argument(layer), point_argument(0),
                                  argument_of(head), pulses_argument(begin), pulses_argument(end)));
    }
    return {};
}

}  // namespace

Result<void> check_job(const JobView& job, const Profile& profile) {
    if (auto turning = check_turning(job, profile); !turning) return turning.error();
    if (auto heights = check_heights(job, profile); !heights) return heights.error();
    const RadiusCheck check(profile);
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        const auto left = job.r_left_pulses(layer);
        const auto right = job.r_right_pulses(layer);
        if (!check.layer_is_fine(left, right)) return check.first_problem(layer, left, right);
        if (!job.is_joint(layer, 0)) continue;
        if (auto joint = check_joint(job, layer); !joint) return joint.error();
    }
    return {};
}

}  // namespace psicarve
