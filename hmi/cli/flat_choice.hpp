// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "hmi/cli/command_set.hpp"
#include "hmi/flat/load_model.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

/// The command line's options for a drawing or picture.
struct FlatChoice {
    bool is_relief = false;
    bool is_inverted = false;
    bool is_full_turn = false;
    std::optional<double> diameter_mm;
    std::optional<double> depth_mm;
    std::optional<double> white_depth_mm;
    std::optional<double> gamma;
    std::optional<double> smooth_mm;
    std::string seam;
    std::optional<double> engrave_mm;
    std::string start;
    bool follows_strokes = false;
};
void add_flat_options(Syntax& syntax, FlatChoice& choice);
bool has_any(const FlatChoice& choice);

/// Leaves out height and scale. Refuses options that do not fit this kind of model. Line art is cut with the
/// profile's tool, into its blank where no diameter is given.
Result<flat::FlatOptions> flat_options(const FlatChoice& choice, flat::ModelKind kind, const Profile& profile,
                                       const std::string& path);

}  // namespace psicarve::cli
