// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/history/log_sources.hpp"
#include "hmi/session/message_log.hpp"

namespace psicarve::session {

/// A record of a core's journal as a row among the window's messages. `core_pid`: of the core that wrote it;
/// 0: not known. Trusts no value of the record.
Message journal_message(const history::LogEntry& entry, std::uint32_t core_pid);

}  // namespace psicarve::session
