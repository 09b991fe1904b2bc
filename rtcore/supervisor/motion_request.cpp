// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/motion_request.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "rtcore/cycle/layer_range.hpp"
#include "rtcore/cycle/pin_trial.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/jog_lease.hpp"
#include "shared/machine/recorded_start.hpp"
#include "shared/machine/recording.hpp"

namespace psicarve::supervisor {
namespace {

using cycle::Request;
using cycle::RequestKind;

constexpr double kMsPerSecond = 1000.0;
constexpr double kLeastTestRate_hz = 1.0;
constexpr double kMostTestRate_hz = 500.0;
constexpr std::uint64_t kMostTestPulses = 10'000;

Error refused(const std::string& reason) {
    return Error{ErrorCode::machine_refused, reason};
}

Result<std::int64_t> pulses_of(double value, Axis axis, const Profile& profile, const char* what) {
    const double pulses = value * axis_motion(profile, axis).pulses_per_unit;
    if (std::isfinite(pulses) && std::fabs(pulses) <= static_cast<double>(cycle::kFurthestPulses)) {
        return round_to_pulse(pulses);
    }
    return refused(std::string{what} + ": no axis goes so far (" + std::string{name_of(axis)} + ")");
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
    if (command.axis > kBothHeads) return refused("jog: no such axis; r1, r2, psi, y or heads");
    if (!std::isfinite(command.speed) || command.speed < 0.0)
        return refused("jog: the speed must be above 0");
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
        const auto way = pulses_of(command.value, axis, profile, "jog");
        if (!way) return way.error();
        target_pulses = *way;
    }
    if (command.lease_token == 0 || command.lease_ms == 0) return refused("jog: nobody holds its lease");
    add_lease(request, command, profile, is_virtual_clock);
    return {};
}

/// An arc is one only where a millimetre is as many pulses on both axes.
Result<void> add_centre(Request& request, const Command& command, const Profile& profile) {
    const bool is_first = (command.axis & 1U) != 0;
    if (command.axis != 0b1001 && command.axis != 0b1010)
        return refused("move: an arc takes r1 and y, or r2 and y");
    const Axis head = is_first ? Axis::r1 : Axis::r2;
    const double scale = axis_motion(profile, head).pulses_per_unit;
    if (scale != profile.y.pulses_per_mm) {
        return refused("move: no arc, " + std::string{name_of(head)} + " and y differ in pulses_per_mm");
    }
    std::size_t i = 0;
    for (const Axis axis : {head, Axis::y}) {
        const auto centre = pulses_of(command.centre[index_of(axis)], axis, profile, "move: the centre");
        if (!centre) return centre.error();
        request.order.centre_pulses[i++] = *centre;
    }
    return {};
}

Result<void> add_shape(Request& request, const Command& command, const Profile& profile) {
    if (command.shape == MoveShape::straight) return {};
    if (command.shape > MoveShape::clockwise)
        return refused("move: unknown shape; is the sender another version?");
    request.order.shape = static_cast<cycle::OrderShape>(command.shape);
    if (command.shape != MoveShape::stepped) return add_centre(request, command, profile);
    const bool has_psi = (command.axis >> index_of(Axis::psi) & 1U) != 0;
    if (has_psi || std::popcount(command.axis) > 2) {
        return refused("move: point by point takes one or two of r1, r2 and y");
    }
    return {};
}

Result<void> add_move(Request& request, const Command& command, const Profile& profile) {
    if (command.axis == 0 || (command.axis >> kAxisCount) != 0) return refused("move: no axis to move");
    request.order.axes = static_cast<std::uint8_t>(command.axis);
    request.order.drops_turns = 1;
    if (const auto shaped = add_shape(request, command, profile); !shaped) return shaped;
    for (const Axis axis : kAllAxes) {
        const std::size_t k = index_of(axis);
        if ((command.axis >> k & 1U) == 0) continue;
        const auto target = pulses_of(command.target[k], axis, profile, "move");
        if (!target) return target.error();
        request.order.target_pulses[k] = *target;
    }
    return {};
}

static_assert(cycle::packed(cycle::LayerRange{0, 0, true}) == kRecordedDryRun,
              "readers of the flight recorder look there");
static_assert((cycle::packed(cycle::LayerRange{7, 3, true}) & kRecordedFirstLayer) == 7,
              "readers of the flight recorder look there");

Result<void> add_layers(Request& request, const Command& command) {
    const bool is_layer = command.value >= 0.0 && command.value < kMaxJobCount;
    const std::uint32_t first = is_layer ? static_cast<std::uint32_t>(command.value) : 0;
    if (!is_layer || static_cast<double>(first) != command.value)
        return refused("start: layers are counted from 0, in whole numbers");
    if (command.value2 > kMaxJobCount) return refused("start: the job has no such layer; the first is 0");
    request.value = cycle::packed(cycle::LayerRange{first, static_cast<std::uint32_t>(command.value2),
                                                    (command.axis & kStartsDry) != 0});
    return {};
}

Result<void> add_recording(Request& request, const Command& command) {
    const bool is_known = command.value >= 0.0 && command.value < kRecordingFormCount;
    if (!is_known || command.lease_token == 0)
        return refused("record: no such form, or nobody to record for");
    request.value = static_cast<std::uint64_t>(command.value);
    request.lease_token = command.lease_token;
    return {};
}

Result<void> add_pin_trial(Request& request, const Command& command, const Profile& profile,
                           bool is_virtual_clock) {
    if (command.axis >= kOutputSignalCount) return refused("pins: no such output");
    const std::string name{name_of(static_cast<Signal>(command.axis))};
    if (profile.port.pins[command.axis] == 0) return refused("pins: " + name + " is not wired to any pin");
    const bool is_end = command.value == 0.0;
    if (command.lease_token == 0 || (command.lease_ms == 0 && !is_end))
        return refused("pins: nobody holds its lease");
    cycle::PinOrder order;
    order.signal = static_cast<std::uint8_t>(command.axis);
    order.is_on = !is_end;
    if (command.value2 != 0) {
        const bool is_rate = command.speed >= kLeastTestRate_hz && command.speed <= kMostTestRate_hz;
        if (!is_rate || command.value2 > kMostTestPulses)
            return refused("pins: 1 to 10000 pulses, 1 to 500 in a second");
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
    } else if (kind == RequestKind::spindle) {
        request.value = command.value != 0.0 ? 1 : 0;
    } else if (kind == RequestKind::override) {
        request.value = percent_of(command.value);
    } else if (kind == RequestKind::record) {
        added = add_recording(request, command);
    }
    if (!added) return added.error();
    return request;
}

std::string speed_remark(const Command& command, const Profile& profile) {
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
        char text[96];
        std::snprintf(text, sizeof text, "%s goes at %g %s at most, and so it does",
                      std::string{name_of(axis)}.c_str(), most, axis == Axis::psi ? "deg/s" : "mm/s");
        return text;
    }
    return {};
}

}  // namespace psicarve::supervisor
