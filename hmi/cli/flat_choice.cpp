// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/flat_choice.hpp"

#include <charconv>
#include <cmath>

#include "hmi/model/load_mesh.hpp"

namespace psicarve::cli {

void add_flat_options(Syntax& syntax, FlatChoice& choice) {
    syntax
        .flag("--relief", choice.is_relief,
              "The model is a picture that is wrapped round a cylinder (as every picture)")
        .option("--engrave", choice.engrave_mm, "MM",
                "Drawing: cut its lines so deep into a cylinder, in grooves of the tool's width")
        .option("--start", choice.start, "DEG",
                "Engraved drawing: the direction where the leftmost of its lines stands (default 0)")
        .flag("--stroke-width", choice.follows_strokes,
              "Engraved SVG: grooves are as wide as its strokes, at least as the tool")
        .option("--diameter", choice.diameter_mm, "MM",
                "Scale a mesh or a drawing's body, uniformly, so that it reaches half as far from its axis. "
                "Picture, engraved drawing: of the cylinder (default 40; of a drawing the blank's, if known)")
        .option("--depth", choice.depth_mm, "MM", "Picture: how deep black lies (default 2)")
        .option_from_zero("--white-depth", choice.white_depth_mm, "MM",
                          "Picture: how deep white lies (default 0)")
        .flag("--invert", choice.is_inverted, "Picture: black and white change places")
        .option(
            "--gamma", choice.gamma, "G",
            "Picture: brightness (0 to 1), after --invert, to this power before it becomes depth (default 1)")
        .option("--smooth", choice.smooth_mm, "MM", "Picture: smooth it over so far (sigma of a Gaussian)")
        .flag("--full-turn", choice.is_full_turn,
              "Picture: all round even with --height; else its shape is kept and the rest stays white. "
              "Engraved drawing: scaled to go all round")
        .choice("--seam", choice.seam, {"warn", "blend"},
                "Picture: tell of edges that do not meet (default), or make them meet smoothly");
}

namespace {

/// Whether an option for pictures alone is given.
bool has_any_of_pictures(const FlatChoice& choice) {
    return choice.is_relief || choice.is_inverted || choice.depth_mm || choice.white_depth_mm ||
           choice.gamma || choice.smooth_mm || !choice.seam.empty();
}

Result<void> check_kind(const FlatChoice& choice, flat::ModelKind kind, const std::string& path) {
    const bool is_picture = kind == flat::ModelKind::picture;
    const bool is_engraved = kind == flat::ModelKind::drawing && choice.engrave_mm;
    if (!is_picture && has_any_of_pictures(choice)) {
        return Error{ErrorCode::bad_usage,
                     path +
                         " is not a picture (PNG, JPEG, TIFF, BMP, PGM): --relief, --depth, --white-depth, "
                         "--invert, --gamma, --smooth and --seam are for pictures"};
    }
    if (!is_picture && !is_engraved && choice.is_full_turn)
        return Error{ErrorCode::bad_usage,
                     path + ": --full-turn is for pictures, and for drawings with --engrave"};
    if (kind != flat::ModelKind::drawing && choice.engrave_mm)
        return Error{ErrorCode::bad_usage, path + " is not a drawing (SVG, DXF): --engrave is for its lines"};
    if (!is_engraved && (!choice.start.empty() || choice.follows_strokes))
        return Error{ErrorCode::bad_usage, path + ": --start and --stroke-width are for --engrave"};
    return {};
}

Result<double> start_of(const std::string& text) {
    double start_deg = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), start_deg);
    const bool is_number = error == std::errc{} && end == text.data() + text.size();
    if (text.empty() || (is_number && std::isfinite(start_deg))) return start_deg;
    return Error{ErrorCode::bad_usage, "--start: '" + text + "' is not a direction in degrees (as in 45)"};
}

}  // namespace

bool has_any(const FlatChoice& choice) {
    return has_any_of_pictures(choice) || choice.is_full_turn || choice.diameter_mm || choice.engrave_mm ||
           !choice.start.empty() || choice.follows_strokes;
}

Result<flat::FlatOptions> flat_options(const FlatChoice& choice, flat::ModelKind kind, const Profile& profile,
                                       const std::string& path) {
    if (auto good = check_kind(choice, kind, path); !good) {
        // A file that counts as a mesh may be of no kind that is read.
        const auto known = kind == flat::ModelKind::mesh ? model::check_is_mesh(path) : Result<void>{};
        return known ? good.error() : known.error();
    }
    flat::FlatOptions options;
    options.diameter_mm = choice.diameter_mm;
    options.is_full_turn = choice.is_full_turn;
    if (choice.engrave_mm) {
        const auto start_deg = start_of(choice.start);
        if (!start_deg) return start_deg.error();
        options.engraving = {*choice.engrave_mm, *start_deg, choice.follows_strokes, profile.tool};
        if (!choice.diameter_mm && profile.blank.radius_mm > 0.0)
            options.diameter_mm = 2.0 * profile.blank.radius_mm;
    }
    options.depth_mm = choice.depth_mm.value_or(options.depth_mm);
    options.white_depth_mm = choice.white_depth_mm.value_or(options.white_depth_mm);
    options.gamma = choice.gamma.value_or(options.gamma);
    options.smooth_mm = choice.smooth_mm.value_or(options.smooth_mm);
    options.is_inverted = choice.is_inverted;
    options.blends_seam = choice.seam == "blend";
    return options;
}

}  // namespace psicarve::cli
