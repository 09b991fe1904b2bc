// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/carved_piece.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>

#include "hmi/cam/slice_report.hpp"
#include "hmi/cli/judged_pins.hpp"
#include "hmi/piece/deviation_picture.hpp"
#include "hmi/piece/piece_mesh.hpp"
#include "hmi/tool/tool.hpp"

namespace psicarve::cli {
namespace {

// Cells once round: enough for a mesh to look at, and for figures.
constexpr std::size_t kMeshColumns = 1440;
constexpr std::size_t kFigureColumns = 720;

bool is_of_table(const JobView& job) {
    const auto report = nlohmann::json::parse(job.report_json(), nullptr, false);
    return report.is_object() && report.value("format", std::string{}) == cam::kTableFormat;
}

}  // namespace

void add_piece_options(Syntax& syntax, PieceFiles& files) {
    syntax
        .option(
            "--model", files.model, "MODEL",
            "The file that the job was sliced from: tell how far the piece that the profile's tool leaves is "
            "from it")
        .option("--piece", files.mesh, "FILE",
                "Write what the profile's tool leaves of its blank as a mesh: .stl or .ply")
        .option(
            "--deviation", files.picture, "OUT.png",
            "Draw how far the piece that the profile's tool leaves is from the model: gouges, what is left "
            "over, histogram");
}

Result<void> check_piece_files(const PieceFiles& files) {
    for (const std::string& path : {files.mesh, files.picture}) {
        if (const auto writable = check_output_folder(path); !writable) return writable.error();
    }
    if (!files.picture.empty() && !files.picture.ends_with(".png") && !files.picture.ends_with(".PNG"))
        return bad_input(files.picture + ": the deviation is drawn as .png");
    if (files.mesh.empty()) return {};
    if (const auto format = piece::mesh_format_of(files.mesh); !format) return format.error();
    return {};
}

CarvedPiece::CarvedPiece(const verify::JobGeometry& geometry, const PreparedJob& job, const PieceFiles& files)
    : geometry_(geometry),
      model_name_(job.view.source_name()),
      files_(files),
      stock_(piece::blank_of(geometry, job.profile, files.mesh.empty() ? kFigureColumns : kMeshColumns)),
      rows_(piece::carved_rows(geometry, stock_, job.profile.tool.shape == ToolShape::point)) {}

Result<void> CarvedPiece::compare_with(std::shared_ptr<const model::Mesh> model, const PreparedJob& job) {
    const auto placed = piece::place_as_sliced(std::move(model), job.view, job.profile);
    if (!placed) return placed.error();
    auto wanted =
        piece::wanted_radii(*placed, stock_, {std::max(1U, std::thread::hardware_concurrency()), {}});
    if (!wanted) return wanted.error();
    wanted_mm_ = std::move(*wanted);
    ridges_.emplace(*placed, tool::tool_of(job.profile.tool, 1.0), stock_, wanted_mm_, rows_, geometry_);
    return {};
}

Result<std::unique_ptr<CarvedPiece>> CarvedPiece::make(const PreparedJob& job,
                                                       std::shared_ptr<const model::Mesh> model,
                                                       const PieceFiles& files) {
    if (!files.any() && !model) return std::unique_ptr<CarvedPiece>{};
    const auto geometry = verify::JobGeometry::make(job.view, job.profile);
    if (!geometry) return bad_input(std::string(job.view.source_name()) + ": " + geometry.error().message);
    std::unique_ptr<CarvedPiece> made{new CarvedPiece{*geometry, job, files}};
    if (model) {
        if (auto done = made->compare_with(std::move(model), job); !done) return done.error();
    } else if (!files.picture.empty()) {
        if (is_of_table(job.view)) {
            return Error{ErrorCode::bad_usage, "--deviation compares with a model, and " +
                                                   std::string(job.view.source_name()) +
                                                   " is a table of radii, which has none"};
        }
        return Error{ErrorCode::bad_usage,
                     "--deviation compares with the model, which a job does not hold: --model MODEL says "
                     "what it was sliced from"};
    }
    made->carver_.emplace(*geometry, job.profile, made->stock_, made->ridges_ ? &*made->ridges_ : nullptr);
    made->thread_.emplace(*made->carver_);
    return made;
}

verify::Verifier::Follower CarvedPiece::follower() {
    return [this](const auto& positions, bool spindle_on) { thread_->settle(positions, spindle_on); };
}

Result<void> CarvedPiece::finish() {
    thread_->finish();
    if (ridges_) deviation_ = piece::deviation_of(stock_, wanted_mm_, rows_, &*ridges_, {}).value();
    if (!files_.mesh.empty()) {
        if (const auto done = piece::write_piece(files_.mesh, stock_); !done) return done.error();
    }
    if (files_.picture.empty()) return {};
    return piece::write_deviation_picture(files_.picture, *deviation_, model_name_);
}

verify::Verifier::Follower follower_of(const std::unique_ptr<CarvedPiece>& piece) {
    return piece ? piece->follower() : verify::Verifier::Follower{};
}

void add_piece(RunReport& report, const std::unique_ptr<CarvedPiece>& piece) {
    if (!piece) return;
    if (!report.verification) {
        const PieceFiles& files = piece->files();
        if (!files.any()) return;
        const std::string& first = !files.mesh.empty()      ? files.mesh
                                   : !files.picture.empty() ? files.picture
                                                            : files.model;
        return miss(report, first + ": the piece is not known");
    }
    const auto done = piece->finish();
    if (!done && piece->files().any() && !report.failure) report.failure = done.error();
    if (!done) return;
    report.deviation = piece->deviation();
    report.piece_path = piece->files().mesh;
    report.deviation_path = piece->files().picture;
}

}  // namespace psicarve::cli
