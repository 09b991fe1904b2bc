// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve {

/// Gives /dev/null to those of descriptors 0, 1 and 2 that are closed: otherwise the next file that is opened
/// gets such a number, and what is said on standard output is written into it. Call it before any file is
/// opened.
void keep_standard_descriptors_taken() noexcept;

/// Where standard input is a pipe, closes all further descriptors of this process into which could be
/// written to it. Who holds such a one, inherited from a shell, waits for its own input's end for ever. Not
/// beside other threads.
void close_writing_ends_of_standard_input() noexcept;

}  // namespace psicarve
