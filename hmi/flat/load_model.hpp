// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::flat {

inline constexpr double kUsualHeight_mm = 20.0;
inline constexpr double kUsualDiameter_mm = 40.0;

/// Line art cut into a cylinder, instead of an extruded outline.
struct Engraving {
    double depth_mm = 1.0;
    double start_deg = 0.0;        ///< direction of the leftmost of the drawing's lines
    bool follows_strokes = false;  ///< grooves are as wide as the drawing's strokes, at least the tool
    ToolProfile tool;              ///< the tool that makes the grooves
};

/// How a drawing or picture becomes a body.
struct FlatOptions {
    /// Of the body. Default: 20 mm for an outline; for a picture, the height that keeps its shape when it
    /// goes all round.
    std::optional<double> height_mm;
    double scale = 1.0;                  ///< of a drawing's lengths
    std::optional<Engraving> engraving;  ///< of a drawing

    // For pictures; the first two for line art as well:
    std::optional<double> diameter_mm;  ///< of the cylinder; default 40
    /// All round: a picture even when a height is given (its shape changes), line art scaled to it.
    bool is_full_turn = false;
    double depth_mm = 2.0;  ///< depth of black below the cylinder
    double white_depth_mm = 0.0;
    double gamma = 1.0;      ///< brightness to this power gives the depth
    double smooth_mm = 0.0;  ///< sigma of a Gaussian; 0: none
    bool is_inverted = false;
    bool blends_seam = false;
};

/// Writes one JSON object, and reads it; a missing key keeps its default.
std::string flat_options_json(const FlatOptions& options);
FlatOptions flat_options_from_json(const std::string& json);

enum class ModelKind : std::uint8_t { mesh, drawing, picture };

/// By the file's first bytes, and where these do not decide by its name. A file that cannot be opened counts
/// as a mesh: loading it says why.
ModelKind kind_of_model(const std::string& path);

/// Whether a drawing has only open strokes: it cannot be extruded, but its lines can be engraved.
bool has_only_open_lines(const std::string& path);

/// Loads any model: a mesh as it is (the options do not apply), a drawing extruded or with its lines
/// engraved, a picture wrapped round a cylinder whose lower end is at height 0.
Result<model::Mesh> load_model(const std::string& path, const FlatOptions& options);

}  // namespace psicarve::flat
