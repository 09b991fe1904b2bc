// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/trace/vcd_writer.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <utility>

#include "shared/machine/signal.hpp"

namespace psicarve::trace {
namespace {

constexpr SignalWord kAllSignals = (SignalWord{1} << kSignalCount) - 1;
constexpr std::size_t kNumberBytes = 24;

/// Identifier codes are single printable characters from '!' on, by the signal's number.
constexpr char code_of(std::size_t signal) noexcept {
    return static_cast<char>('!' + signal);
}

void write_number(TraceOutput& out, std::int64_t number) noexcept {
    char text[kNumberBytes];
    const auto [end, error] = std::to_chars(text, text + sizeof text, number);
    out.write(std::string_view(text, static_cast<std::size_t>(end - text)));
}

}  // namespace

VcdWriter::VcdWriter(TraceOutput out, const TraceStart& start) noexcept
    : out_(std::move(out)),
      period_ns_(start.period_ns),
      levels_(start.levels),
      counted_(start.position_pulses) {
    write_definitions();
    write_positions(start.position_pulses);
    if (start.has_crossed()) write_axes("crossed_pulses", start.crossed_pulses);
    out_.write("$enddefinitions $end\n#0\n$dumpvars\n");
    write_levels(kAllSignals, levels_);
    out_.write("$end\n");
}

void VcdWriter::write_definitions() noexcept {
    out_.write("$version Psicarve pin trace $end\n$timescale 1 ns $end\n$scope module psicarve $end\n");
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        out_.write("$var wire 1 ");
        const char code = code_of(i);
        out_.write(std::string_view(&code, 1));
        out_.write(" ");
        out_.write(name_of(static_cast<Signal>(i)));
        out_.write(" $end\n");
    }
    out_.write("$upscope $end\n$comment period_ns ");
    write_number(out_, period_ns_);
    out_.write(" $end\n");
}

void VcdWriter::write_axes(std::string_view what, const Positions& pulses) noexcept {
    out_.write("$comment ");
    out_.write(what);
    for (const Axis axis : kAllAxes) {
        out_.write(" ");
        out_.write(name_of(axis));
        out_.write("=");
        write_number(out_, pulses[index_of(axis)]);
    }
    out_.write(" $end\n");
}

/// Counts what a reader of the pins alone counts: a step edge of an enabled drive.
void VcdWriter::count_pulses(SignalWord levels) noexcept {
    SignalWord edges = levels & ~levels_ & kStepMask;
    for (; edges != 0; edges &= edges - 1) {
        const auto axis = static_cast<Axis>(std::countr_zero(edges));
        if ((levels & bit_of(enable_of(axis))) == 0) continue;
        counted_[index_of(axis)] += (levels & bit_of(dir_of(axis))) != 0 ? 1 : -1;
    }
}

void VcdWriter::write_time(std::int64_t time_ns) noexcept {
    if (time_ns <= time_ns_) return;
    time_ns_ = time_ns;
    out_.write("#");
    write_number(out_, time_ns);
    out_.write("\n");
}

void VcdWriter::write_levels(SignalWord which, SignalWord levels) noexcept {
    std::uint8_t* place = out_.room(3 * kSignalCount);
    for (SignalWord left = which; left != 0; left &= left - 1) {
        const auto signal = static_cast<std::size_t>(std::countr_zero(left));
        *place++ = (levels >> signal & 1) != 0 ? '1' : '0';
        *place++ = static_cast<std::uint8_t>(code_of(signal));
        *place++ = '\n';
    }
    out_.commit(place);
}

void VcdWriter::add(const TraceEntry& entry) noexcept {
    const std::int64_t tick_ns = static_cast<std::int64_t>(entry.tick) * period_ns_;
    if (entry.kind == TraceEntry::Kind::position) {
        if (entry.position_pulses == counted_) return;
        counted_ = entry.position_pulses;
        write_time(tick_ns);
        write_positions(entry.position_pulses);
        return;
    }
    const SignalWord changed = (entry.levels ^ levels_) & kAllSignals;
    if (changed == 0) return;
    count_pulses(entry.levels);
    levels_ = entry.levels;
    write_time(tick_ns + entry.offset_ns);
    write_levels(changed, levels_);
}

void VcdWriter::finish(std::uint64_t end_tick) noexcept {
    // A last time without a change shows a viewer how far the trace reaches.
    write_time(static_cast<std::int64_t>(end_tick) * period_ns_);
    out_.flush();
}

}  // namespace psicarve::trace
