// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/phrase/phrase.hpp"
#include "hmi/report/model_findings.hpp"
#include "hmi/session/piece_view.hpp"
#include "hmi/session/reach_report.hpp"
#include "hmi/session/run_watch.hpp"

namespace psicarve::session {

/// A mesh's facts, a line each: its size (turned as it will stand), facets and volume, whether its surface is
/// closed or what is wrong with it, and its units where they are hardly mm.
std::vector<Phrase> mesh_lines(const model::Mesh& mesh, const std::array<double, 3>& size);

/// What is known of a model so far.
struct ModelKnowledge {
    const model::Mesh& mesh;
    const ReachReport* reach = nullptr;               ///< null: being calculated
    const report::ModelFindings* findings = nullptr;  ///< null: being calculated
    const PieceView* piece = nullptr;                 ///< null: being calculated, or there is none
    Phrase no_piece;
    std::optional<double> sliced_undercut_share{};  ///< the job's value; else the reach's is near
};
/// The report of a model, as `psicarve inspect` prints it: its mesh, its size, what is hidden and open and
/// where, and what the tool leaves.
std::vector<ReportRow> model_rows(const ModelKnowledge& known);

}  // namespace psicarve::session
