// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path/carve_progress.hpp"

#include <algorithm>
#include <numeric>

namespace psicarve::verify {

CarveProgress::CarveProgress(const JobGeometry& geometry)
    : geometry_(geometry), of_layer_(geometry.layer_count(), 0) {
    of_layer_[geometry.first_layer()] = geometry.first_step(geometry.first_layer());
}

void CarveProgress::count(std::uint32_t layer) noexcept {
    ++of_layer_[layer];
    ++points_;
}

void CarveProgress::take_back(std::uint32_t layer) noexcept {
    --of_layer_[layer];
    --points_;
}

void CarveProgress::forget_from(CarvePoint begin) noexcept {
    const std::uint32_t first = geometry_.first_layer();
    of_layer_[begin.layer] = std::min(of_layer_[begin.layer], begin.step);
    std::fill(of_layer_.begin() + begin.layer + 1, of_layer_.end(), 0U);
    points_ =
        std::accumulate(of_layer_.begin() + first, of_layer_.begin() + begin.layer + 1, std::uint64_t{0}) -
        geometry_.first_step(first);
}

std::uint32_t CarveProgress::due_layer() const noexcept {
    std::uint32_t layer = geometry_.first_layer();
    while (layer < geometry_.end_layer() && of_layer_[layer] >= geometry_.point_count()) ++layer;
    return layer;
}

void CarveProgress::restore(const Kept& earlier) {
    of_layer_ = earlier.of_layer;
    points_ = earlier.points;
}

}  // namespace psicarve::verify
