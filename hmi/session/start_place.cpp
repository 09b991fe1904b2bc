// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/start_place.hpp"

#include <cmath>
#include <string>

#include "hmi/scene/radius_map.hpp"
#include "hmi/session/display_text.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {

std::optional<StartPlace> place_to_go_on(const MachineView& machine) noexcept {
    if (!machine.resumable_layer && !machine.resumable_point) return std::nullopt;
    return StartPlace{machine.resumable_layer.value_or(0), machine.resumable_point};
}

StartPlace waiting_place(const MachineView& machine, std::uint32_t layer_count) noexcept {
    const CoreStatus& status = *machine.status;
    const std::uint64_t layer_points = layer_count == 0 ? 0 : status.points_total / layer_count;
    // The point at which they wait is counted.
    const bool is_within = layer_points > 1 && status.points_done % layer_points > 1;
    return {status.layer, is_within ? std::optional{status.point} : std::nullopt};
}

Command start_command(const MachineView& machine, const StartPlace& from, std::uint32_t layers,
                      bool is_dry) noexcept {
    Command command{};
    command.kind = CommandKind::start;
    command.value = from.layer;
    command.value2 = layers;
    if (from.point) set_start_point(command, *from.point);
    if (is_dry) command.axis = kStartsDry;
    if (is_dry || layers != 0) return command;
    if (from.point && place_to_go_on(machine) == from) command.axis = kStartResumes | kStartResumesWithin;
    if (!from.point && machine.resumable_layer == from.layer) command.axis = kStartResumes;
    return command;
}

Phrase start_name(const StartPlace& from) {
    if (!from.point) return phrase("Start");
    return phrase("Start from layer %1, point %2", std::to_string(from.layer + 1),
                  std::to_string(*from.point + 1));
}

Phrase continue_text(const StartPlace& place) {
    const std::string layer = std::to_string(place.layer + 1);
    if (!place.point) return phrase("Continue from layer %1", layer);
    return phrase("Continue from layer %1, point %2", layer, std::to_string(*place.point + 1));
}

Phrase approach_text(const cam::PreparedJob& job, const StartPlace& place) {
    constexpr int kWayDecimals = 2;
    const std::uint32_t begin = carved_point(job.view.joining(), job.view.point_count(), place.layer, 0);
    const std::uint32_t point = place.point.value_or(begin);
    const LayerCurves curves = layer_curves(job, place.layer);
    const double y_mm = mm_from_pulses(job.view.y_pulses(place.layer, point), job.profile.y.pulses_per_mm);
    return phrase("Then: heads out, Ψ to %1°, Y to %2 mm, spindle on, heads in to R1 %3, R2 %4 mm.",
                  number_text(std::fmod(curves.psi_deg[point], kDegPerRev), kWayDecimals),
                  number_text(y_mm, kWayDecimals), number_text(curves.r1_mm[point], kWayDecimals),
                  number_text(curves.r2_mm[point], kWayDecimals));
}

bool is_place_of(const cam::PreparedJob& job, const StartPlace& place) noexcept {
    const std::uint32_t count = job.view.point_count();
    if (place.layer >= job.view.layer_count()) return false;
    if (!place.point) return true;
    return *place.point < count &&
           carved_point(job.view.joining(), count, place.layer, *place.point) + 1 < count;
}

}  // namespace psicarve::session
