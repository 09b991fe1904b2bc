// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>

namespace psicarve::offsets {

/// Where a machine's work offsets are kept: one file for each segment, and another for its simulated machine.
struct OffsetsPlace {
    /// By the environment. `segment_name` has its slash, as in Segment.
    static OffsetsPlace of(const std::string& segment_name, bool is_simulator);

    std::string path;    ///< empty: nothing is kept
    mode_t mode = 0644;  ///< of a new file
    bool is_kept() const noexcept { return !path.empty(); }
};

}  // namespace psicarve::offsets
