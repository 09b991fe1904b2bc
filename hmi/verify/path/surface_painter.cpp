// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path/surface_painter.hpp"

namespace psicarve::verify {

void SurfacePainter::make_blank() {
    if (surface_ != nullptr) surface_->clear();
}

void SurfacePainter::aim(std::int64_t from_psi_pulses, std::uint32_t layer, std::uint32_t point) noexcept {
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        Head& head = heads_[h];
        head.from_row = head.row.value_or(0);
        head.from_cell = geometry_.cell_of(geometry_.direction(h, from_psi_pulses));
        head.row = geometry_.row_of_point(h, layer, point);
    }
}

void SurfacePainter::carve(std::size_t h, const Positions& at) noexcept {
    if (at[kPsi] != cells_at_psi_) {
        cells_at_psi_ = at[kPsi];
        for (std::size_t k = 0; k < kHeadCount; ++k)
            heads_[k].cell = geometry_.cell_of(geometry_.direction(k, at[kPsi]));
    }
    const Head& head = heads_[h];
    if (!head.row) return;
    const double mm = geometry_.head(h).real_mm(at[index_of(kHeads[h])]);
    const bool is_at_from = geometry_.is_spiral() && head.cell == head.from_cell;
    mark(is_at_from ? head.from_row : *head.row, head.cell, mm);
}

void SurfacePainter::reach(const Positions& point) noexcept {
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const Head& head = heads_[h];
        if (!head.row) continue;
        const std::uint32_t cell = geometry_.cell_of(geometry_.direction(h, point[kPsi]));
        mark(*head.row, cell, geometry_.head(h).real_mm(point[index_of(kHeads[h])]));
        note_deviation(*head.row, cell, 0);
    }
}

void SurfacePainter::miss(std::size_t h, std::int64_t psi_pulses, std::int64_t off_pulses) noexcept {
    const auto row = heads_[h].row;
    if (row) note_deviation(*row, geometry_.cell_of(geometry_.direction(h, psi_pulses)), off_pulses);
}

}  // namespace psicarve::verify
