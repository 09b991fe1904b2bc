// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "hmi/gcode/kept_offsets.hpp"
#include "hmi/gcode/position.hpp"

namespace psicarve::gcode {

/// Where a program's zero is: machine = system + turned(program + G92) + tool length. The turn is that of the
/// work coordinate system, about its zero, in X and Y.
class WorkOffsets {
public:
    static constexpr std::size_t kSystemCount = gcode::kSystemCount;

    /// With those that were kept.
    explicit WorkOffsets(const KeptOffsets& kept = {}) noexcept;
    /// Fills in all that is kept, but for references.
    void keep(KeptOffsets& kept) const noexcept;

    Position to_machine(const Position& program) const noexcept;
    Position to_program(const Position& machine) const noexcept;
    /// In machine coordinates, of a pair of X and Y in program coordinates that `to_machine` would place.
    bool is_turned() const noexcept { return systems_[active_].rotation_deg != 0.0; }

    const Position& origin(std::size_t system) const noexcept { return systems_[system].origin; }
    double rotation_deg(std::size_t system) const noexcept { return systems_[system].rotation_deg; }
    /// Of G92, also while it is suspended.
    const Position& kept_shift() const noexcept { return kept_shift_; }
    bool is_shifted() const noexcept { return is_shifted_; }
    bool has_tool_length() const noexcept { return tool_ != Position{}; }
    std::size_t active() const noexcept { return active_; }
    void select(std::size_t system) noexcept;
    void set_origin(std::size_t system, std::size_t axis, double origin) noexcept;
    void set_rotation(std::size_t system, double rotation_deg) noexcept;
    /// G10 L20: sets the system so that the machine stands at `program` in it.
    void set_current(std::size_t system, const Position& machine, AxisMask axes,
                     const Position& program) noexcept;

    /// G92: the machine's present place gets these coordinates.
    void set_shift(const Position& machine, AxisMask axes, const Position& program) noexcept;
    void clear_shift() noexcept;    ///< G92.1
    void suspend_shift() noexcept;  ///< G92.2
    void restore_shift() noexcept;  ///< G92.3

    void set_tool(AxisMask axes, const Position& length) noexcept;  ///< G43.1
    void clear_tool() noexcept;                                     ///< G49

private:
    void refresh() noexcept;
    Position unturned(const Position& machine, const SystemOffset& system) const noexcept;

    std::array<SystemOffset, kSystemCount> systems_{};
    std::size_t active_ = 0;
    Position shift_{};
    Position kept_shift_{};
    bool is_shifted_ = false;
    Position tool_{};
    // Calculated from them.
    Position sum_{};
    double sine_ = 0.0;
    double cosine_ = 1.0;
};

}  // namespace psicarve::gcode
