// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "hmi/gcode/arc.hpp"
#include "hmi/gcode/position.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::gcode {

/// The letters that draw with the table: X is r1, C psi, whatever letters the others have.
inline constexpr std::size_t kDepthLetter = 0;
inline constexpr std::size_t kTurnLetter = 5;

inline constexpr AxisMask kDrawnLetters = static_cast<AxisMask>(mask_of(kDepthLetter) | mask_of(kTurnLetter));
/// However small the core: nearer to the axis there is no direction.
inline constexpr double kLeastPolarMm = 0.001;
/// A shorter way is none.
inline constexpr double kLeastWayMm = 1e-7;
/// More has no way that is meant.
inline constexpr std::uint64_t kMostDrawnChords = 100'000;

/// On the unrolled cylinder r C stands where X stands in the plane of r1 and y.
inline constexpr Plane kCylinderCy{"CY", 5, 1, 0, 'I', 'J', 'K'};
inline constexpr Plane kCylinderZc{"ZC", 2, 5, 1, 'K', 'I', 'J'};
/// Of the cross-section: both in mm, X to the right and C up, C 0 being the direction of X.
inline constexpr Plane kCrossSection{"XC", 0, 5, 1, 'I', 'J', 'K'};

/// What feeds over the piece and drawing with the table need to know of the machine.
struct DrawingMachine {
    bool is_known = false;  ///< false: of no machine, letters are those of any
    bool feeds_over_surface = false;
    std::array<std::size_t, 2> head_letters{0, 0};  ///< of r1 and r2
    std::array<double, 2> out_mm{1e9, 1e9};         ///< a head that stays there cuts nothing
    bool is_y_on_z = false;                         ///< y has the letter Z, as lathes have it
    double tolerance_mm = 0.01;                     ///< of the path where the program gives none
    /// Of r1 and r2: the tip stands this much further out than its head is counted.
    std::array<double, 2> tip_mm{0.0, 0.0};
    bool follows = false;                           ///< r2 moves with r1, by the same letter
    double core_mm = 0.0;                           ///< where no tip may come
    std::array<double, 2> half_pulse_mm{0.0, 0.0};  ///< of r1 and r2: so much less is the same pulse

    /// What moves the machine's heads and y along a drawn way: X Y Z, and r2 where it has a letter behind.
    AxisMask linear_letters() const noexcept { return static_cast<AxisMask>(7U | mask_of(head_letters[1])); }

    /// How far a tip is from the axis where its head is counted so.
    double tip_radius_mm(std::size_t head, double counted_mm) const noexcept {
        return std::max(0.0, counted_mm + tip_mm[head]);
    }
};
DrawingMachine drawing_machine_of(const Profile& profile) noexcept;

enum class DrawnMode : std::uint8_t { none, cylinder, polar };

/// The mode that G7.1 and G12.1 begin.
struct Drawing {
    DrawnMode mode = DrawnMode::none;
    double radius_mm = 0.0;  ///< of the cylinder
    const Plane* plane_before = nullptr;
    PlanePoint place;               ///< in the cross-section
    bool is_doubtful = false;       ///< of the place
    bool is_mode_doubtful = false;  ///< a wrong block may have begun or ended it
    double tolerance_mm = 0.0;      ///< that the program has given; 0: none
};

}  // namespace psicarve::gcode
