// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/flat/grey_image.hpp"

namespace psicarve::flat {

/// How a camera held the picture, 1 to 8 as TIFF and Exif count, from the content of a JPEG's APP1 marker; 1,
/// upright, where it does not say or is damaged.
int exif_orientation(Bytes marker) noexcept;

/// The picture as it is to be seen.
void turn_upright(GreyImage& image, int orientation);

}  // namespace psicarve::flat
