// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/modes_trail.hpp"

#include <algorithm>
#include <limits>

namespace psicarve::gcode {
ModesTrail::ModesTrail(const GcodeProfile& letters, const Position& start, std::size_t most_ways) noexcept
    : letters_(letters), most_ways_(most_ways), rates_(most_ways), codes_(most_ways), zeros_(most_ways) {
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
        add_modes(0, first_modes_.value_or(modes_));
    }
    if (record.kind == MotionKind::way || record.kind == MotionKind::arc) {
        for (std::size_t k = 0; k < kAxisCount; ++k)
            if ((record.axes & 1U << k) != 0) place_[k] = record.target[k];
    }
    if (mark == marks_.end() && ways_.back().last != 0) {
        ways_.back().last = record.sequence;
        ways_.back().end = place_;
        return;
    }
    ways_.push_back({record.sequence, record.sequence, record.line, place_});
    if (ways_.size() > most_ways_) ways_.pop_front();
    if (mark != marks_.end()) add_modes(record.sequence, mark->modes);
}

void ModesTrail::add_modes(std::uint64_t first, const ActiveModes& modes) {
    rates_.add(first, {modes.feed, modes.speed_rpm});
    codes_.add(first, shared_codes({modes.g_codes, modes.m_codes, modes.tool}));
    Zeros zeros{modes.rotation_deg, {}};
    for (const Axis axis : kAllAxes) zeros.zero[index_of(axis)] = modes.zero[letters_.letter_of(axis)];
    zeros_.add(first, zeros);
}

/// The same for the same codes, as long as few others come between.
ModesTrail::SharedCodes ModesTrail::shared_codes(const Codes& codes) {
    for (const SharedCodes& known : recent_codes_)
        if (known && *known == codes) return known;
    SharedCodes& place = recent_codes_[oldest_codes_];
    oldest_codes_ = (oldest_codes_ + 1) % recent_codes_.size();
    place = std::make_shared<const Codes>(codes);
    return place;
}

std::optional<ProgramModes> ModesTrail::at(std::uint64_t sequence) {
    const std::lock_guard lock{mutex_};
    while (ways_.size() > 1 && ways_[1].first <= sequence) ways_.pop_front();
    rates_.drop_before(sequence);
    codes_.drop_before(sequence);
    zeros_.drop_before(sequence);
    if (ways_.empty() || !rates_.knows(sequence) || !codes_.knows(sequence) || !zeros_.knows(sequence))
        return std::nullopt;
    const Way& way = ways_.front();
    if (way.first > sequence) return shown(forgotten_way());
    if (way.last < sequence) return std::nullopt;
    return shown(way);
}

/// In front of the first that is kept: the last record for which holds what held there, and no end.
ModesTrail::Way ModesTrail::forgotten_way() const noexcept {
    Way way = ways_.front();
    way.first = std::min({rates_.second_first(way.first), codes_.second_first(way.first),
                          zeros_.second_first(way.first), way.first});
    way.last = way.first - 1;
    way.line = 0;
    way.end.fill(std::numeric_limits<double>::quiet_NaN());
    return way;
}

std::size_t ModesTrail::way_count() const {
    const std::lock_guard lock{mutex_};
    return ways_.size();
}

/// With what holds first.
ProgramModes ModesTrail::shown(const Way& way) const noexcept {
    const auto& [g_codes, m_codes, tool] = *codes_.front();
    ProgramModes told{};
    told.sequence = way.last;
    told.line = way.line;
    told.g_codes = g_codes;
    told.m_codes = m_codes;
    told.feed = rates_.front().feed;
    told.speed_rpm = rates_.front().speed_rpm;
    told.tool = tool;
    told.rotation_deg = zeros_.front().rotation_deg;
    told.zero = zeros_.front().zero;
    told.end = way.end;
    return told;
}

}  // namespace psicarve::gcode
