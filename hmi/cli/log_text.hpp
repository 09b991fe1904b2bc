// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "hmi/history/log_sources.hpp"

namespace psicarve::cli {

using history::LogEntry;

/// One line, with its line feed: time, kind, machine, what happened. Names of files and senders are copied
/// unchanged.
std::string log_line(const LogEntry& entry);
nlohmann::ordered_json log_json(const LogEntry& entry);

}  // namespace psicarve::cli
