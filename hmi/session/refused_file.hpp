// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// A file that could not be opened.
struct RefusedFile {
    std::string path;
    Phrase why;
};

}  // namespace psicarve::session
