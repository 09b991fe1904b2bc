// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/report/run_report.hpp"

namespace psicarve::cli {

using report::report_of;
using report::RunReport;

/// Lines for a person.
std::string run_text(const RunReport& report);

/// Prints the report and returns the exit code; prints an error on standard error too.
int print_run(const RunReport& report, bool as_json);

}  // namespace psicarve::cli
