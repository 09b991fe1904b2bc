// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/rough/air_finder.hpp"

namespace psicarve::rough {
namespace {

// A head is clear when it would be so this much further in: half of what it is lifted by over what is clear,
// and more than the stock's cells and the path's tolerance come to.
constexpr double kAirClear_mm = 0.15;

}  // namespace

AirFinder::AirFinder(const Rings& rings, const Profile& profile, Joining joining)
    : rings_(rings), stock_(rings, profile), joining_(joining) {}

TipPlace AirFinder::place(std::size_t head, std::size_t point, double in_mm) const {
    const std::size_t points = rings_.point_count();
    const std::size_t cell = (first_cell_ + head * (points - 1) + point) % rings_.cell_count();
    return {head, ring_, cell, rings_.head(head).real_mm((*radii_)[head][point]) - in_mm};
}

// Both heads are looked at before either cuts: what one of them takes away in this layer the other one may
// meet before.
std::vector<std::uint8_t> AirFinder::carve(std::size_t ring, std::size_t layer,
                                           const std::array<std::vector<std::int32_t>, kHeads>& radii) {
    const std::size_t points = rings_.point_count();
    ring_ = ring;
    first_cell_ = first_cell(joining_, points, layer);
    radii_ = &radii;
    std::vector<std::uint8_t> is_clear(points, 1);
    for (std::size_t point = 0; point < points; ++point) {
        for (std::size_t h = 0; h < kHeads && is_clear[point] != 0; ++h)
            is_clear[point] = stock_.bite_mm(place(h, point, kAirClear_mm)) > 0.0 ? 0 : 1;
    }
    std::vector<std::uint8_t> air = is_clear;
    for (std::size_t point = 0; point + 1 < points; ++point) {
        if (is_clear[point] == 0 || is_clear[point + 1] == 0) continue;
        for (std::size_t h = 0; h < kHeads; ++h) {
            const TipPlace next = place(h, point + 1, kAirClear_mm);
            if (stock_.bite_between_mm(place(h, point, kAirClear_mm), next) > 0.0)
                air[point] = air[point + 1] = 0;
        }
    }
    for (std::size_t point = 0; point < points; ++point) {
        const std::size_t next = point + 1 < points ? point + 1 : point;
        if (air[point] != 0 && air[next] != 0) continue;
        for (std::size_t h = 0; h < kHeads; ++h) stock_.cut(place(h, point, 0.0), place(h, next, 0.0));
    }
    return air;
}

std::uint64_t air_ways(const std::vector<std::uint8_t>& air) noexcept {
    std::uint64_t count = 0;
    for (std::size_t point = 1; point < air.size(); ++point)
        count += air[point - 1] != 0 && air[point] != 0 ? 1 : 0;
    return count;
}

}  // namespace psicarve::rough
