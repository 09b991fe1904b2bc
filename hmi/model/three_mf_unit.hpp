// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace psicarve::model {

/// What a 3MF file says its coordinates are in. Assimp drops it.
struct ThreeMfUnit {
    std::string name = "millimeter";
    double mm = 1.0;
};
/// The millimetre, the format's own default, where the file does not say or cannot be read.
ThreeMfUnit three_mf_unit(const std::string& path);

}  // namespace psicarve::model
