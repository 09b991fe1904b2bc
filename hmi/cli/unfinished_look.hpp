// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "hmi/machine/loose_work.hpp"
#include "shared/record/saved_checkpoint.hpp"

namespace psicarve::cli {

/// So long somebody who asks for something else waits for a disk.
inline constexpr std::chrono::milliseconds kDiskPatience{1000};

/// What disks know of an unfinished piece, for whoever must not wait for them: one that hangs is silent.
class UnfinishedLook {
public:
    /// `folder`: where cores keep it; empty: where they do by themselves.
    explicit UnfinishedLook(std::string folder) : folder_(std::move(folder)) {}

    /// Of a core's kind of machine; nothing: of any. `core`: where that keeps it, which goes before all else
    /// (Segment::core_keeping). Waits at most so long, and the first time at least
    /// kDiskPatience, or it would say that nothing is known before it has asked; what was seen a while ago is
    /// looked at anew meanwhile.
    const std::optional<FoundCheckpoint>& look(const std::string& segment, std::optional<bool> is_simulator,
                                               const CoreKeeping& core, std::chrono::milliseconds patience);
    /// It has not answered yet: nothing is known.
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
