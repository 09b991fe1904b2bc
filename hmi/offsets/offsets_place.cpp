// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/offsets/offsets_place.hpp"

#include "shared/file/state_place.hpp"

namespace psicarve::offsets {
namespace {

constexpr mode_t kForOwner = 0644;
constexpr mode_t kForGroup = 0664;

}  // namespace

OffsetsPlace OffsetsPlace::of(const std::string& segment_name, bool is_simulator) {
    const OffsetsFolder folder = offsets_folder();
    if (folder.path.empty()) return {};
    const StateNames names{folder.path, segment_name, is_simulator};
    return {names.offsets(), folder.is_shared ? kForGroup : kForOwner};
}

}  // namespace psicarve::offsets
