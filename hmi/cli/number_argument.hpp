// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/base/result.hpp"

namespace psicarve::cli {

/// The whole text as a finite number; bad_usage that names the argument.
Result<double> number_argument(const std::string& name, const std::string& text);

}  // namespace psicarve::cli
