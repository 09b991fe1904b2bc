// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/profile/profile.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve {
namespace {

constexpr double kSameBlank_mm = 1e-6;

bool are_other(double a_mm, double b_mm) noexcept {
    return std::abs(a_mm - b_mm) > kSameBlank_mm;
}

}  // namespace

double BlankProfile::reach_mm() const noexcept {
    if (!(radius_mm > 0.0)) return 0.0;
    return radius_mm + std::sqrt(offset_x_mm * offset_x_mm + offset_z_mm * offset_z_mm);
}

double BlankProfile::surface_mm(double direction_rad) const noexcept {
    if (offset_x_mm == 0.0 && offset_z_mm == 0.0) return radius_mm;
    const double cosine = std::cos(direction_rad);
    const double sine = std::sin(direction_rad);
    const double along_mm = offset_x_mm * cosine + offset_z_mm * sine;
    const double across_mm = offset_z_mm * cosine - offset_x_mm * sine;
    const double rest = radius_mm * radius_mm - across_mm * across_mm;
    return rest > 0.0 ? std::max(0.0, along_mm + std::sqrt(rest)) : 0.0;
}

std::optional<BlankDifference> blank_difference(const BlankProfile& job, const BlankProfile& machine) {
    if (!(job.radius_mm > 0.0 && machine.radius_mm > 0.0)) return std::nullopt;
    const double apart_x_mm = machine.offset_x_mm - job.offset_x_mm;
    const double apart_z_mm = machine.offset_z_mm - job.offset_z_mm;
    const double apart_mm = std::sqrt(apart_x_mm * apart_x_mm + apart_z_mm * apart_z_mm);
    const bool know_heights = job.height_mm > 0.0 && machine.height_mm > 0.0;
    const bool is_wider = apart_mm + machine.radius_mm > job.radius_mm + kSameBlank_mm;
    const bool is_higher = know_heights && machine.height_mm > job.height_mm + kSameBlank_mm;
    const bool is_in_the_way = is_wider || is_higher;
    using In = BlankDifference::In;
    const BlankDifference height{In::height, job.height_mm, machine.height_mm, is_in_the_way};
    // Report first what is in the way.
    if (is_higher && !is_wider) return height;
    if (are_other(job.radius_mm, machine.radius_mm))
        return BlankDifference{In::radius, job.radius_mm, machine.radius_mm, is_in_the_way};
    if (apart_mm > kSameBlank_mm) return BlankDifference{In::place, 0.0, apart_mm, is_in_the_way};
    if (know_heights && are_other(job.height_mm, machine.height_mm)) return height;
    return std::nullopt;
}

Message blank_difference_message(const BlankDifference& difference) noexcept {
    using In = BlankDifference::In;
    const Argument job = mm_argument(difference.job_mm);
    const Argument machine = mm_argument(difference.machine_mm);
    if (difference.in == In::place) {
        return difference.is_in_the_way ? message_of(MessageId::blank_beside_in_the_way, machine)
                                        : message_of(MessageId::blank_beside, machine);
    }
    if (difference.in == In::radius) {
        return difference.is_in_the_way ? message_of(MessageId::blank_radius_in_the_way, job, machine)
                                        : message_of(MessageId::blank_radius_differs, job, machine);
    }
    return difference.is_in_the_way ? message_of(MessageId::blank_height_in_the_way, job, machine)
                                    : message_of(MessageId::blank_height_differs, job, machine);
}

std::string blank_difference_text(const BlankDifference& difference) {
    return in_words(blank_difference_message(difference));
}

Result<void> check_heads_clear(const BlankProfile& blank, const Profile& machine) {
    for (const Axis axis : {Axis::r1, Axis::r2}) {
        const LinearAxisProfile& head = axis == Axis::r1 ? machine.r1 : machine.r2;
        const double most_mm =
            mm_from_pulses(axis_motion(machine, axis).travel_max_pulses, head.pulses_per_mm) + head.tip_mm();
        if (blank.reach_mm() <= most_mm + kSameBlank_mm) continue;
        return error_from(ErrorCode::bad_input,
                          message_of(MessageId::blank_too_wide, mm_argument(blank.reach_mm()),
                                     argument_of(axis), mm_argument(most_mm)));
    }
    return {};
}

}  // namespace psicarve
