// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/model_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "hmi/cli/hidden_report.hpp"
#include "hmi/piece/placed_model.hpp"
#include "hmi/piece/preview_picture.hpp"
#include "shared/file/atomic_file.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kModelReportColumns = 720;
constexpr double kMm3PerCm3 = 1000.0;

template <typename... Values>
std::string line_of(const char* pattern, Values... values) {
    std::array<char, 240> text{};
    std::snprintf(text.data(), text.size(), pattern, values...);
    return text.data();
}

std::string counted(std::uint64_t count, const char* one, const char* many) {
    return std::to_string(count) + (count == 1 ? one : many);
}

std::string flaw_text(const report::FlawCount& found, const model::MeshFacts& facts) {
    const std::uint64_t count = found.count;
    switch (found.flaw) {
        case report::MeshFlaw::holes:
            return counted(count, " hole", " holes") + " (" +
                   counted(facts.open_edge_count, " open edge)", " open edges)");
        case report::MeshFlaw::turned_edges:
            return counted(count, " edge", " edges") + " between flipped facets";
        case report::MeshFlaw::inside_out:
            return counted(count, " body", " bodies") + " inside out";
        case report::MeshFlaw::degenerate:
            return counted(count, " facet", " facets") + " without area";
        case report::MeshFlaw::duplicate:
            return counted(count, " facet", " facets") + " doubled";
        case report::MeshFlaw::dropped:
            return counted(count, " facet", " facets") + " left out";
    }
    return {};
}

std::string flaws_text(const model::MeshFacts& facts, const model::MeshParts& parts) {
    std::string text;
    for (const report::FlawCount& found : report::flaws_of(facts, &parts))
        text += (text.empty() ? "" : ", ") + flaw_text(found, facts);
    return text.empty() ? "closed, all facets turned alike" : text;
}

/// An open surface has no volume.
std::optional<double> volume_mm3(const model::MeshFacts& facts, double scale) {
    if (!facts.closed || !facts.same_orientation) return std::nullopt;
    return std::abs(facts.signed_volume) * scale * scale * scale;
}

std::string volume_text(const model::MeshFacts& facts, double scale) {
    const auto mm3 = volume_mm3(facts, scale);
    if (!mm3) return facts.closed ? "none: facets are turned both ways" : "none: the mesh is open";
    return *mm3 < kMm3PerCm3 ? line_of("%.4g mm3", *mm3) : line_of("%.2f cm3", *mm3 / kMm3PerCm3);
}

Json mesh_json(const model::Mesh& mesh, const model::MeshParts& parts, double scale) {
    const model::MeshFacts& facts = mesh.facts;
    const auto volume = volume_mm3(facts, scale);
    return {{"format", mesh.format},
            {"triangles", mesh.triangles.size()},
            {"components", parts.components},
            {"inside_out", parts.inside_out},
            {"holes", parts.holes},
            {"open_edges", facts.open_edge_count},
            {"turned_edges", facts.turned_edge_count},
            {"degenerate", facts.degenerate_count},
            {"duplicates", facts.duplicate_count},
            {"dropped", facts.dropped_count},
            {"volume_mm3", volume ? Json(*volume) : Json(nullptr)},
            {"size", {facts.max[0] - facts.min[0], facts.max[1] - facts.min[1], facts.max[2] - facts.min[2]}},
            {"probable_unit", report::probable_unit(facts)}};
}

void append(std::vector<std::string>& lines, const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
}

/// The material that the tool leaves because it does not fit.
Json unreached_json(const piece::PieceDeviation& deviation) {
    return {
        {"over_mm", report::kUnreached_mm},
        {"share", piece::leftover_share(deviation, report::kUnreached_mm)},
        {"largest_mm", deviation.leftover.max_mm},
        {"at",
         {{"direction_deg", deviation.leftover.direction_deg}, {"height_mm", deviation.leftover.height_mm}}}};
}

Json slicer_report(const PreparedJob& job) {
    Json report = Json::parse(job.view.report_json(), nullptr, false);
    return report.is_object() ? report : Json::object();
}

/// ", between 3.0 and 9.5 mm".
std::string heights_text(const Json& report, const char* key) {
    const auto range = report.find(key);
    if (range == report.end() || !range->is_array() || range->size() != 2) return {};
    return line_of(", between %.1f and %.1f mm", (*range)[0].get<double>(), (*range)[1].get<double>());
}

std::vector<std::string> blank_lines(const BlankProfile& blank) {
    if (!(blank.radius_mm > 0.0)) return {};
    const std::string high =
        blank.height_mm > 0.0 ? line_of(", %.2f mm high", blank.height_mm) : std::string{};
    std::vector<std::string> lines{line_of("blank      r %.2f mm", blank.radius_mm) + high};
    if (blank.reach_mm() != blank.radius_mm)
        lines.push_back(
            line_of("           at %.2f, %.2f mm of the table's axis", blank.offset_x_mm, blank.offset_z_mm));
    return lines;
}

}  // namespace

Result<void> check_preview(const std::string& path) {
    if (const auto writable = check_output_folder(path); !writable) return writable;
    if (path.empty() || path.ends_with(".png") || path.ends_with(".PNG")) return {};
    return bad_input(path + ": the preview is drawn as .png");
}

Result<ModelReport> ModelReport::make(const PreparedJob& job) {
    std::optional<piece::PlacedModel> placed;
    if (job.mesh) {
        auto found = piece::place_as_sliced(job.mesh, job.view, job.profile);
        if (!found) return found.error();
        placed = std::move(*found);
    }
    auto expected = piece::job_piece(job.view, job.profile, placed ? &*placed : nullptr, kModelReportColumns,
                                     {std::max(1U, std::thread::hardware_concurrency()), {}});
    if (!expected) return expected.error();
    ModelReport model{job, std::move(*expected)};
    if (!placed) return model;
    auto findings = report::find_in_model(*placed, {std::max(1U, std::thread::hardware_concurrency()), {}});
    if (!findings) return findings.error();
    model.findings_ = std::move(*findings);
    return model;
}

std::vector<std::string> ModelReport::lines() const {
    const Json slicer = slicer_report(*job_);
    std::vector<std::string> lines;
    if (findings_) {
        const model::Mesh& mesh = *job_->mesh;
        lines.push_back("mesh       " + mesh.format + ", " +
                        counted(mesh.triangles.size(), " facet", " facets") + ", " +
                        counted(findings_->parts.components, " body", " bodies"));
        lines.push_back("surface    " + flaws_text(mesh.facts, findings_->parts));
        lines.push_back("volume     " + volume_text(mesh.facts, slicer.value("scale", 1.0)));
        lines.push_back(std::string("unit       probably ") + report::probable_unit(mesh.facts));
    }
    if (const auto box = slicer.find("bounding_box_mm"); box != slicer.end() && box->size() == 3) {
        lines.push_back(line_of("size       %.2f x %.2f x %.2f mm, scale %.4g", (*box)[0].get<double>(),
                                (*box)[1].get<double>(), (*box)[2].get<double>(),
                                slicer.value("scale", 1.0)));
    }
    if (const auto axis = slicer.find("axis"); axis != slicer.end() && axis->size() == 2) {
        lines.push_back(line_of("axis       at %.4g, %.4g of the file, %s up", (*axis)[0].get<double>(),
                                (*axis)[1].get<double>(), slicer.value("up", std::string("z")).c_str()));
    }
    lines.push_back(
        line_of("job        %u layers x %u points", job_->view.layer_count(), job_->view.point_count()));
    append(lines, blank_lines(job_->profile.blank));
    if (slicer.contains("undercut_share")) {  // a table has no walls
        lines.push_back(
            line_of("hidden     %.2f %% of the surface", 100.0 * slicer.value("undercut_share", 0.0)) +
            heights_text(slicer, "undercut_heights_mm"));
    }
    if (findings_) append(lines, hidden_lines(findings_->hidden));
    if (slicer.contains("open_points")) {
        const std::uint64_t open_points = slicer.value("open_points", std::uint64_t{0});
        lines.push_back(line_of("open       %llu %s", static_cast<unsigned long long>(open_points),
                                open_points == 1 ? "sample" : "samples") +
                        heights_text(slicer, "open_heights_mm"));
    }
    if (findings_) append(lines, open_lines(findings_->hidden));
    if (expected_.deviation) {
        lines.push_back("tool       " + slicer.value("tool", std::string("point")) +
                        line_of(": leaves at most %.3f mm,", expected_.deviation->leftover.max_mm));
        lines.push_back(line_of("           on average %.3f mm, gouges %.3f mm",
                                expected_.deviation->leftover.mean_mm, expected_.deviation->gouge.max_mm));
        lines.push_back(line_of("           more than %.1f mm on %.2f %% of it", report::kUnreached_mm,
                                100.0 * piece::leftover_share(*expected_.deviation, report::kUnreached_mm)));
    }
    return lines;
}

std::string ModelReport::text() const {
    std::string text;
    for (const std::string& line : lines()) text += (text.empty() ? "" : "\n") + line;
    return text;
}

std::string ModelReport::json() const {
    const Json slicer = slicer_report(*job_);
    Json object{{"source", std::string{job_->view.source_name()}}};
    object["mesh"] =
        findings_ ? mesh_json(*job_->mesh, findings_->parts, slicer.value("scale", 1.0)) : Json(nullptr);
    object["report"] = slicer;
    object["hidden"] = findings_ ? Json::parse(hidden_json(findings_->hidden)) : Json(nullptr);
    object["unreached"] = expected_.deviation ? unreached_json(*expected_.deviation) : Json(nullptr);
    object["expected"] =
        expected_.deviation ? Json::parse(piece::deviation_json(*expected_.deviation)) : Json(nullptr);
    return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<void> ModelReport::write_preview(const std::string& path) const {
    if (path.empty()) return {};
    const auto png = piece::preview_png(expected_.piece, piece::shown_rows(expected_), job_->profile.blank,
                                        {std::string{job_->view.source_name()}, lines(), job_->warnings});
    if (!png) return png.error();
    return write_file_atomically(path, *png);
}

}  // namespace psicarve::cli
