// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/motion_request.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "rtcore/cycle/layer_range.hpp"
#include "rtcore/cycle/pin_trial.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/jog_lease.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/machine/recorded_start.hpp"
#include "shared/machine/recording.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::supervisor {
namespace {

using cycle::Request;
using cycle::RequestKind;

constexpr double kMsPerSecond = 1000.0;
constexpr double kLeastTestRate_hz = 1.0;
constexpr double kMostTestRate_hz = 500.0;
constexpr std::uint64_t kMostTestPulses = 10'000;

Error refused(const Message& why) {
    return error_from(ErrorCode::machine_refused, why);
}

/// `too_far`: said where it is further than an axis goes.
Result<std::int64_t> pulses_of(double value, Axis axis, const Profile& profile, const Message& too_far) {
    const double pulses = value * axis_motion(profile, axis).pulses_per_unit;
    if (std::isfinite(pulses) && std::fabs(pulses) <= static_cast<double>(cycle::kFurthestPulses)) {
        return round_to_pulse(pulses);
    }
    return refused(too_far);
}

Message too_far(CommandKind command, Axis axis) {
    return message_of(MessageId::too_far, argument_of(command), argument_of(axis));
}

void add_lease(Request& request, const Command& command, const Profile& profile, bool is_virtual_clock) {
    request.lease_token = command.lease_token;
    if (is_virtual_clock) return;
    const auto longest_ms = static_cast<std::uint32_t>(kLongestJogLease.count());
    const std::int64_t lease_ns = std::int64_t{std::min(command.lease_ms, longest_ms)} * kNsPerMs;
    request.lease_ticks = static_cast<std::uint32_t>(
        std::max<std::int64_t>(1, ticks_covering_ns(lease_ns, tick_period_ns(profile))));
}

Result<void> add_jog(Request& request, const Command& command, const Profile& profile,
                     bool is_virtual_clock) {
    if (command.axis > kBothHeads) return refused(message_of(MessageId::no_jog_axis));
    if (!std::isfinite(command.speed) || command.speed < 0.0)
        return refused(message_of(MessageId::jog_speed_not_positive));
    const bool is_both = command.axis == kBothHeads;
    request.order.axes = static_cast<std::uint8_t>(is_both ? 0b11U : 1U << command.axis);
    request.order.speed_pps = std::numeric_limits<double>::infinity();
    for (const Axis axis : kAllAxes) {
        if ((request.order.axes >> index_of(axis) & 1U) == 0) continue;
        const AxisMotion motion = axis_motion(profile, axis);
        const double speed_pps =
            command.speed > 0.0 ? command.speed * motion.pulses_per_unit : motion.home_speed_pps;
        request.order.speed_pps = std::min(request.order.speed_pps, speed_pps);
        std::int64_t& target_pulses = request.order.target_pulses[index_of(axis)];
        target_pulses = command.value < 0.0 ? -1 : 1;
        if (request.kind != RequestKind::jog) continue;
        const auto way = pulses_of(command.value, axis, profile, too_far(CommandKind::jog, axis));
        if (!way) return way.error();
        target_pulses = *way;
    }
    if (command.lease_token == 0 || command.lease_ms == 0)
        return refused(message_of(MessageId::jog_unleased));
    add_lease(request, command, profile, is_virtual_clock);
    return {};
}

/// An arc is one only where a millimetre is as many pulses on both axes.
Result<void> add_centre(Request& request, const Command& command, const Profile& profile) {
    const bool is_first = (command.axis & 1U) != 0;
    if (command.axis != 0b1001 && command.axis != 0b1010) return refused(message_of(MessageId::arc_axes));
    const Axis head = is_first ? Axis::r1 : Axis::r2;
    const double scale = axis_motion(profile, head).pulses_per_unit;
    if (scale != profile.y.pulses_per_mm) {
        return refused(message_of(MessageId::arc_scales_differ, argument_of(head)));
    }
    std::size_t i = 0;
    for (const Axis axis : {head, Axis::y}) {
        const auto centre = pulses_of(command.centre[index_of(axis)], axis, profile,
                                      message_of(MessageId::centre_too_far, argument_of(axis)));
        if (!centre) return centre.error();
        request.order.centre_pulses[i++] = *centre;
    }
    return {};
}

Result<void> add_shape(Request& request, const Command& command, const Profile& profile) {
    if (command.shape == MoveShape::straight) return {};
    if (command.shape > MoveShape::clockwise) return refused(message_of(MessageId::unknown_shape));
    request.order.shape = static_cast<cycle::OrderShape>(command.shape);
    if (command.shape != MoveShape::stepped) return add_centre(request, command, profile);
    const bool has_psi = (command.axis >> index_of(Axis::psi) & 1U) != 0;
    if (has_psi || std::popcount(command.axis) > 2) {
        return refused(message_of(MessageId::stepped_axes));
    }
    return {};
}

Result<void> add_move(Request& request, const Command& command, const Profile& profile) {
    if (command.axis == 0 || (command.axis >> kAxisCount) != 0)
        return refused(message_of(MessageId::no_move_axis));
    request.order.axes = static_cast<std::uint8_t>(command.axis);
    request.order.drops_turns = 1;
    if (const auto shaped = add_shape(request, command, profile); !shaped) return shaped;
    for (const Axis axis : kAllAxes) {
        const std::size_t k = index_of(axis);
        if ((command.axis >> k & 1U) == 0) continue;
        const auto target = pulses_of(command.target[k], axis, profile, too_far(CommandKind::move, axis));
        if (!target) return target.error();
        request.order.target_pulses[k] = *target;
    }
    return {};
}

static_assert(cycle::packed(cycle::LayerRange{0, 0, true}) == kRecordedDryRun,
              "readers of the flight recorder look there");
static_assert((cycle::packed(cycle::LayerRange{7, 3, true, ~0U}) & kRecordedFirstLayer) == 7,
              "readers of the flight recorder look there");
static_assert(cycle::packed(cycle::LayerRange{0, 0, false, ~0U}) == kRecordedFirstPoint,
              "readers of the flight recorder look there");
constexpr RecordedStart kReadBack =
    recorded_start(cycle::packed(cycle::LayerRange{700'001, 600'001, true, 500'001}));
static_assert(kReadBack.first_layer == 700'001 && kReadBack.layers == 600'001 &&
                  kReadBack.point_number == 500'001 && kReadBack.is_dry,
              "readers of the flight recorder read it so");
static_assert(cycle::kMostOfRange > kMaxJobCount);

Result<void> add_layers(Request& request, const Command& command) {
    const bool is_layer = command.value >= 0.0 && command.value < kMaxJobCount;
    const std::uint32_t first = is_layer ? static_cast<std::uint32_t>(command.value) : 0;
    if (!is_layer || static_cast<double>(first) != command.value)
        return refused(message_of(MessageId::layers_not_whole));
    const std::uint32_t count = start_layers(command);
    if (count > kMaxJobCount) return refused(message_of(MessageId::no_such_first_layer));
    // A point that no layer has: the tick refuses it, as it does those that this job's layers have not.
    const std::uint32_t point_number = std::min(start_point_number(command), cycle::kMostOfRange);
    request.value =
        cycle::packed(cycle::LayerRange{first, count, (command.axis & kStartsDry) != 0, point_number});
    return {};
}

Result<void> add_recording(Request& request, const Command& command) {
    const bool is_known = command.value >= 0.0 && command.value < kRecordingFormCount;
    if (!is_known || command.lease_token == 0) return refused(message_of(MessageId::no_recording_form));
    request.value = static_cast<std::uint64_t>(command.value);
    request.lease_token = command.lease_token;
    return {};
}

Result<void> add_pin_trial(Request& request, const Command& command, const Profile& profile,
                           bool is_virtual_clock) {
    if (command.axis >= kSignalCount || !is_output(static_cast<Signal>(command.axis)))
        return refused(message_of(MessageId::no_such_output));
    if (profile.port.pins[command.axis] == 0) {
        const auto signal = static_cast<Signal>(command.axis);
        return refused(message_of(MessageId::output_not_wired, argument_of(signal)));
    }
    const bool is_end = command.value == 0.0;
    if (command.lease_token == 0 || (command.lease_ms == 0 && !is_end))
        return refused(message_of(MessageId::pins_unleased));
    cycle::PinOrder order;
    order.signal = static_cast<std::uint8_t>(command.axis);
    order.is_on = !is_end;
    if (command.value2 != 0) {
        const bool is_rate = command.speed >= kLeastTestRate_hz && command.speed <= kMostTestRate_hz;
        if (!is_rate || command.value2 > kMostTestPulses)
            return refused(message_of(MessageId::pins_pulse_bounds));
        order.pulses = static_cast<std::uint32_t>(command.value2);
        order.half_ms = static_cast<std::uint32_t>(kMsPerSecond / 2.0 / command.speed);
    }
    request.value = cycle::packed(order);
    add_lease(request, command, profile, is_virtual_clock);
    return {};
}

/// What is no whole number of per cent becomes 0, which the tick refuses.
std::uint64_t percent_of(double value) {
    const bool is_in_range = value >= kLeastOverride_percent && value <= kMostOverride_percent;
    const auto percent = is_in_range ? static_cast<std::uint64_t>(value) : 0;
    return static_cast<double>(percent) == value ? percent : 0;
}

}  // namespace

Result<Request> motion_request(const Command& command, RequestKind kind, const Profile& profile,
                               bool is_virtual_clock) {
    Request request{};
    request.kind = kind;
    request.axis = static_cast<std::uint8_t>(command.axis);
    Result<void> added{};
    if (kind == RequestKind::jog || kind == RequestKind::jog_on) {
        added = add_jog(request, command, profile, is_virtual_clock);
    } else if (kind == RequestKind::move) {
        added = add_move(request, command, profile);
    } else if (kind == RequestKind::test_pin) {
        added = add_pin_trial(request, command, profile, is_virtual_clock);
    } else if (kind == RequestKind::home) {
        request.value = command.axis & ((1U << kAxisCount) - 1U);
    } else if (kind == RequestKind::start) {
        added = add_layers(request, command);
    } else if (kind == RequestKind::spindle || kind == RequestKind::single ||
               kind == RequestKind::optional_stop) {
        request.value = command.value != 0.0 ? 1 : 0;
    } else if (kind == RequestKind::override || kind == RequestKind::rapid_override) {
        request.value = percent_of(command.value);
    } else if (kind == RequestKind::run_program) {
        request.value = command.value2;
        request.axis = command.axis & (kProgramIsSingle | kProgramStopsAtOptional);
    } else if (kind == RequestKind::record) {
        added = add_recording(request, command);
    }
    if (!added) return added.error();
    return request;
}

Message speed_remark(const Command& command, const Profile& profile) {
    if (command.kind != CommandKind::jog && command.kind != CommandKind::jog_on) return {};
    const bool is_both = command.axis == kBothHeads;
    for (const Axis axis : kAllAxes) {
        const bool is_moved = is_both ? axis == Axis::r1 || axis == Axis::r2 : command.axis == index_of(axis);
        if (!is_moved) continue;
        const AxisMotion motion = axis_motion(profile, axis);
        // In pulses, as it is obeyed; divided, the limit itself may come out a little lower than it is.
        constexpr double kRounding = 1e-9;
        if (command.speed * motion.pulses_per_unit <= motion.speed_pps * (1.0 + kRounding)) continue;
        const double most = motion.speed_pps / motion.pulses_per_unit;
        if (axis == Axis::psi)
            return message_of(MessageId::speed_limited_turning, argument_of(axis), deg_s_argument(most));
        return message_of(MessageId::speed_limited, argument_of(axis), mm_s_argument(most));
    }
    return {};
}

}  // namespace psicarve::supervisor
