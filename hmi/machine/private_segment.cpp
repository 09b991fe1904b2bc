// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/private_segment.hpp"

#include <filesystem>
#include <string_view>

#include "shared/computer/process_identity.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::machine {
namespace {

constexpr std::string_view kPrefix = "psicarve-private-";

}  // namespace

std::string private_segment_name() {
    return "/" + named_after_this_process(kPrefix);
}

void remove_stale_private_segments() {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator{"/dev/shm", error}) {
        const std::string name = entry.path().filename().string();
        // Another user's cannot be removed, and stays.
        if (is_named_after_dead_process(name, kPrefix)) (void)Segment::remove("/" + name);
    }
}

}  // namespace psicarve::machine
