// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>

#include "hmi/gcode/active_modes.hpp"
#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/change_history.hpp"
#include "shared/machine/program_modes.hpp"
#include "shared/profile/profile.hpp"
#include "shared/program/motion_record.hpp"

namespace psicarve::gcode {

/// What held for each record between the one that is read and the one that the machine is at. One thread
/// reads the program and notes, another looks up where the machine is; neither waits for the other longer
/// than for a note. Bounded: where a program has more ways in between, the oldest is forgotten. What holds
/// there is known all the same, without its end and line, but for where it has changed as often, too.
///
///     ways | from: line, end | from: line, end | ...     records of one way: an arc's chords
///     held | from: codes, F, S, zeros          | ...     where something changes
///          machine                         program read
class ModesTrail {
public:
    /// `start`: where the machine stands, machine coordinates. `most_ways`: how many are kept, and how
    /// many changes of what holds.
    ModesTrail(const GcodeProfile& letters, const Position& start, std::size_t most_ways) noexcept;

    // Who reads:
    /// What holds for the next way.
    void set_modes(const ActiveModes& modes) noexcept;
    /// Records from here on are of another way: they may come late, but for one not behind the next call.
    void begin_way(std::uint64_t first_sequence) noexcept;
    /// Before it can be carried out.
    void note(const MotionRecord& record);

    // Who looks:
    /// Of the way that this record is of; 0: in front of all. Without program; `sequence` is its last record
    /// so far. What comes before is forgotten. Of a forgotten way: `end` is no number, `line` 0, `sequence`
    /// the last record for which the rest holds. Nothing: it is not known.
    std::optional<ProgramModes> at(std::uint64_t sequence);
    std::size_t way_count() const;
    /// For all of them, beside the object itself.
    std::size_t kept_bytes() const;

private:
    struct Mark {
        std::uint64_t first = 0;
        ActiveModes modes;
    };
    struct Way {
        std::uint64_t line;
        std::array<double, kAxisCount> end;
    };
    /// Without padding.
    struct Held {
        std::array<std::int16_t, kShownGCodes> g_codes;
        std::array<std::int16_t, kShownMCodes> m_codes;
        std::int64_t tool;
        double feed;
        double speed_rpm;
        double rotation_deg;
        std::array<double, kAxisCount> zero;
    };

    Held held_in(const ActiveModes& modes) const noexcept;
    ProgramModes shown(std::uint64_t last, const Way& way) const;
    ProgramModes of_forgotten_way() const;

    AxisLetters letters_;
    // Of the thread that reads:
    ActiveModes modes_;
    std::optional<ActiveModes> first_modes_;
    std::array<Mark, 2> marks_;  ///< the last two, the newer one first

    mutable std::mutex mutex_;  ///< for what follows
    std::array<double, kAxisCount> place_{};
    std::uint64_t last_ = 0;  ///< record that was noted
    std::uint64_t line_ = 0;  ///< of the newest way
    ChangeHistory<Way> ways_;
    ChangeHistory<Held> held_;
};

}  // namespace psicarve::gcode
