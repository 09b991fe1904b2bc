// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "hmi/machine/loose_work.hpp"
#include "shared/record/saved_checkpoint.hpp"

namespace psicarve::cli {

/// How long other commands wait for a disk.
inline constexpr std::chrono::milliseconds kDiskPatience{1000};

/// Looks on disks for an unfinished piece without waiting for them: nothing is known from one that hangs.
class UnfinishedLook {
public:
    /// `folder`: where cores keep it; empty: their default folders.
    explicit UnfinishedLook(std::string folder) : folder_(std::move(folder)) {}

    /// For this kind of machine; nothing: for any. `core`: where the core keeps it, which comes first
    /// (Segment::core_keeping). Waits at most this long, but the first time at least kDiskPatience, or it
    /// would find nothing before it has asked; a result from a while ago is returned while it looks again.
    const std::optional<FoundCheckpoint>& look(const std::string& segment, std::optional<bool> is_simulator,
                                               const CoreKeeping& core, std::chrono::milliseconds patience);
    /// The disk has not answered yet: nothing is known.
    bool is_silent() const noexcept { return !has_answered_; }

private:
    std::string folder_;
    machine::LooseWork<std::optional<FoundCheckpoint>> work_;
    std::optional<FoundCheckpoint> found_;
    std::chrono::steady_clock::time_point next_look_{};
    bool has_answered_ = false;
    bool has_waited_ = false;
};

}  // namespace psicarve::cli
