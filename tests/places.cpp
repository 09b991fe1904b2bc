// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/places.hpp"

#include <cstdlib>

namespace psicarve {
namespace {

/// No profile of the developer's or of this machine changes what a test sees, in this program or in those
/// that it starts.
const bool kHasNoProfile = setenv("PSICARVE_PROFILE", "", 1) == 0;
/// Nor does a test see what a core has kept here. It keeps things only where it says so itself.
const bool kHasNoState = setenv("PSICARVE_STATE", "", 1) == 0;

}  // namespace

std::string in_source(std::string_view path) {
    return PSICARVE_SOURCE_FOLDER "/" + std::string{path};
}

std::string in_build(std::string_view path) {
    static_cast<void>(kHasNoProfile);
    static_cast<void>(kHasNoState);
    return PSICARVE_BUILD_FOLDER "/" + std::string{path};
}

}  // namespace psicarve
