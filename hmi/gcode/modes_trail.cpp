// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/modes_trail.hpp"

#include <algorithm>
#include <limits>

namespace psicarve::gcode {
ModesTrail::ModesTrail(const GcodeProfile& letters, const Position& start, std::size_t most_ways) noexcept
    : letters_(letters), ways_(most_ways), held_(most_ways) {
    for (const Axis axis : kAllAxes) place_[index_of(axis)] = start[letters_.letter_of(axis)];
    modes_.g_codes.fill(-1);
    modes_.m_codes.fill(-1);
}

void ModesTrail::set_modes(const ActiveModes& modes) noexcept {
    modes_ = modes;
    if (!first_modes_) first_modes_ = modes;
}

void ModesTrail::begin_way(std::uint64_t first_sequence) noexcept {
    if (marks_[0].first != first_sequence) marks_[1] = marks_[0];
    marks_[0] = {first_sequence, modes_};
}

void ModesTrail::note(const MotionRecord& record) {
    const auto mark = std::ranges::find(marks_, record.sequence, &Mark::first);
    const std::lock_guard lock{mutex_};
    if (ways_.count() == 0) {
        // In front of the program: what it begins with.
        ways_.add(0, {0, place_});
        held_.add_change(0, held_in(first_modes_.value_or(modes_)));
    }
    if (record.kind == MotionKind::way || record.kind == MotionKind::arc) {
        for (std::size_t k = 0; k < kAxisCount; ++k)
            if ((record.axes & 1U << k) != 0) place_[k] = record.target[k];
    }
    last_ = record.sequence;
    if (mark == marks_.end() && ways_.newest_first() != 0) return ways_.replace_newest({line_, place_});
    line_ = record.line;
    ways_.add(record.sequence, {line_, place_});
    if (mark != marks_.end()) held_.add_change(record.sequence, held_in(mark->modes));
}

ModesTrail::Held ModesTrail::held_in(const ActiveModes& modes) const noexcept {
    Held held{modes.g_codes, modes.m_codes, modes.tool, modes.feed, modes.speed_rpm, modes.rotation_deg, {}};
    for (const Axis axis : kAllAxes) held.zero[index_of(axis)] = modes.zero[letters_.letter_of(axis)];
    return held;
}

std::optional<ProgramModes> ModesTrail::at(std::uint64_t sequence) {
    const std::lock_guard lock{mutex_};
    ways_.drop_before(sequence);
    held_.drop_before(sequence);
    if (ways_.count() == 0 || !held_.knows(sequence)) return std::nullopt;
    if (!ways_.knows(sequence)) return of_forgotten_way();
    // There is no gap between the records of two ways.
    const std::uint64_t last = ways_.second_first(last_ + 1) - 1;
    if (last < sequence) return std::nullopt;
    return shown(last, ways_.front());
}

/// In front of the first that is kept: the last record for which holds what held there, and no end.
ProgramModes ModesTrail::of_forgotten_way() const {
    Way way{0, {}};
    way.end.fill(std::numeric_limits<double>::quiet_NaN());
    const std::uint64_t first = ways_.front_first();
    return shown(std::min(held_.second_first(first), first) - 1, way);
}

std::size_t ModesTrail::way_count() const {
    const std::lock_guard lock{mutex_};
    return ways_.count();
}

std::size_t ModesTrail::kept_bytes() const {
    const std::lock_guard lock{mutex_};
    return ways_.kept_bytes() + held_.kept_bytes();
}

/// With what holds first.
ProgramModes ModesTrail::shown(std::uint64_t last, const Way& way) const {
    const Held held = held_.front();
    ProgramModes told{};
    told.sequence = last;
    told.line = way.line;
    told.g_codes = held.g_codes;
    told.m_codes = held.m_codes;
    told.feed = held.feed;
    told.speed_rpm = held.speed_rpm;
    told.tool = held.tool;
    told.rotation_deg = held.rotation_deg;
    told.zero = held.zero;
    told.end = way.end;
    return told;
}

}  // namespace psicarve::gcode
