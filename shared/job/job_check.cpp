// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "shared/base/decimals.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"

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
    std::string text(std::int64_t counted) const {
        return mm_text(real_mm(counted), 4) + " (" + std::to_string(counted) + " pulses)";
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

std::string place(std::uint32_t layer, std::size_t point) {
    return "layer " + std::to_string(layer) + ", point " + std::to_string(point) + ": ";
}

std::string radius_problem(const HeadLimits& head, std::int64_t counted) {
    const std::string radius = "the radius of " + std::string(name_of(head.axis)) + ", " + head.text(counted);
    if (counted < head.core) {
        return radius + ", is inside the core radius of " + head.text(head.core) +
               "; carve less deep, or lower core_radius_mm";
    }
    const bool low = counted < head.least;
    return radius + ", is " + (low ? "below" : "above") + " the travel, which ends at " +
           head.text(low ? head.least : head.most) + "; make the model smaller or widen axis." +
           std::string(name_of(head.axis)) + ".travel_mm";
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
            if (!left_.allows(left[i])) return bad_input(place(layer, i) + radius_problem(left_, left[i]));
            if (!right_.allows(right[i]))
                return bad_input(place(layer, i) + radius_problem(right_, right[i]));
            if (!are_apart(left[i], right[i]))
                return bad_input(place(layer, i) + apart_problem(left[i], right[i]));
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
    std::string apart_problem(std::int32_t left, std::int32_t right) const {
        return "the tips of r1 at " + left_.text(left) + " and r2 at " + right_.text(right) + " are " +
               mm_text(left_.real_mm(left) + right_.real_mm(right), 4) +
               " apart, closer than head_clearance_mm = " + mm_text(clearance_mm_, 4) +
               "; raise core_radius_mm and slice again";
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
        return bad_input("job: a layer sweeps " + std::to_string(job.psi_sweep_pulses()) +
                         " pulses of psi, half a revolution of this machine is " + std::to_string(half_turn) +
                         "; slice the model for this machine's profile");
    }
    if (std::int64_t{job.point_count()} - 1 > half_turn) {
        return bad_input("job: " + std::to_string(job.point_count()) + " points in a layer of " +
                         std::to_string(half_turn) + " pulses of psi; slice with at most " +
                         std::to_string(half_turn + 1) + " points");
    }
    for (const Axis axis : kAllAxes) {
        const int own = axis_motion(profile, axis).positive_is_high ? 1 : -1;
        if (job.header().direction_sign[index_of(axis)] == own) continue;
        return bad_input("job: its direction of axis " + std::string(name_of(axis)) +
                         " is the other way round on this machine (axis." + std::string(name_of(axis)) +
                         ".positive); slice the model for this machine's profile");
    }
    return {};
}

Result<void> check_heights(const JobView& job, const Profile& profile) {
    const AxisMotion y = axis_motion(profile, Axis::y);
    const auto text = [&](std::int64_t height) {
        return mm_text(mm_from_pulses(height, y.pulses_per_unit), 4) + " (" + std::to_string(height) +
               " pulses)";
    };
    const auto heights = job.layer_heights_pulses();
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        const std::int64_t height = heights[layer];
        if (height < y.travel_min_pulses || height > y.travel_max_pulses) {
            return bad_input(place(layer, 0) + "the height of " + text(height) +
                             " lies outside the travel of y, " + text(y.travel_min_pulses) + " to " +
                             text(y.travel_max_pulses) +
                             "; make the model smaller, or change job.base_height_mm");
        }
        if (job.begins_pass(layer)) continue;
        if (job.joining() == Joining::spiral && layer + 1 == job.layer_count()) {
            if (height == heights[layer - 1]) continue;
            return bad_input(place(layer, 0) + "the height of " + text(height) +
                             " is not that of the layer below, " + text(heights[layer - 1]) +
                             ", as it must be in the ring that closes a spiral; slice the model again");
        }
        if (height <= heights[layer - 1]) {
            return bad_input(place(layer, 0) + "the height of " + text(height) +
                             " does not lie above the layer below, " + text(heights[layer - 1]) +
                             "; use fewer layers, so that each is at least a pulse higher");
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
        return bad_input(place(layer, 0) + "the radius of " + std::string(name_of(head)) + ", " +
                         std::to_string(begin) + " pulses, is not the " + std::to_string(end) +
                         " pulses in which the layer below ends: a spiral has no links; slice the model "
                         "again");
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
