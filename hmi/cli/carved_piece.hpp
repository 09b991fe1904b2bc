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

/// What is asked for of the piece that the tools leave. Empty: no such file.
struct PieceFiles {
    std::string model;    ///< that a job was sliced from, to compare with
    std::string mesh;     ///< .stl or .ply
    std::string picture;  ///< of its deviation from the model, .png
    bool any() const noexcept { return !model.empty() || !mesh.empty() || !picture.empty(); }
};
void add_piece_options(Syntax& syntax, PieceFiles& files);
/// Before the work: wrong names, folders that cannot be written.
Result<void> check_piece_files(const PieceFiles& files);

/// The piece, carved in simulation with the tool's shape while the pins are judged, by a thread of its own.
class CarvedPiece {
public:
    /// Nothing when no file is asked for and there is no model. With a model the piece is compared with it.
    /// The job's blob outlives this.
    static Result<std::unique_ptr<CarvedPiece>> make(const PreparedJob& job,
                                                     std::shared_ptr<const model::Mesh> model,
                                                     const PieceFiles& files);

    /// For the verifier; this outlives it.
    verify::Verifier::Follower follower();
    /// After the verifier is done: compares, writes.
    Result<void> finish();
    /// After finish(); nothing when there is no model.
    const std::optional<piece::PieceDeviation>& deviation() const noexcept { return deviation_; }
    double removed_mm3() const { return stock_.removed_mm3(); }
    const PieceFiles& files() const noexcept { return files_; }

private:
    CarvedPiece(const verify::JobGeometry& geometry, const PreparedJob& job, const PieceFiles& files);
    /// Before anything is carved: what the piece will be compared with.
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

/// Follower of a piece that may not be wanted.
verify::Verifier::Follower follower_of(const std::unique_ptr<CarvedPiece>& piece);
/// What became of it into a run's report: of a job that was carved to its end.
void add_piece(RunReport& report, const std::unique_ptr<CarvedPiece>& piece);

}  // namespace psicarve::cli
