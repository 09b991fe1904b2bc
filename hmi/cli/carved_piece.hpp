// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hmi/cli/command_set.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/run_report.hpp"
#include "hmi/piece/carving_thread.hpp"
#include "hmi/piece/piece_carver.hpp"
#include "hmi/piece/piece_deviation.hpp"
#include "hmi/piece/placed_model.hpp"
#include "hmi/piece/ridges.hpp"
#include "hmi/verify/verifier.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// The files asked for of the carved piece. Empty: no such file.
struct PieceFiles {
    std::string model;    ///< of the job, to compare with
    std::string mesh;     ///< .stl or .ply
    std::string picture;  ///< of the piece's deviation from the model, .png
    bool any() const noexcept { return !model.empty() || !mesh.empty() || !picture.empty(); }
};
void add_piece_options(Syntax& syntax, PieceFiles& files);
/// Before the work: refuses wrong names, and folders that cannot be written.
Result<void> check_piece_files(const PieceFiles& files);

/// The piece, carved in simulation with the tool's shape while the pins are judged, in a thread of its own.
class CarvedPiece {
public:
    /// Null when no file is asked for and there is no model. With a model the piece is compared with it. The
    /// job's blob outlives this.
    static Result<std::unique_ptr<CarvedPiece>> make(const PreparedJob& job,
                                                     std::shared_ptr<const model::Mesh> model,
                                                     const PieceFiles& files);

    /// For the verifier; this outlives it.
    verify::Verifier::Follower follower();
    /// After the verifier is done: compares and writes.
    Result<void> finish();
    /// After finish(); nothing when there is no model.
    const std::optional<piece::PieceDeviation>& deviation() const noexcept { return deviation_; }
    double removed_mm3() const { return stock_.removed_mm3(); }
    const PieceFiles& files() const noexcept { return files_; }

private:
    CarvedPiece(const verify::JobGeometry& geometry, const PreparedJob& job, const PieceFiles& files);
    /// Before anything is carved: sets the model for the comparison.
    Result<void> compare_with(std::shared_ptr<const model::Mesh> model, const PreparedJob& job);

    verify::JobGeometry geometry_;
    std::string model_name_;
    PieceFiles files_;
    piece::StockMap stock_;
    std::vector<std::size_t> rows_;
    std::vector<float> wanted_mm_;  ///< of the model
    std::optional<piece::Ridges> ridges_;
    std::optional<piece::PieceCarver> carver_;
    std::optional<piece::CarvingThread> thread_;
    std::optional<piece::PieceDeviation> deviation_;
};

/// The piece's follower, or none where there is no piece.
verify::Verifier::Follower follower_of(const std::unique_ptr<CarvedPiece>& piece);
/// Adds the piece's results to a run's report, if the job was carved to its end.
void add_piece(RunReport& report, const std::unique_ptr<CarvedPiece>& piece);

}  // namespace psicarve::cli
