// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/places.hpp"

namespace psicarve {

std::string in_source(std::string_view path) {
    return PSICARVE_SOURCE_FOLDER "/" + std::string{path};
}

std::string in_build(std::string_view path) {
    return PSICARVE_BUILD_FOLDER "/" + std::string{path};
}

}  // namespace psicarve
