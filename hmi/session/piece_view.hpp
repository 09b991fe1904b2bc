// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/piece/job_piece.hpp"
#include "hmi/scene/mesh_scene.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// How a piece is drawn.
struct PieceScenePlan {
    std::size_t most_round = 480;  ///< vertices; each of a finer piece shows the worst of its cells
    std::size_t most_up = 400;
    std::size_t coarse_step = 2;    ///< one of this many vertices is in the coarse facets
    std::uint32_t neutral_rgb = 0;  ///< within a pulse of the model
    std::uint32_t blank_rgb = 0;    ///< for parts that no layer carves
};

/// The expected piece, for display. Lengths in mm.
struct PieceView {
    /// Coloured by the deviation from the model, if there is one, else by radius. Its middle is the middle of
    /// the blank on the axis; upright.
    std::shared_ptr<const MeshScene> scene;
    bool has_model = false;  ///< it was compared with a model
    double reach_mm = 0.0;   ///< deviation: the colour scale's end on either side
    double pulse_mm = 0.0;   ///< deviation: neutral within this
    double least_mm = 0.0;   ///< radius: the colour scale's ends
    double most_mm = 0.0;
    std::optional<double> draft_allowance_mm;  ///< for a draft: its tips were kept this much further out
    std::optional<piece::PieceDeviation> deviation;  ///< without its places
    double within_pulse_share = 0.0;
    double removed_mm3 = 0.0;
};

/// `pulse_mm`: of a head.
PieceView look_at_piece(const piece::JobPiece& piece, double pulse_mm, const PieceScenePlan& plan);

/// The text about it, in lines.
std::vector<Phrase> piece_lines(const PieceView& piece_view);

/// What an expected piece can be made of, and why it cannot.
enum class PieceSource : std::uint8_t { none, job, draft };
struct PieceChoice {
    PieceSource source = PieceSource::none;
    Phrase reason;  ///< why there is none
};
/// For the open file: a job's tables give the piece; before there are any a draft does, of a mesh and a tool
/// that has a size. Engraved lines have the tool's shape only in their tables.
PieceChoice piece_choice(bool has_job, bool has_mesh, bool is_engraved, ToolShape tool);

}  // namespace psicarve::session
