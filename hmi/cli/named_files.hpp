// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "shared/base/result.hpp"
#include "shared/file/distinct_files.hpp"

namespace CLI {
class App;
}

namespace psicarve::cli {

/// All files that a parsed command line names, before the command's name and after it, and the profile of the
/// default place where it names none.
std::vector<NamedFile> named_files(const CLI::App& command);

/// Refuses "-", as bad_usage, where the file cannot be a stream. Inputs that read standard input have been
/// given another name by then.
Result<void> check_no_stream(const std::vector<NamedFile>& files);

}  // namespace psicarve::cli
