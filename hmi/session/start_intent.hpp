// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "shared/machine/status.hpp"

namespace psicarve::session {

/// Start is two commands: heads to the first point, and carve. Between them this remembers the operator's
/// intent to carve; any other event drops it, so that nothing ever moves because of an old request.
class StartIntent {
public:
    /// The core took `start`; its status showed this heartbeat then.
    void arm(std::uint64_t heartbeat) noexcept {
        is_armed_ = true;
        heartbeat_ = heartbeat;
    }
    void drop() noexcept { is_armed_ = false; }
    bool is_armed() const noexcept { return is_armed_; }
    /// True, once, when the heads wait at the first point: carve now.
    bool take(const CoreStatus& status) noexcept;

private:
    bool is_armed_ = false;
    std::uint64_t heartbeat_ = 0;
};

/// The layer, counted from 0, with which a job continues after this many points; the first once it is done.
constexpr std::uint32_t next_layer(std::uint64_t points_done, std::uint64_t points_total,
                                   std::uint32_t layer_count) noexcept {
    if (layer_count == 0 || points_total < layer_count || points_done >= points_total) return 0;
    return static_cast<std::uint32_t>(points_done / (points_total / layer_count));
}

/// The layer with which the operator would continue: behind what this core has carved, or, for an earlier
/// core, the checkpoint's.
constexpr std::uint32_t layer_to_go_on_with(const CoreStatus& status,
                                            std::optional<std::uint32_t> resumable_layer,
                                            std::uint32_t layer_count) noexcept {
    // A dry run carves nothing: the piece is as it was before.
    if (status.is_dry != 0) return resumable_layer.value_or(0);
    const std::uint32_t next = next_layer(status.points_done, status.points_total, layer_count);
    if (next != 0 || status.job_start_tick != 0) return next;
    return resumable_layer.value_or(0);
}

}  // namespace psicarve::session
