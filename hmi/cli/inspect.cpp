// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/model_report.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/piece/draft_piece.hpp"
#include "hmi/piece/preview_picture.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/file/atomic_file.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kInspectText{
    "inspect", "Look at a model before it is sliced",
    "Tells what its mesh is made of and what is wrong with it, how it would stand, what no tool reaches from "
    "outside and what\nthe profile's tool leaves; writes no job.",
    "psicarve inspect figurine.stl --fit --tool ball:3 --preview figurine.png"};

struct InspectOptions {
    std::string path;
    bool is_draft = false;
    std::string preview;
    ModelOptions model;
};

std::vector<std::string> draft_lines(const PlacedBody& body, const piece::DraftPiece& draft) {
    const auto line = [](const char* pattern, auto... values) {
        std::array<char, 160> text{};
        std::snprintf(text.data(), text.size(), pattern, values...);
        return std::string(text.data());
    };
    const piece::PieceDeviation& deviation = draft.deviation;
    return {
        line("draft      %zu x %zu samples, scale %.4g", draft.piece.row_count(), draft.piece.column_count(),
             body.model.scale),
        line("tool       %s: leaves at most %.2f mm,", tool::name_of(body.profile.tool).c_str(),
             deviation.leftover.max_mm),
        line("           at %.0f deg, %.1f mm; on average %.3f mm", deviation.leftover.direction_deg,
             deviation.leftover.height_mm, deviation.leftover.mean_mm),
        line("           more than 0.1 mm on %.2f %% of it", 100.0 * piece::leftover_share(deviation, 0.1)),
        line("allowance  %.3f mm for what is between samples", draft.allowance_mm)};
}

Result<int> sketch(const CommonOptions& common, const InspectOptions& options) {
    const auto body = place_body(options.path, options.model, common);
    if (!body) return body.error();
    if (body->profile.tool.shape == ToolShape::point)
        return Error{ErrorCode::bad_usage,
                     "--draft shows what a tool leaves, and a point leaves nothing: "
                     "--tool says which"};
    ProgressBar bar{"drafting"};
    const auto draft =
        piece::draft_piece(body->model, body->profile,
                           {std::max(1U, std::thread::hardware_concurrency()), [&bar](double done_ratio) {
                                bar.update(done_ratio);
                                return true;
                            }});
    if (!draft) return draft.error();
    const std::string& name = body->model.mesh->source_name;
    const std::vector<std::string> lines = draft_lines(*body, *draft);
    if (!options.preview.empty()) {
        std::vector<std::size_t> rows(draft->piece.row_count());
        std::iota(rows.begin(), rows.end(), std::size_t{0});
        const auto png = piece::preview_png(draft->piece, rows, body->profile.blank,
                                            {name, lines, body->model.mesh->warnings});
        if (!png) return png.error();
        if (const auto done = write_file_atomically(options.preview, *png); !done) return done.error();
    }
    clear_progress_line();
    if (common.json) {
        const nlohmann::ordered_json object{
            {"source", name},
            {"scale", body->model.scale},
            {"samples", {draft->piece.row_count(), draft->piece.column_count()}},
            {"allowance_mm", draft->allowance_mm},
            {"expected", nlohmann::ordered_json::parse(piece::deviation_json(draft->deviation))}};
        std::printf("%s\n",
                    object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
        return kExitDone;
    }
    for (const std::string& text : lines) std::printf("%s\n", text.c_str());
    return kExitDone;
}

Result<int> inspect(const CommonOptions& common, const InspectOptions& options) {
    if (const auto writable = check_preview(options.preview); !writable) return writable.error();
    if (is_snapshot_file(options.path)) return bad_input(options.path + ": is a job already, not a model");
    if (options.is_draft) return sketch(common, options);
    ModelOptions model = options.model;
    model.keeps_mesh = true;
    model.compares_axes = true;
    const auto job = prepare_job(options.path, model, common);
    if (!job) return job.error();
    const auto report = ModelReport::make(*job);
    if (!report) return report.error();
    if (const auto drawn = report->write_preview(options.preview); !drawn) return drawn.error();
    clear_progress_line();
    std::printf("%s\n", (common.json ? report->json() : report->text()).c_str());
    return kExitDone;
}

}  // namespace

void add_inspect(CommandSet& commands) {
    const auto options = std::make_shared<InspectOptions>();
    Syntax syntax = commands.add(
        kInspectText, [options](const CommonOptions& common) { return inspect(common, *options); });
    syntax.input("MODEL", options->path, "A mesh, drawing, picture or table, as slice takes them")
        .option("--preview", options->preview, "OUT.png",
                "Draw the piece that the profile's tool would leave, from two sides, and the report");
    syntax.flag("--draft", options->is_draft,
                "What the tool would leave, soon told, by samples of the model alone: no layers, no job");
    add_model_options(syntax, options->model);
}

}  // namespace psicarve::cli
