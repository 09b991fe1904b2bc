// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/layer_cursor.hpp"

#include <algorithm>

namespace psicarve::session {

void LayerCursor::put(TablePlace place) noexcept {
    place_ = {std::min(place.layer, layer_count_ - 1), std::min(place.point, point_count_ - 1)};
}

void LayerCursor::begin(std::uint32_t layer_count, std::uint32_t point_count) {
    layer_count_ = layer_count;
    point_count_ = point_count;
    follows_ = true;
    put(place_);
}

void LayerCursor::choose_layer(std::uint32_t layer) {
    follows_ = follows_ && !is_at_job_;
    put({layer, place_.point});
}

void LayerCursor::choose_point(std::uint32_t point) {
    follows_ = follows_ && !is_at_job_;
    put({place_.layer, point});
}

void LayerCursor::note_machine(const std::optional<TablePlace>& machine) {
    if (!machine) follows_ = true;
    is_at_job_ = machine.has_value();
    if (machine && follows_) put(*machine);
}

}  // namespace psicarve::session
