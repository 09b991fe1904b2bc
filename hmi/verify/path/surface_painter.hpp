// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "hmi/surface/carved_surface.hpp"
#include "hmi/surface/job_geometry.hpp"

namespace psicarve::verify {

/// Carves the surface as the tips follow the job: knows which row of it each head is carving.
class SurfacePainter {
public:
    /// Both outlive it.
    SurfacePainter(const JobGeometry& geometry, CarvedSurface& surface) noexcept
        : geometry_(geometry), surface_(&surface) {}

    /// From now on the surface stays as it is: for a trial of what would be.
    void let_go() noexcept { surface_ = nullptr; }
    void make_blank();

    /// The tips come from this psi and are on their way to a point of the layer's table.
    void aim(std::int64_t from_psi_pulses, std::uint32_t layer, std::uint32_t point) noexcept;
    /// A tip on its line cuts where it may.
    void carve(std::size_t h, const Positions& at) noexcept;
    /// All axes stand at the point.
    void reach(const Positions& point) noexcept;
    /// The point was missed; a head that goes there was this much off its radius [pulses].
    void miss(std::size_t h, std::int64_t psi_pulses, std::int64_t off_pulses) noexcept;
    /// A tip elsewhere, in this row and cell of the surface.
    void mark(std::uint32_t row, std::uint32_t cell, double radius_mm) noexcept {
        if (surface_ != nullptr) surface_->touch(row, cell, static_cast<float>(radius_mm));
    }
    void note_deviation(std::uint32_t row, std::uint32_t cell, std::int64_t pulses) noexcept {
        if (surface_ != nullptr) surface_->note_deviation(row, cell, pulses);
    }
    /// A tip that carves nothing here came so near to the wanted radius.
    void note_passed(std::uint32_t row, std::uint32_t cell, std::int64_t pulses) noexcept {
        if (surface_ != nullptr) surface_->note_passed(row, cell, pulses);
    }

private:
    struct Head {
        std::optional<std::uint32_t> row;  ///< of the surface, that its tip is carving
        std::uint32_t from_row = 0;        ///< for a spiral: at the point that the tip comes from
        std::uint32_t from_cell = 0;
        std::uint32_t cell = 0;  ///< at `cells_at_psi_`
    };

    const JobGeometry& geometry_;
    CarvedSurface* surface_;                                                ///< null: paints nothing
    std::int64_t cells_at_psi_ = std::numeric_limits<std::int64_t>::min();  ///< no cell known yet
    std::array<Head, kHeadCount> heads_;
};

}  // namespace psicarve::verify
