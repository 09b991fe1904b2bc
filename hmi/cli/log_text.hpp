// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shared/record/journal.hpp"

namespace psicarve::cli {

/// A record of a machine's journal, with the kind of machine.
struct LogEntry {
    JournalRecord record;
    bool is_simulator = false;
};

/// One line, with its line feed: time, kind, machine, what happened. Names of files and senders are copied
/// unchanged.
std::string log_line(const LogEntry& entry);
nlohmann::ordered_json log_json(const LogEntry& entry);

}  // namespace psicarve::cli
