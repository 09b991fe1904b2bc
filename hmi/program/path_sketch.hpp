// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/canon.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::program {

/// Where a piece of the path ends; it begins where the one before ends. The first point only begins.
struct SketchPoint {
    std::array<double, kAxisCount> place{};  ///< by the axes' numbers; mm, degrees
    std::uint64_t first_line = 0;            ///< of the moves that it stands for
    std::uint64_t last_line = 0;
    std::uint8_t placed = 0;  ///< bit of each axis whose place the program has set at both ends
    bool is_rapid = false;
};

/// A program's way for the eye, in constant memory: no point of it is further from what is kept than a
/// distance that grows with the program (twice tolerance_mm()).
class PathSketch : public gcode::CanonSink {
public:
    static constexpr std::size_t kMostPoints = 40'000;

    explicit PathSketch(const gcode::AxisLetters& letters) noexcept : letters_(letters) {}

    void take(const gcode::CanonRecord& record) override;
    const std::vector<SketchPoint>& points() const noexcept { return points_; }
    /// What may be left out, in mm (half a degree counts as much as a quarter of a mm).
    double tolerance_mm() const noexcept { return tolerance_mm_; }
    std::vector<SketchPoint> finished() { return std::move(points_); }

private:
    std::array<double, kAxisCount> place_of(const gcode::Position& position) const noexcept;
    std::uint8_t placed_of(gcode::AxisMask placed) const noexcept;
    void begin_at(const std::array<double, kAxisCount>& place, std::uint64_t line);
    void add(const SketchPoint& point);
    void put(const SketchPoint& point);
    void thin();

    gcode::AxisLetters letters_;
    std::vector<SketchPoint> points_;
    double tolerance_mm_ = 0.0;
};

/// The piece that stands for a line's move, from 1; 0: none does, or several: which of them runs is not
/// knows.
std::size_t piece_of_line(const std::vector<SketchPoint>& points, std::uint64_t line) noexcept;

}  // namespace psicarve::program
