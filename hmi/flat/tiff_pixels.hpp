// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tiffio.h>

#include <cstdint>
#include <string>

#include "hmi/flat/grey_image.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

/// The use of the first sample behind grey or red, green and blue.
enum class TiffAlpha : std::uint8_t { none, associated, unassociated };

/// The storage of a TIFF's pixels, by its directory.
struct TiffShape {
    std::uint16_t bits = 1;
    std::uint16_t samples = 1;
    std::uint16_t kind = PHOTOMETRIC_MINISBLACK;
    std::uint16_t number = SAMPLEFORMAT_UINT;
    TiffAlpha alpha = TiffAlpha::none;
    bool is_together = true;  ///< a pixel's samples stand beside each other
    bool guesses_alpha = false;

    bool is_grey() const noexcept { return kind == PHOTOMETRIC_MINISBLACK || kind == PHOTOMETRIC_MINISWHITE; }
    unsigned colours() const noexcept { return is_grey() ? 1 : 3; }
    /// Whether samples are used unchanged; else libtiff makes eight bits of red, green and blue of them.
    bool is_as_it_stands() const noexcept;
};

TiffShape tiff_shape(TIFF* tiff);

/// Refuses, naming its kind, a valid picture that cannot be read here.
Result<void> check_tiff_kind(TIFF* tiff, const TiffShape& shape, const std::string& file);

/// Reads into `image.values`, whose width and height are set, as they are stored: not yet upright. False:
/// damaged.
bool read_tiff_pixels(TIFF* tiff, const TiffShape& shape, GreyImage& image);

/// 1 where the file does not say, or gives an invalid value.
std::uint16_t tiff_orientation(TIFF* tiff);

}  // namespace psicarve::flat
