// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Shows a text five times a second until Ctrl-C (then exit code 0) or an error: redrawn in place on a
/// terminal, else only when it changed. `show` gets whether one line is wanted.
Result<int> watch_loop(const std::function<Result<std::string>(bool as_line)>& show, bool as_json);

/// Does that when `is_watched`, else shows the text once.
Result<int> show_or_watch(const std::function<Result<std::string>(bool as_line)>& show, bool is_watched,
                          bool as_json);

}  // namespace psicarve::cli
