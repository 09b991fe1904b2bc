// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/unfinished_look.hpp"

#include <algorithm>

namespace psicarve::cli {
namespace {

constexpr std::chrono::seconds kLookAgain{2};

}  // namespace

const std::optional<FoundCheckpoint>& UnfinishedLook::look(const std::string& segment,
                                                           std::optional<bool> is_simulator,
                                                           const CoreKeeping& core,
                                                           std::chrono::milliseconds patience) {
    const auto now = std::chrono::steady_clock::now();
    if (!work_.is_under_way() && now >= next_look_) {
        next_look_ = now + kLookAgain;
        work_.begin([segment, is_simulator, core, folder = folder_] {
            return find_unfinished(segment, is_simulator, folder, core);
        });
    }
    const auto least = std::exchange(has_waited_, true) ? std::chrono::milliseconds{0} : kDiskPatience;
    if (auto seen = work_.take(std::max(patience, least))) {
        found_ = std::move(*seen);
        has_answered_ = true;
    }
    return found_;
}

}  // namespace psicarve::cli
