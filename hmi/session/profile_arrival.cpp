// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/profile_arrival.hpp"

#include <utility>

namespace psicarve::session {

void ProfileArrival::fetch(const std::string& path, Told told) {
    is_awaited_ = true;
    queue_.post([this, path, told = std::move(told)]() -> BackgroundQueue::Finish {
        return [this, told, read = load_profile(path)] {
            is_awaited_ = false;
            told(read);
        };
    });
}

}  // namespace psicarve::session
