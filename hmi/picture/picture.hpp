// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hmi/surface/carved_surface.hpp"
#include "hmi/verify/verify_report.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"

namespace psicarve::verify {

/// The picture's text, besides the piece itself.
struct PictureCaption {
    std::string model_name;
    std::uint32_t layers = 0;
    std::uint32_t points = 0;
    bool verified = false;
    bool has_lost_steps = false;  ///< the machine did not follow the pins
    std::int64_t max_deviation_pulses = 0;
    bool is_of_carved_alone = false;  ///< it was cut short: what is left to carve is no deviation
    bool is_of_part = false;          ///< some layers were asked for: what lies outside them is no deviation
    bool is_dry = false;
};
PictureCaption caption_of(const JobView& job, const VerifyReport& report);

/// The badge beside the title.
std::string verdict_of(const PictureCaption& caption);

/// An 800 pixel wide PNG: the carved piece from two sides, shaded, beside the unrolled map of its deviations
/// from the job.
Result<std::vector<std::byte>> picture_png(const CarvedSurface& surface, const PictureCaption& caption);

/// Writes it to a file, atomically: the old file stays intact whatever happens.
Result<void> write_picture(const std::string& path, const CarvedSurface& surface,
                           const PictureCaption& caption);

}  // namespace psicarve::verify
