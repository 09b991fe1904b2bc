// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/flat/grey_image.hpp"

namespace psicarve::flat {

/// The camera's orientation, 1 to 8 as TIFF and Exif count, from the content of a JPEG's APP1 marker; 1,
/// upright, where it does not say or is damaged.
int exif_orientation(Bytes marker) noexcept;

/// Turns the picture upright.
void turn_upright(GreyImage& image, int orientation);

}  // namespace psicarve::flat
