// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "shared/machine/command.hpp"
#include "shared/message/message.hpp"
#include "shared/record/journal.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {

/// Which axis, what the sensors showed and where all axes stood.
JournalFacts facts_of_alarm(const cycle::Report& report);
/// The command's numbers as they were sent, and its sender. Trusts none of them.
JournalFacts facts_of_command(const ReceivedCommand& received);
JournalFacts facts_of_job(const LoadedJob& job);
/// Adds a message in English words, and so that readers can say it in others. Nothing for none.
void add_reason(JournalFacts& facts, const Message& why);
/// Adds how far the current job has come.
void add_progress(JournalFacts& facts, const cycle::Sample& sample);

}  // namespace psicarve::supervisor
