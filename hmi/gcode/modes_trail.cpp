// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/modes_trail.hpp"

#include <algorithm>
#include <limits>

namespace psicarve::gcode {
namespace {

/// Drops what is not in force any more where this record is: the first that stays is the last one that begins
/// there or before.
template <typename Notes>
void drop_before(Notes& notes, std::uint64_t sequence) {
    while (notes.size() > 1 && notes[1].first <= sequence) notes.pop_front();
}

}  // namespace

ModesTrail::ModesTrail(const GcodeProfile& letters, const Position& start, std::size_t most_ways) noexcept
    : letters_(letters), most_ways_(most_ways) {
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
    if (ways_.empty()) {
        // In front of the program: what it begins with.
        ways_.push_back({0, 0, 0, place_});
        changes_.push_back({0, first_modes_.value_or(modes_)});
    }
    if (record.kind == MotionKind::way || record.kind == MotionKind::arc) {
        for (std::size_t k = 0; k < kAxisCount; ++k)
            if ((record.axes & 1U << k) != 0) place_[k] = record.target[k];
    }
    if (mark != marks_.end() || ways_.back().last == 0) {
        add_way(record, mark == marks_.end() ? changes_.back().modes : mark->modes);
    } else {
        ways_.back().last = record.sequence;
        ways_.back().end = place_;
    }
}

void ModesTrail::add_way(const MotionRecord& record, const ActiveModes& modes) {
    ways_.push_back({record.sequence, record.sequence, record.line, place_});
    if (ways_.size() > most_ways_) ways_.pop_front();
    if (changes_.back().modes != modes) changes_.push_back({record.sequence, modes});
    if (changes_.size() > most_ways_) changes_.pop_front();
}

std::optional<ProgramModes> ModesTrail::at(std::uint64_t sequence) {
    const std::lock_guard lock{mutex_};
    drop_before(ways_, sequence);
    drop_before(changes_, sequence);
    if (ways_.empty() || changes_.front().first > sequence) return std::nullopt;
    const Way& way = ways_.front();
    if (way.first > sequence) return shown(changes_.front(), forgotten_way());
    if (way.last < sequence) return std::nullopt;
    return shown(changes_.front(), way);
}

/// In front of the first that is kept: the last record for which holds what held there, and no end.
ModesTrail::Way ModesTrail::forgotten_way() const noexcept {
    Way way = ways_.front();
    if (changes_.size() > 1) way.first = std::min(way.first, changes_[1].first);
    way.last = way.first - 1;
    way.line = 0;
    way.end.fill(std::numeric_limits<double>::quiet_NaN());
    return way;
}

std::size_t ModesTrail::way_count() const {
    const std::lock_guard lock{mutex_};
    return ways_.size();
}

ProgramModes ModesTrail::shown(const Change& change, const Way& way) const noexcept {
    ProgramModes told{};
    told.sequence = way.last;
    told.line = way.line;
    told.g_codes = change.modes.g_codes;
    told.m_codes = change.modes.m_codes;
    told.feed = change.modes.feed;
    told.speed_rpm = change.modes.speed_rpm;
    told.tool = change.modes.tool;
    told.rotation_deg = change.modes.rotation_deg;
    for (const Axis axis : kAllAxes) told.zero[index_of(axis)] = change.modes.zero[letters_.letter_of(axis)];
    told.end = way.end;
    return told;
}

}  // namespace psicarve::gcode
