// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "hmi/gcode/canon.hpp"

namespace psicarve::cli {

/// A place where a program waits for a person.
struct ProgramStop {
    std::uint64_t line = 0;
    std::string_view why;  ///< "program", "optional", "pallet", "tool change"
};

/// Notes where a program rests: dwells, and stops that wait for a person. In constant memory.
class StopFinder : public gcode::CanonSink {
public:
    static constexpr std::size_t kMostKept = 20;

    /// All outlive it. `next` takes what this takes.
    StopFinder(gcode::CanonSink& next, bool stops_at_optional) noexcept
        : next_(next), stops_at_optional_(stops_at_optional) {}

    void take(const gcode::CanonRecord& record) override;

    double dwell_seconds() const noexcept { return dwell_s_; }
    std::uint64_t stop_count() const noexcept { return stop_count_; }
    /// The first ones.
    const std::vector<ProgramStop>& stops() const noexcept { return stops_; }

private:
    gcode::CanonSink& next_;
    bool stops_at_optional_;
    double dwell_s_ = 0.0;
    std::uint64_t stop_count_ = 0;
    std::vector<ProgramStop> stops_;
};

}  // namespace psicarve::cli
