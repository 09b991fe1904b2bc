// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/verify/perfect_machine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "shared/base/units.hpp"
#include "shared/trace/trace_format.hpp"

namespace psicarve::verify {

namespace {
constexpr SignalWord kAllEnables = kEnableMask;
constexpr std::int64_t kPeriod_ns = 50'000;
using Four = std::array<std::int64_t, kAxisCount>;
}  // namespace

SampleJob::SampleJob(const Profile& machine, std::uint32_t layers, std::uint32_t points, Joining joining,
                     const std::function<double(double, double)>& radius_mm)
    : profile(machine) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = points;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.joining = joining;
    table.feed_mm_s = profile.job.feed_mm_s;
    table.source_name = "sample.stl";
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    for (std::uint32_t i = 0; i < layers; ++i) {
        const bool closes = joining == Joining::spiral && i > 0 && i + 1 == layers;
        table.layer_height_pulses.push_back(100 +
                                            kLayerPulses * static_cast<std::int64_t>(closes ? i - 1 : i));
    }
    for (std::uint32_t i = 0; i < layers; ++i) {
        for (std::uint32_t j = 0; j < points; ++j) {
            const std::int64_t psi = table_angle_pulses(joining, table.psi_sweep_pulses, points, i, j);
            const double angle = rad_from_pulses(psi, profile.psi.pulses_per_rev);
            const double error = rad_from_deg(profile.head_r2_angle_error_deg);
            const auto pulses = [&](const LinearAxisProfile& head, double at, double layer) {
                return static_cast<std::int32_t>(
                    pulses_from_mm(radius_mm(at, layer) - head.tip_offset_mm, head.pulses_per_mm));
            };
            const double higher = profile.head_r2_height_error_mm * profile.y.pulses_per_mm / kLayerPulses;
            const std::int64_t y = table_height_pulses(joining, table.layer_height_pulses, points, i, j);
            const double at_layer = static_cast<double>(y - 100) / kLayerPulses;
            table.r_left_pulses.push_back(pulses(profile.r1, angle, at_layer));
            table.r_right_pulses.push_back(pulses(profile.r2, angle + kPi + error, at_layer + higher));
        }
    }
    blob = job_blob_from_table(table);
}

JobView SampleJob::view() const {
    return JobView::check(blob).value();
}

SampleJob wavy_job(Joining joining, std::uint32_t layers, std::uint32_t points) {
    return {Profile{}, layers, points, joining, [](double angle, double layer) {
                return 8.0 + 0.4 * std::cos(angle) + 0.3 * std::sin(2.0 * angle + 0.4 * layer) +
                       0.2 * std::sin(5.0 * angle) + 0.05 * layer;
            }};
}

PerfectMachine::PerfectMachine(const SampleJob& job) : view_(job.view()) {
    start.present = kOutputMask | kInputMask;
    start.has_positions = true;
    start.position_pulses = position = {24000, 24000, 0, 0};
    start.period_ns = kPeriod_ns;
}

void PerfectMachine::emit(std::int64_t time_ns, SignalWord levels) {
    if (levels == levels_) return;
    levels_ = levels;
    events.push_back(
        {.time_ns = time_ns, .levels = levels, .kind = TraceEvent::Kind::pins, .position_pulses = {}});
}

PerfectMachine& PerfectMachine::set(Signal signal, bool level) {
    emit(now_ns_, level ? levels_ | bit_of(signal) : levels_ & ~bit_of(signal));
    return wait(kIteration_ns);
}

PerfectMachine& PerfectMachine::wait(std::int64_t time_ns) {
    now_ns_ += time_ns;
    return *this;
}

PerfectMachine& PerfectMachine::define_positions(const Four& positions) {
    position = positions;
    events.push_back({.time_ns = now_ns_,
                      .levels = levels_,
                      .kind = TraceEvent::Kind::position,
                      .position_pulses = positions});
    return wait(kIteration_ns);
}

PerfectMachine& PerfectMachine::begin_crossed() {
    pushes_down_ = (1U << kAxisCount) - 1;
    start.crossed_pulses = gap;
    return *this;
}

void PerfectMachine::cross_gap(Axis axis, bool positive) {
    const auto bit = static_cast<unsigned>(1U << index_of(axis));
    if (((pushes_down_ & bit) == 0) == positive) return;
    pushes_down_ ^= bit;
    for (std::int64_t n = gap[index_of(axis)]; n > 0; --n) {
        position[index_of(axis)] += positive ? -1 : 1;  // the tip stays
        step_all(bit, positive ? bit : 0);
    }
}

/// One iteration: bit by axis, which step and which way.
void PerfectMachine::step_all(unsigned axes, unsigned positive) {
    for (const Axis axis : kAllAxes) {
        const auto bit = static_cast<unsigned>(1U << index_of(axis));
        if ((axes & bit) != 0) cross_gap(axis, (positive & bit) != 0);
    }
    SignalWord directions = levels_ & kDirMask;
    for (const Axis axis : kAllAxes) {
        const auto bit = static_cast<unsigned>(1U << index_of(axis));
        if ((axes & bit) == 0) continue;
        directions =
            (positive & bit) != 0 ? directions | bit_of(dir_of(axis)) : directions & ~bit_of(dir_of(axis));
        position[index_of(axis)] += (positive & bit) != 0 ? 1 : -1;
    }
    emit(now_ns_, (levels_ & ~kDirMask) | directions);
    emit(now_ns_ + kSetup_ns, levels_ | axes);
    emit(now_ns_ + kSetup_ns + kHigh_ns, levels_ & ~SignalWord{axes});
    now_ns_ += iteration_ns;
}

PerfectMachine& PerfectMachine::pulse(Axis axis, bool positive) {
    const auto bit = static_cast<unsigned>(1U << index_of(axis));
    step_all(bit, positive ? bit : 0);
    return *this;
}

PerfectMachine& PerfectMachine::move(Axis axis, std::int64_t pulses) {
    for (std::int64_t n = std::abs(pulses); n > 0; --n) pulse(axis, pulses > 0);
    return *this;
}

PerfectMachine& PerfectMachine::line(const Four& delta) {
    std::int64_t capacity = 0;
    for (const std::int64_t d : delta) capacity = std::max(capacity, std::abs(d));
    Four sums;
    sums.fill(capacity / 2);
    for (std::int64_t n = 0; n < capacity; ++n) {
        unsigned axes = 0;
        unsigned positive = 0;
        for (std::size_t a = 0; a < kAxisCount; ++a) {
            sums[a] += std::abs(delta[a]);
            if (sums[a] < capacity) continue;
            sums[a] -= capacity;
            axes |= 1U << a;
            if (delta[a] > 0) positive |= 1U << a;
        }
        step_all(axes, positive);
    }
    return *this;
}

PerfectMachine& PerfectMachine::approach(std::uint32_t layer, std::uint32_t step) {
    for (const Axis axis : kAllAxes) set(enable_of(axis), true);
    const std::uint32_t first = carved_point(view_.joining(), view_.point_count(), layer, step);
    move(Axis::psi, view_.psi_pulses(layer, first) - position[index_of(Axis::psi)]);
    move(Axis::y, view_.y_pulses(layer, first) - position[index_of(Axis::y)]);
    set(Signal::spindle, true);
    move(Axis::r1, view_.r_left_pulses(layer)[first] - position[0]);
    return move(Axis::r2, view_.r_right_pulses(layer)[first] - position[1]);
}

PerfectMachine& PerfectMachine::to_point(std::uint32_t layer, std::uint32_t step) {
    const std::uint32_t point = carved_point(view_.joining(), view_.point_count(), layer, step);
    return line({view_.r_left_pulses(layer)[point] - position[0],
                 view_.r_right_pulses(layer)[point] - position[1],
                 view_.psi_pulses(layer, point) - position[2], view_.y_pulses(layer, point) - position[3]});
}

PerfectMachine& PerfectMachine::link_to(std::uint32_t layer) {
    const std::uint32_t first = carved_point(view_.joining(), view_.point_count(), layer, 0);
    const Four wanted{view_.r_left_pulses(layer)[first], view_.r_right_pulses(layer)[first],
                      view_.psi_pulses(layer, first), view_.layer_heights_pulses()[layer]};
    for (std::size_t h = 0; h < 2; ++h)
        move(static_cast<Axis>(h), std::max<std::int64_t>(0, wanted[h] - position[h]));
    move(Axis::psi, wanted[2] - position[2]);
    move(Axis::y, wanted[3] - position[3]);
    for (std::size_t h = 0; h < 2; ++h) move(static_cast<Axis>(h), wanted[h] - position[h]);
    return *this;
}

PerfectMachine& PerfectMachine::layer(std::uint32_t layer) {
    for (std::uint32_t step = 1; step < view_.point_count(); ++step) to_point(layer, step);
    return *this;
}

PerfectMachine& PerfectMachine::finish() {
    move(Axis::r1, 400);
    move(Axis::r2, 400);
    return set(Signal::spindle, false);
}

PerfectMachine& PerfectMachine::carve_job() {
    approach().layer(0);
    for (std::uint32_t i = 1; i < view_.layer_count(); ++i) {
        if (!view_.is_joint(i, 0)) link_to(i);
        layer(i);
    }
    return finish();
}

std::string as_vcd(const TraceStart& start, const std::vector<TraceEvent>& events) {
    const auto code = [](std::size_t signal) { return std::string(1, static_cast<char>('!' + signal)); };
    const auto axes = [](const std::string& what, const Four& pulses) {
        std::string text = "$comment " + what;
        for (const Axis axis : kAllAxes)
            text += " " + std::string(name_of(axis)) + "=" + std::to_string(pulses[index_of(axis)]);
        return text + " $end\n";
    };
    const auto positions = [&](const Four& pulses) { return axes("position_pulses", pulses); };
    std::string text = "$timescale 1 ns $end\n$scope module psicarve $end\n";
    for (std::size_t s = 0; s < kSignalCount; ++s)
        text += "$var wire 1 " + code(s) + " " + std::string(name_of(static_cast<Signal>(s))) + " $end\n";
    text += "$upscope $end\n$enddefinitions $end\n" + positions(start.position_pulses);
    if (start.crossed_pulses != Four{}) text += axes("crossed_pulses", start.crossed_pulses);
    text += "#0\n$dumpvars\n";
    for (std::size_t s = 0; s < kSignalCount; ++s)
        text += std::to_string(start.initial_levels >> s & 1) + code(s) + "\n";
    text += "$end\n";
    SignalWord levels = start.initial_levels;
    std::int64_t time_ns = 0;
    for (const TraceEvent& event : events) {
        if (event.time_ns != time_ns) text += "#" + std::to_string(time_ns = event.time_ns) + "\n";
        if (event.kind == TraceEvent::Kind::position) text += positions(event.position_pulses);
        for (std::size_t s = 0; s < kSignalCount; ++s) {
            if (((levels ^ event.levels) >> s & 1) != 0)
                text += std::to_string(event.levels >> s & 1) + code(s) + "\n";
        }
        levels = event.levels;
    }
    return text;
}

std::string as_binary(const TraceStart& start, const std::vector<TraceEvent>& events) {
    TraceHeader header{};
    header.magic = kTraceMagic;
    const bool has_crossed = start.crossed_pulses != Four{};
    header.version = has_crossed ? kCrossedTraceVersion : kTraceVersion;
    header.initial_levels = start.initial_levels;
    header.period_ns = start.period_ns;
    std::copy(start.position_pulses.begin(), start.position_pulses.end(), header.position_pulses);
    std::string bytes(sizeof header, '\0');
    std::memcpy(bytes.data(), &header, sizeof header);
    if (has_crossed)
        bytes.append(reinterpret_cast<const char*>(start.crossed_pulses.data()), sizeof start.crossed_pulses);
    const auto number = [&](std::uint64_t value) {
        std::array<std::uint8_t, kLeb128MaxBytes> room;
        const std::uint8_t* end = encode_leb128(room.data(), value);
        bytes.append(reinterpret_cast<const char*>(room.data()), static_cast<std::size_t>(end - room.data()));
    };
    SignalWord levels = start.initial_levels;
    std::int64_t tick = 0;
    for (const TraceEvent& event : events) {
        const std::int64_t now = event.time_ns / start.period_ns;
        const std::int64_t offset = event.time_ns % start.period_ns;
        const auto passed = static_cast<std::uint64_t>(now - std::exchange(tick, now));
        if (event.kind == TraceEvent::Kind::position) {
            number(trace_record_head(passed, TraceRecordKind::position));
            for (const std::int64_t pulses : event.position_pulses) number(zigzag_from(pulses));
            continue;
        }
        number(trace_record_head(passed,
                                 offset == 0 ? TraceRecordKind::pins : TraceRecordKind::pins_with_offset));
        if (offset != 0) number(static_cast<std::uint64_t>(offset));
        number(std::exchange(levels, event.levels) ^ event.levels);
    }
    number(trace_record_head(1, TraceRecordKind::end));
    return bytes;
}

}  // namespace psicarve::verify
