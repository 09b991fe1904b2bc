// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/piece_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "hmi/scene/colour_map.hpp"
#include "hmi/scene/space_picture.hpp"
#include "hmi/session/display_text.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

constexpr double kLeastReach_pulses = 8.0;
constexpr double kPercent = 100.0;
constexpr double kMm3PerCm3 = 1000.0;
// Pulses are shown with three decimals, radii are kept in float.
constexpr double kSamePulse_ratio = 1.001;

/// Up to two digits that one can read.
double rounded_up(double value) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    constexpr double kExact = 1e-9;
    return step * std::ceil(value / step - kExact);
}

/// The rows of a stock map that are drawn: all but those between the carved ones that no layer reaches, which
/// stand as the blank did.
struct DrawnRows {
    std::vector<std::size_t> stock_row;
    std::vector<std::size_t> carved;  ///< its place among the carved rows, or none

    static constexpr std::size_t kNotCarved = std::numeric_limits<std::size_t>::max();

    explicit DrawnRows(const piece::JobPiece& piece)
        : stock_row(piece::shown_rows(piece)), carved(stock_row.size(), kNotCarved) {
        // Below them there is every row.
        for (std::size_t i = 0; i < piece.rows.size(); ++i) carved[piece.rows.front() + i] = i;
    }
};

/// Cells first .. end - 1 of `count` for vertex `index` of `most`.
std::pair<std::size_t, std::size_t> cells_of(std::size_t index, std::size_t most, std::size_t count) {
    return {index * count / most, std::max(index * count / most + 1, (index + 1) * count / most)};
}

class PieceScene {
public:
    PieceScene(const piece::JobPiece& piece, const PieceScenePlan& plan, const PieceView& seen)
        : piece_(piece),
          plan_(plan),
          view_(seen),
          rows_(piece),
          round_(std::min(piece.piece.column_count(), std::max<std::size_t>(plan.most_round, 3))),
          up_(std::min(rows_.stock_row.size(), std::max<std::size_t>(plan.most_up, 2))) {}

    MeshScene make() const {
        const piece::StockMap& stock = piece_.piece;
        MeshScene scene;
        const double across_mm = 2.0 * stock.blank_radius_mm();
        const double height_mm = stock.row_mm() * static_cast<double>(stock.row_count());
        scene.size = {across_mm, across_mm, height_mm};
        for (std::size_t up = 0; up < up_; ++up) add_row(scene, up);
        // The lid: without it the view looks into the piece.
        scene.vertices.push_back({0.0F, 0.0F, scene.vertices.back()[2]});
        scene.vertex_rgb.push_back(scene.vertex_rgb.back());
        scene.facets = lathe_facets(round_, up_, 1);
        if (plan_.coarse_step > 1) scene.coarse_facets = lathe_facets(round_, up_, plan_.coarse_step);
        return scene;
    }

private:
    void add_row(MeshScene& scene, std::size_t up) const {
        const piece::StockMap& stock = piece_.piece;
        // The outermost ones are the blank's own.
        const std::size_t at = up_ > 1 ? up * (rows_.stock_row.size() - 1) / (up_ - 1) : 0;
        const std::size_t row = rows_.stock_row[at];
        const double middle_mm =
            stock.bottom_mm() + 0.5 * stock.row_mm() * static_cast<double>(stock.row_count());
        const auto height = static_cast<float>(stock.height_mm(row) - middle_mm);
        const auto carved = cells_of(up, up_, rows_.stock_row.size());
        for (std::size_t column = 0; column < round_; ++column) {
            const auto columns = cells_of(column, round_, stock.column_count());
            const double angle_rad = stock.direction_rad(columns.first);
            const float radius = stock.row(row)[columns.first];
            scene.vertices.push_back({radius * static_cast<float>(std::cos(angle_rad)),
                                      radius * static_cast<float>(std::sin(angle_rad)), height});
            scene.vertex_rgb.push_back(colour_of(at, carved, columns, radius));
        }
    }

    std::uint32_t colour_of(std::size_t at, std::pair<std::size_t, std::size_t> rows,
                            std::pair<std::size_t, std::size_t> columns, float radius) const {
        if (rows_.carved[at] == DrawnRows::kNotCarved) return plan_.blank_rgb;
        if (!piece_.deviation) {
            const double span_mm = std::max(view_.most_mm - view_.least_mm, 1e-9);
            return viridis((double{radius} - view_.least_mm) / span_mm);
        }
        const double worst_mm = worst_of(rows, columns);
        if (std::abs(worst_mm) <= kSamePulse_ratio * view_.pulse_mm) return plan_.neutral_rgb;
        return vik(0.5 + 0.5 * worst_mm / view_.reach_mm);
    }

    /// A single bad cell must stay visible among good ones.
    double worst_of(std::pair<std::size_t, std::size_t> rows,
                    std::pair<std::size_t, std::size_t> columns) const {
        const std::vector<float>& distance_mm = piece_.deviation->distance_mm;
        double worst_mm = 0.0;
        for (std::size_t at = rows.first; at < rows.second; ++at) {
            if (rows_.carved[at] == DrawnRows::kNotCarved) continue;
            const std::size_t begin = rows_.carved[at] * piece_.deviation->column_count;
            for (std::size_t column = columns.first; column < columns.second; ++column) {
                const double here_mm = distance_mm[begin + column];
                if (std::abs(here_mm) > std::abs(worst_mm)) worst_mm = here_mm;
            }
        }
        return worst_mm;
    }

    const piece::JobPiece& piece_;
    const PieceScenePlan& plan_;
    const PieceView& view_;
    DrawnRows rows_;
    std::size_t round_;
    std::size_t up_;
};

/// Whole mm around the radii of what is carved.
void take_radii(const piece::JobPiece& piece, PieceView& seen) {
    float least = std::numeric_limits<float>::max();
    float most = 0.0F;
    for (const std::size_t row : piece.rows) {
        const auto [low, high] =
            std::minmax_element(piece.piece.row(row).begin(), piece.piece.row(row).end());
        least = std::min(least, *low);
        most = std::max(most, *high);
    }
    seen.least_mm = std::floor(std::min(double{least}, double{most}));
    seen.most_mm = std::max(seen.least_mm + 1.0, std::ceil(double{most}));
}

Phrase gouge_line(const piece::DeviationSide& gouge) {
    if (!(gouge.max_mm > 0.0)) return phrase("Nowhere too deep");
    return phrase("Too deep by %1 mm at most, at %2°, %3 mm high", number_text(gouge.max_mm, 3),
                  number_text(gouge.direction_deg, 1), number_text(gouge.height_mm, 2));
}

Phrase leftover_line(const piece::DeviationSide& leftover) {
    if (!(leftover.max_mm > 0.0)) return phrase("Nothing is left over");
    return phrase("Left over %1 mm at most, at %2°, %3 mm high; %4 mm on average",
                  number_text(leftover.max_mm, 3), number_text(leftover.direction_deg, 1),
                  number_text(leftover.height_mm, 2), number_text(leftover.mean_mm, 4));
}

}  // namespace

PieceView look_at_piece(const piece::JobPiece& piece, double pulse_mm, const PieceScenePlan& plan) {
    PieceView seen;
    seen.has_model = piece.deviation.has_value();
    seen.pulse_mm = pulse_mm;
    seen.removed_mm3 = piece.piece.removed_mm3();
    take_radii(piece, seen);
    if (piece.deviation) {
        const piece::PieceDeviation& all = *piece.deviation;
        seen.reach_mm = rounded_up(piece::colour_reach_mm(all, kLeastReach_pulses * pulse_mm));
        const std::uint64_t near = piece::places_within(all, kSamePulse_ratio * pulse_mm);
        seen.within_pulse_share =
            all.place_count > 0 ? static_cast<double>(near) / static_cast<double>(all.place_count) : 0.0;
        seen.deviation = all;
        seen.deviation->distance_mm = {};
    }
    seen.scene = std::make_shared<const MeshScene>(PieceScene{piece, plan, seen}.make());
    return seen;
}

std::vector<Phrase> piece_lines(const PieceView& seen) {
    std::vector<Phrase> lines;
    if (seen.draft_allowance_mm) {
        lines.push_back(phrase("Draft, of samples of the model: tips are kept %1 mm further out",
                               number_text(*seen.draft_allowance_mm, 3)));
    }
    const std::string removed_cm3 = number_text(seen.removed_mm3 / kMm3PerCm3, 1);
    if (!seen.deviation) {
        lines.push_back(phrase("Opened without its model: there is nothing to compare the piece with"));
        lines.push_back(phrase("Removed %1 cm³", removed_cm3));
        return lines;
    }
    // A draft's gouges come from its samples: a job's tips are exact.
    if (!seen.draft_allowance_mm) lines.push_back(gouge_line(seen.deviation->gouge));
    lines.push_back(leftover_line(seen.deviation->leftover));
    lines.push_back(phrase("Within a pulse %1 % of the surface, removed %2 cm³",
                           number_text(kPercent * seen.within_pulse_share, 1), removed_cm3));
    return lines;
}

PieceChoice piece_choice(bool has_job, bool has_mesh, bool is_engraved, ToolShape tool) {
    if (has_job) return {PieceSource::job, {}};
    if (!has_mesh) return {PieceSource::none, phrase("nothing is open")};
    if (is_engraved) return {PieceSource::none, phrase("lines are engraved once they are sliced")};
    if (tool == ToolShape::point)
        return {PieceSource::none, phrase("a point leaves nothing, so there is no draft; slice first")};
    return {PieceSource::draft, {}};
}

}  // namespace psicarve::session
