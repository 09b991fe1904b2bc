// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hmi/picture/piece_view.hpp"
#include "hmi/surface/carved_surface.hpp"

namespace psicarve::verify {

/// What stands in the colour of its deviation; all else is kUncarvedColour, flat.
enum class MapShows {
    all,        ///< whole job: what was not carved is left on
    asked_for,  ///< some layers: the same of these alone
    carved,     ///< cut short: nobody knows how far it was to come
};

/// Of places that nothing was carved at yet: darker than a carved one in whatever light.
inline constexpr std::array<double, 3> kUncarvedColour{0.42, 0.44, 0.48};

/// Colours of deviations: blue too deep, white as wanted, red material left; the scale reaches to the
/// surface's largest deviation.
class DeviationScale {
public:
    explicit DeviationScale(std::int64_t largest_pulses);
    std::int64_t reach_pulses() const noexcept { return reach_pulses_; }
    std::array<double, 3> colour(double pulses) const noexcept;  ///< red, green, blue, 0..1

private:
    std::int64_t reach_pulses_;
};

/// The piece unrolled, direction 0 at the left, the highest layer at the top. A pixel shows the largest
/// deviation among its cells, so that a single stray cut is visible; the relief shines through in grey.
PixelImage draw_deviation_map(const CarvedSurface& surface, const DeviationScale& scale, std::size_t width_px,
                              std::size_t height_px, MapShows shows = MapShows::all);

}  // namespace psicarve::verify
