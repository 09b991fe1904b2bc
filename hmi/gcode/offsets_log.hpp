// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>

#include "hmi/gcode/kept_offsets.hpp"

namespace psicarve::gcode {

/// Which offsets a running program has reached. It is read ahead of the machine; offsets that it sets behind
/// a record are reached when the machine is at the next one.
///
///     records   1   2   3 | 4   5   6   7 |                 the machine says its line, and up to where the
///     offsets   A   A   A | B   B   B   B | C               core has taken records: it is at one of the last
///                                 ^ line 9    ^ taken       kMostAhead of them that has that line
///
/// A line that is run several times may be any of these: then it is the earliest one, never one before what
/// was seen already. One thread notes, another watches.
class OffsetsLog {
public:
    /// The core has no more records than these that it has taken and not run.
    static constexpr std::uint64_t kMostAhead = 4096;

    explicit OffsetsLog(const KeptOffsets& begin);

    // The program's reader:
    /// Offsets that hold behind so many records.
    void set(const KeptOffsets& offsets, std::uint64_t records);
    /// The next record, numbered from 1.
    void note(std::uint64_t line);

    // Who watches the machine:
    /// It is at a record of this line, 0: at none, and the core has taken so many.
    void reach(std::uint64_t line, std::uint64_t taken);
    /// It was at any record.
    bool has_reached() const;
    KeptOffsets reached() const;
    /// All of the program is run.
    KeptOffsets last() const;

private:
    struct State {
        std::uint64_t first;  ///< record that it holds for
        KeptOffsets offsets;
    };
    /// Records in a row that have one line and one state.
    struct Run {
        std::uint64_t first;
        std::uint64_t last;
        std::uint64_t line;
    };

    void forget_before(std::uint64_t record);

    mutable std::mutex mutex_;
    std::deque<State> states_;  ///< from the one that is reached on
    std::deque<Run> runs_;
    std::uint64_t noted_ = 0;
    std::uint64_t reached_ = 0;  ///< record
};

}  // namespace psicarve::gcode
