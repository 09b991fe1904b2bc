// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// The place with which the button that starts the job begins: where the piece of the published job goes on,
/// or where the heads wait; nothing: with the first layer. A dry run begins there, too.
std::optional<StartPlace> place_to_begin_with(const MachineView& machine, const OpenJobView& job,
                                              bool is_dry);
/// That button's text: "Start", "Continue from layer 132, point 57", "Start dry run".
Phrase start_text(const MachineView& machine, const OpenJobView& job, bool is_dry);

/// A piece of the published job that was begun and is not finished.
struct UnfinishedPiece {
    std::uint32_t carved_layers = 0;   ///< carved layers of the last run; 0: it finished none
    std::uint32_t earlier_layers = 0;  ///< carved layers of the run before, if it came further; else 0
    std::uint32_t layer_count = 0;
    /// Up to which the layer behind these is carved, too, from 0; nothing: it is not known.
    std::optional<std::uint32_t> next_point{};

    friend bool operator==(const UnfinishedPiece&, const UnfinishedPiece&) = default;
};
/// Nothing: there is none, it is being carved, or another job is open.
std::optional<UnfinishedPiece> unfinished_piece(const MachineView& machine, const OpenJobView& job);

/// "Unfinished: 131 of 200 layers are carved".
Phrase unfinished_title(const UnfinishedPiece& piece);
/// Sentences for the operator: the last good layer and point, where the run ended, what has to be done first,
/// on which way the heads come to the layer, and how far the run before came. `job`: the published one; null:
/// not known.
std::vector<Phrase> unfinished_details(const UnfinishedPiece& piece, const MachineView& machine,
                                       const cam::PreparedJob* job);

/// The essential ones of them in few words: what has to be done first, and how far the run before came.
std::vector<Phrase> unfinished_needs(const UnfinishedPiece& piece, const MachineView& machine);

/// The job's surface unrolled, highest layer first, 0xFFRRGGBB: coloured by radius where its finishing pass
/// is carved, and `rest_rgb` above: roughed layers have no such radius yet.
struct CarvedPicture {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<std::uint32_t> rgb;
};
CarvedPicture carved_picture(const cam::PreparedJob& job, std::uint32_t carved_layers,
                             std::uint32_t rest_rgb);

/// The question before a partly carved job is begun anew.
Phrase anew_question(const UnfinishedPiece& piece);

}  // namespace psicarve::session
