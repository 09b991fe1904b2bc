// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "shared/machine/command.hpp"
#include "shared/record/journal.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {

/// Which axis, what the sensors said and where all stood.
JournalFacts facts_of_alarm(const cycle::Report& report);
/// What was asked for, in numbers as they were sent, and by whom. Trusts nothing in it.
JournalFacts facts_of_command(const ReceivedCommand& received);
JournalFacts facts_of_job(const LoadedJob& job);
/// How far the job at hand has come.
void add_progress(JournalFacts& facts, const cycle::Sample& sample);

}  // namespace psicarve::supervisor
