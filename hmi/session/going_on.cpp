// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/going_on.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/scene/radius_map.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/session/saved_piece.hpp"
#include "hmi/session/start_place.hpp"
#include "shared/machine/machine_state.hpp"

namespace psicarve::session {
namespace {

/// Whether the open job is the one that the core has, or had.
bool is_cores_job(const MachineView& machine, const OpenJobView& job) noexcept {
    switch (job.state) {
        case OpenJobState::empty:
        case OpenJobState::published:
            return true;
        case OpenJobState::job:
            return !machine.is_heard() && job.is_of_checkpoint;  // there is no core to accept it
        default:
            return false;
    }
}

/// A job is, or a program; of a core that was lost in a program nothing of a job is offered either.
bool is_under_way(const MachineView& machine) noexcept {
    return machine.runs_program() || (machine.is_heard() && machine.status && machine.runs_job());
}

/// "Last good: layer 131, to its point 201."
Phrase last_good(const UnfinishedPiece& piece, const cam::PreparedJob* job) {
    if (piece.next_point) {
        return phrase("Last good: layer %1, to its point %2.", std::to_string(piece.carved_layers + 1),
                      std::to_string(*piece.next_point + 1));
    }
    const std::string layer = std::to_string(piece.carved_layers);
    if (job == nullptr) return phrase("Last good layer: %1.", layer);
    return phrase("Last good: layer %1, to its point %2.", layer, std::to_string(job->view.point_count()));
}

/// The end of the run that this core carved, or the one before it, where it is not the last good point.
std::optional<Phrase> ended_at(const UnfinishedPiece& piece, const MachineView& machine) {
    if (!machine.status || machine.status->is_dry != 0) return std::nullopt;
    const CoreStatus& status = *machine.status;
    if (status.points_done == 0 || status.points_done >= status.points_total) return std::nullopt;
    if (piece.next_point == status.point && piece.carved_layers == status.layer) return std::nullopt;
    return phrase("It ended in layer %1, point %2.", std::to_string(status.layer + 1),
                  std::to_string(status.point + 1));
}

std::optional<Phrase> to_do_first(const MachineView& machine) {
    if (!machine.is_heard()) return phrase("First start psicarve-rtcore, then Home all.");
    std::string missing;
    for (const Axis axis : kAllAxes) {
        if (!machine.is_homed(axis)) missing += (missing.empty() ? "" : " ") + std::string{axis_letter(axis)};
    }
    if (!missing.empty()) return phrase("First Home all: %1 are not homed.", missing);
    if (machine.state() == MachineState::off) return phrase("First Home all: the drives are off.");
    return std::nullopt;
}

Phrase way_back(const UnfinishedPiece& piece) {
    return phrase(
        "The run before came to layer %1: if its piece is still mounted, From layer %2 "
        "goes on with it.",
        std::to_string(piece.earlier_layers), std::to_string(piece.earlier_layers + 1));
}

}  // namespace

std::optional<StartPlace> place_to_begin_with(const MachineView& machine, const OpenJobView& job,
                                              bool is_dry) {
    if (machine.is_heard() && machine.state() == MachineState::waiting) {
        if (machine.status->is_dry != 0) return std::nullopt;
        const StartPlace place = waiting_place(machine, job.core_layer_count);
        return place == StartPlace{} ? std::nullopt : std::optional{place};
    }
    if (is_dry || is_under_way(machine) || !is_cores_job(machine, job)) return std::nullopt;
    return place_to_go_on(machine);
}

Phrase start_text(const MachineView& machine, const OpenJobView& job, bool is_dry) {
    const bool waits = machine.is_heard() && machine.state() == MachineState::waiting;
    if (waits ? machine.status->is_dry != 0 : is_dry) return phrase("Start dry run");
    const auto place = place_to_begin_with(machine, job, is_dry);
    return place ? continue_text(*place) : phrase("Start");
}

std::optional<UnfinishedPiece> unfinished_piece(const MachineView& machine, const OpenJobView& job) {
    if (is_under_way(machine) || !is_cores_job(machine, job)) return std::nullopt;
    const UnfinishedPiece piece{machine.resumable_layer.value_or(0), machine.earlier_layer.value_or(0),
                                machine.checkpoint_layer_count, machine.resumable_point};
    const bool is_none = piece.carved_layers == 0 && piece.earlier_layers == 0 && !piece.next_point;
    return is_none ? std::nullopt : std::optional{piece};
}

Phrase unfinished_title(const UnfinishedPiece& piece) {
    const std::string count = std::to_string(piece.layer_count);
    if (piece.carved_layers == 0 && piece.earlier_layers == 0)
        return phrase("Unfinished: a part of the first of %1 layers is carved", count);
    if (piece.carved_layers == 0) return phrase("Begun anew: none of %1 layers is finished", count);
    return phrase("Unfinished: %1 of %2 layers are carved", std::to_string(piece.carved_layers), count);
}

std::vector<Phrase> unfinished_details(const UnfinishedPiece& piece, const MachineView& machine,
                                       const cam::PreparedJob* job) {
    std::vector<Phrase> details;
    const bool has_place = piece.carved_layers != 0 || piece.next_point;
    if (has_place) details.push_back(last_good(piece, job));
    if (auto both = disagreement(machine)) details.push_back(*std::move(both));
    if (auto end = ended_at(piece, machine)) details.push_back(*std::move(end));
    if (auto first = to_do_first(machine)) details.push_back(*std::move(first));
    if (const StartPlace place{piece.carved_layers, piece.next_point};
        has_place && job != nullptr && is_place_of(*job, place))
        details.push_back(approach_text(*job, place));
    if (piece.earlier_layers != 0) details.push_back(way_back(piece));
    return details;
}

std::vector<Phrase> unfinished_needs(const UnfinishedPiece& piece, const MachineView& machine) {
    std::vector<Phrase> needs;
    if (auto both = disagreement(machine)) needs.push_back(*std::move(both));
    if (auto first = to_do_first(machine))
        needs.push_back(machine.is_heard() ? phrase("First Home all.") : *std::move(first));
    if (piece.earlier_layers != 0) {
        needs.push_back(phrase("Run before: to layer %1 (From layer %2).",
                               std::to_string(piece.earlier_layers),
                               std::to_string(piece.earlier_layers + 1)));
    }
    return needs;
}

CarvedPicture carved_picture(const cam::PreparedJob& job, std::uint32_t carved_layers,
                             std::uint32_t rest_rgb) {
    constexpr std::size_t kMostColumns = 144;
    constexpr std::size_t kMostRows = 112;
    constexpr std::uint32_t kOpaque = 0xFF000000;
    const RadiusMap map = radius_map(job, kMostColumns, kMostRows);
    CarvedPicture picture{map.columns, map.rows, radius_picture(map, true)};
    const std::uint32_t finishing_layer = job.view.finishing_layer();
    const bool is_some_finished = carved_layers > finishing_layer;
    const double half = 0.5 / (job.view.layer_count() - finishing_layer);
    const double top = is_some_finished ? place_in_map(job.view, carved_layers - 1) + half : 0.0;
    for (std::size_t row = 0; row < map.rows; ++row) {
        const double place = 1.0 - (static_cast<double>(row) + 0.5) / static_cast<double>(map.rows);
        const bool is_lowest = row + 1 == map.rows && is_some_finished;
        if (place <= top || is_lowest) continue;
        const auto begin = picture.rgb.begin() + static_cast<std::ptrdiff_t>(row * map.columns);
        std::fill_n(begin, map.columns, kOpaque | rest_rgb);
    }
    return picture;
}

Phrase anew_question(const UnfinishedPiece& piece) {
    const std::string carved = std::to_string(piece.carved_layers);
    const std::string count = std::to_string(piece.layer_count);
    if (piece.carved_layers == 0 && piece.earlier_layers == 0)
        return phrase("A part of layer 1 of %1 is carved and would be carved again.", count);
    if (piece.carved_layers == 0) {
        return phrase(
            "The run before came to layer %1 of %2: if its piece is still mounted, From layer %3 goes on "
            "with it, and layer 1 carves it again.",
            std::to_string(piece.earlier_layers), count, std::to_string(piece.earlier_layers + 1));
    }
    if (piece.carved_layers == 1) return phrase("Layer 1 of %1 is carved and would be carved again.", count);
    return phrase("Layers 1 to %1 of %2 are carved and would be carved again.", carved, count);
}

}  // namespace psicarve::session
