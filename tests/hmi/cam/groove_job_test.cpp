// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cam/groove_tables.hpp"
#include "hmi/cam/prepared_job.hpp"
#include "hmi/flat/grooves.hpp"
#include "hmi/flat/svg_reader.hpp"
#include "hmi/piece/expected_piece.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::cam {
namespace {

struct SurfacePlace {
    double x;
    double y;
};

constexpr double kFine_mm = 0.002;
constexpr std::size_t kCoarse = 100;

/// The drawing below once more, by formulas, y upwards, from its lower left corner.
std::vector<std::vector<SurfacePlace>> strokes_of_drawing() {
    const auto sampled = [](double length_mm, auto&& at) {
        std::vector<SurfacePlace> places;
        const auto count = static_cast<int>(length_mm / kFine_mm);
        for (int k = 0; k <= count; ++k) places.push_back(at(static_cast<double>(k) / count));
        return places;
    };
    return {sampled(60.0,
                    [](double t) {
                        return SurfacePlace{50.0 * t, 16.0 - 16.0 * t};
                    }),
            sampled(40.0,
                    [](double t) {
                        return SurfacePlace{32.0 + 6.0 * std::cos(2.0 * kPi * t),
                                            10.0 + 6.0 * std::sin(2.0 * kPi * t)};
                    }),
            sampled(60.0, [](double t) {
                const double s = 1.0 - t;
                return SurfacePlace{
                    3.0 * s * s * s + 3.0 * 3.0 * s * s * t + 3.0 * 25.0 * s * t * t + 25.0 * t * t * t,
                    2.0 * s * s * s + 3.0 * 14.0 * s * s * t + 3.0 * 2.0 * s * t * t + 14.0 * t * t * t};
            })};
}

constexpr const char* kDrawing =
    "<svg xmlns='http://www.w3.org/2000/svg' width='50mm' height='16mm' viewBox='0 0 50 16'>"
    "<g fill='none' stroke='black'><path d='M0 0 L50 16'/><circle cx='32' cy='6' r='6'/>"
    "<path d='M3 14 C3 2 25 14 25 2'/></g></svg>";

class GrooveJob : public ::testing::Test {
protected:
    GrooveJob() { profile_.tool = {ToolShape::ball, 2.0}; }

    /// The drawing round a cylinder, whose own triangles do not matter.
    model::Mesh mesh(double start_deg) const {
        flat::FlatOptions options;
        options.engraving = {kDepth_mm, start_deg, false, profile_.tool};
        options.diameter_mm = kDiameter_mm;
        options.height_mm = kHeight_mm;
        const auto drawing = flat::read_svg(kDrawing, "lines.svg", 1.0);
        auto grooves = flat::grooves_of(drawing.value(), options, "lines.svg");
        EXPECT_TRUE(grooves.has_value()) << (grooves ? "" : grooves.error().message);
        model::Mesh body = shapes::cylinder(0.5 * kDiameter_mm, 0.0, kHeight_mm, 90);
        body.axis_hint = {0.0, 0.0};
        if (grooves) body.grooves = std::make_shared<const flat::Grooves>(std::move(*grooves));
        return body;
    }
    /// From the nearest of the places up to half a cell away.
    static double distance_mm(double along_mm, double height_mm, double start_deg,
                              const flat::HalfCell& cell = {});
    void expect_all(const BuiltJob& job, double start_deg) const;

    static constexpr double kDepth_mm = 0.6;
    static constexpr double kDiameter_mm = 20.0;
    static constexpr double kHeight_mm = 20.0;
    Profile profile_;
};

/// Along the surface, the short way round: of all samples of the strokes.
double GrooveJob::distance_mm(double along_mm, double height_mm, double start_deg,
                              const flat::HalfCell& cell) {
    static const auto strokes = strokes_of_drawing();
    const double round_mm = kPi * kDiameter_mm;
    const double at_x = std::remainder(along_mm - start_deg / 360.0 * round_mm, round_mm);
    const double at_y = height_mm - 0.5 * (kHeight_mm - 16.0);
    const auto to = [&](const SurfacePlace& place) {
        double x = std::abs(at_x - place.x);
        x = std::max(0.0, std::min(x, std::abs(x - round_mm)) - cell.along_mm);
        const double y = std::max(0.0, std::abs(at_y - place.y) - cell.height_mm);
        return std::sqrt(x * x + y * y);
    };
    double nearest_mm = 1e9;
    for (const auto& stroke : strokes) {
        for (std::size_t i = 0; i < stroke.size(); i += kCoarse) {
            // No neighbour is farther from it than so many samples' ways.
            if (to(stroke[i]) > std::min(nearest_mm, 2.0) + 4.0 * kFine_mm * kCoarse) continue;
            for (std::size_t k = i; k < std::min(i + kCoarse, stroke.size()); ++k)
                nearest_mm = std::min(nearest_mm, to(stroke[k]));
        }
    }
    return nearest_mm;
}

/// Every entry of both tables is what its distance to the strokes asks for, to a pulse.
void GrooveJob::expect_all(const BuiltJob& job, double start_deg) const {
    const JobTable& table = job.table;
    const auto blob = job_blob_from_table(table);
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view.has_value());
    flat::Grooves grooves;
    grooves.radius_mm = 0.5 * kDiameter_mm;
    grooves.height_mm = kHeight_mm;
    grooves.depth_mm = kDepth_mm;
    grooves.tool = tool::tool_of(profile_.tool, 1.0);
    JobPlan plan;
    plan.layer_count = table.layer_count - (table.joining == Joining::spiral ? 1 : 0);
    plan.point_count = table.point_count;
    const flat::HalfCell cell = groove_cell(grooves, profile_, plan);
    std::size_t cut = 0;
    std::size_t wrong = 0;
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        for (std::uint32_t point = 0; point < table.point_count; ++point) {
            for (const bool is_right : {false, true}) {
                const double turn_rad =
                    rad_from_pulses(view->psi_pulses(layer, point), profile_.psi.pulses_per_rev);
                const double direction_rad =
                    turn_rad + (is_right ? kPi + rad_from_deg(profile_.head_r2_angle_error_deg) : 0.0);
                // The heights themselves, not the pulses that they are rounded to.
                double height_mm = kHeight_mm * (layer + 0.5) / plan.layer_count;
                if (table.joining == Joining::spiral) {
                    const double part = static_cast<double>(point) / (table.point_count - 1);
                    const double row = std::clamp(layer - 1.0 + part, 0.0, plan.layer_count - 1.0);
                    height_mm = kHeight_mm * (row + 0.5) / plan.layer_count;
                }
                if (is_right) height_mm += profile_.head_r2_height_error_mm;
                const double away_mm =
                    distance_mm(direction_rad * grooves.radius_mm, height_mm, start_deg, cell);
                // Where a flat tool's floor ends, a sample more or less decides.
                const double sure_mm = 2.0 * kFine_mm;
                const double least_mm = grooves.radius_mm - grooves.tip_depth_mm(away_mm - sure_mm);
                const double most_mm = grooves.radius_mm - grooves.tip_depth_mm(away_mm + sure_mm);
                const double pulse_mm = 1.0 / profile_.r1.pulses_per_mm;
                const double got_mm = pulse_mm * (is_right ? right : left)(table, layer, point);
                cut += got_mm < grooves.radius_mm - 0.5 * kDepth_mm ? 1 : 0;
                wrong +=
                    got_mm < std::min(least_mm, most_mm) - pulse_mm || got_mm > most_mm + pulse_mm ? 1 : 0;
            }
        }
    }
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(cut, 100U);
}

TEST_F(GrooveJob, HasEveryPointWhereItsDistanceToTheStrokesSays) {
    for (const ToolProfile& tool : {ToolProfile{ToolShape::ball, 2.0}, ToolProfile{ToolShape::vee, 3.0, 70.0},
                                    ToolProfile{ToolShape::flat, 1.5}, ToolProfile{}}) {
        SCOPED_TRACE(tool::name_of(tool));
        profile_.tool = tool;
        expect_all(built(mesh(0.0), profile_, small(30, 61)), 0.0);
    }
}

TEST_F(GrooveJob, HasThemAcrossTheSeamAsASpiralAndWithHeadsOfTheirOwnErrors) {
    profile_.head_r2_angle_error_deg = 1.5;
    profile_.head_r2_height_error_mm = -0.3;
    expect_all(built(mesh(200.0), profile_, small(30, 61)), 200.0);
    profile_.head_r2_height_error_mm = 0.0;
    JobOptions options = small(30, 61);
    options.joining = Joining::spiral;
    expect_all(built(mesh(200.0), profile_, options), 200.0);
}

TEST_F(GrooveJob, LeavesNoGrooveOutAndCutsNoneDeeperOrElsewhere) {
    for (const ToolShape shape : {ToolShape::flat, ToolShape::vee}) {
        profile_.tool = {shape, 1.5, 80.0};
        profile_.blank = {0.5 * kDiameter_mm, kHeight_mm};
        const model::Mesh grooved = mesh(30.0);
        const BuiltJob job = built(grooved, profile_, small(80, 241));
        auto prepared = prepare_blob(job_blob_from_table(job.table), profile_, "lines.svg");
        ASSERT_TRUE(prepared.has_value());
        const auto geometry = verify::JobGeometry::make(prepared->view, profile_);
        ASSERT_TRUE(geometry.has_value());
        const piece::StockMap stock = piece::expected_piece(*geometry, profile_, 720);
        JobPlan plan;
        plan.layer_count = job.table.layer_count;
        plan.point_count = job.table.point_count;
        const flat::HalfCell cell = groove_cell(*grooved.grooves, profile_, plan);
        const double slack_mm = std::hypot(cell.along_mm, cell.height_mm);
        // Beside a line a tip that is not flat leaves as much of its depth as it rises to there.
        const double short_mm = tool::rise(grooved.grooves->tool, slack_mm);
        // A cell, a step of the table, and the slack.
        const double coarseness_mm = slack_mm + 0.3;
        for (std::size_t row = 0; row < stock.row_count(); row += 7) {
            for (std::size_t column = 0; column < stock.column_count(); column += 7) {
                const double radius_mm = stock.row(row)[column];
                const double away_mm =
                    distance_mm(stock.direction_rad(column) * 0.5 * kDiameter_mm, stock.height_mm(row), 30.0);
                EXPECT_GE(radius_mm, 0.5 * kDiameter_mm - kDepth_mm - 0.003);
                // Straight ways between points are chords of the cylinder's surface.
                if (away_mm > 0.75 + coarseness_mm) {
                    EXPECT_GT(radius_mm, 0.5 * kDiameter_mm - 0.01) << away_mm;
                }
                if (away_mm < 0.02) {
                    EXPECT_LT(radius_mm, 0.5 * kDiameter_mm - kDepth_mm + short_mm + 0.01) << away_mm;
                }
            }
        }
    }
}

/// Rows and columns, once round, of the points where a straight line's tip goes all the way in.
using FullPoints = std::set<std::pair<std::size_t, std::size_t>>;

FullPoints full_points(const JobTable& table, const Profile& profile, double floor_mm) {
    FullPoints full;
    const std::size_t columns = 2 * (std::size_t{table.point_count} - 1);
    for (std::size_t layer = 0; layer < table.layer_count; ++layer) {
        for (std::size_t point = 0; point < table.point_count; ++point) {
            // Continuous: odd layers are half a turn on.
            const std::size_t of_left = (point + (layer % 2) * columns / 2) % columns;
            if (left(table, layer, point) < (floor_mm + 0.01) * profile.r1.pulses_per_mm)
                full.emplace(layer, of_left);
            if (right(table, layer, point) < (floor_mm + 0.01) * profile.r2.pulses_per_mm)
                full.emplace(layer, (of_left + columns / 2) % columns);
        }
    }
    return full;
}

/// How many of the points can be reached from the first, each time along a layer or to the next.
std::size_t connected(const FullPoints& full, std::size_t columns) {
    if (full.empty()) return 0;
    FullPoints seen{*full.begin()};
    std::vector<std::pair<std::size_t, std::size_t>> next(seen.begin(), seen.end());
    while (!next.empty()) {
        const auto [row, column] = next.back();
        next.pop_back();
        for (const auto& beside :
             {std::pair{row + 1, column}, std::pair{row - 1, column}, std::pair{row, (column + 1) % columns},
              std::pair{row, (column + columns - 1) % columns}}) {
            if (full.count(beside) != 0 && seen.insert(beside).second) next.push_back(beside);
        }
    }
    return seen.size();
}

/// A line of 14 mm through the middle of direction 0.
model::Mesh straight_line(double radius_mm, double height_mm, double angle_deg, const ToolProfile& tool) {
    flat::Grooves grooves;
    grooves.radius_mm = radius_mm;
    grooves.height_mm = height_mm;
    grooves.depth_mm = 0.5;
    grooves.tool = tool::tool_of(tool, 1.0);
    const double x = 7.0 * std::cos(rad_from_deg(angle_deg));
    const double y = 7.0 * std::sin(rad_from_deg(angle_deg));
    // Through the middle of no cell, as a rule.
    const flat::Point middle{0.123, 0.5 * height_mm + 0.077};
    grooves.strokes.push_back({{{middle.x - x, middle.y - y}, {middle.x + x, middle.y + y}}, false, 0.0});
    model::Mesh body = shapes::cylinder(radius_mm, 0.0, height_mm, 90);
    body.axis_hint = {0.0, 0.0};
    body.grooves = std::make_shared<const flat::Grooves>(std::move(grooves));
    return body;
}

// At any angle, on any grid: no gap, and nothing that the line does not pass.
TEST_F(GrooveJob, GoesAllTheWayInWhereTheLinePassesAndHasNoGaps) {
    constexpr double kRadius_mm = 10.0;
    profile_.tool = {ToolShape::flat, 1.0};
    for (const auto& [layers, points] : {std::pair{30U, 61U}, std::pair{160U, 17U}, std::pair{12U, 121U}}) {
        for (double angle_deg = 0.0; angle_deg < 180.0; angle_deg += 7.5) {
            SCOPED_TRACE(std::to_string(layers) + " x " + std::to_string(points) + ", " +
                         std::to_string(angle_deg) + " deg");
            const BuiltJob job = built(straight_line(kRadius_mm, kHeight_mm, angle_deg, profile_.tool),
                                       profile_, small(layers, points));
            const FullPoints full = full_points(job.table, profile_, kRadius_mm - 0.5);
            const std::size_t columns = 2 * (points - 1);
            EXPECT_EQ(connected(full, columns), full.size());
            const double step_mm = 2.0 * kPi * kRadius_mm / static_cast<double>(columns);
            const double layer_mm = kHeight_mm / layers;
            FullPoints passed;
            for (double at_mm = -7.0; at_mm <= 7.0; at_mm += 0.002) {
                const double x = 0.123 + at_mm * std::cos(rad_from_deg(angle_deg));
                const double y = 0.5 * kHeight_mm + 0.077 + at_mm * std::sin(rad_from_deg(angle_deg));
                const auto column =
                    static_cast<std::size_t>(std::lround(x / step_mm) + static_cast<long>(columns)) % columns;
                passed.emplace(static_cast<std::size_t>(y / layer_mm), column);
            }
            EXPECT_TRUE(std::includes(full.begin(), full.end(), passed.begin(), passed.end()));
            // Corners that only just touch it are few.
            EXPECT_LE(full.size(), passed.size() + 3 + passed.size() / 20);
        }
    }
}

TEST_F(GrooveJob, IsNoWiderAlongTheLayersWherePointsAreFew) {
    profile_.tool = {ToolShape::flat, 1.0};
    const BuiltJob job = built(straight_line(20.0, kHeight_mm, 0.0, profile_.tool), profile_, small(400, 51));
    std::set<std::size_t> rows;
    for (const auto& [row, column] : full_points(job.table, profile_, 19.5)) rows.insert(row);
    EXPECT_EQ(rows.size(), 1U);
    ASSERT_FALSE(job.report.notes.empty());
    EXPECT_EQ(
        job.report.notes.back(),
        "grooves 0.50 mm deep and 1.00 mm wide; where no point meets the line, up to 1.28 mm wider along "
        "the layers and 0.05 mm across them");
}

TEST_F(GrooveJob, IsNotForAnotherToolOrABodyThatStandsElsewhere) {
    const model::Mesh lines = mesh(0.0);
    JobOptions options = small(20, 41);
    options.up = slice::Up::x;
    EXPECT_FALSE(build_job(lines, profile_, options).has_value());
    profile_.tool.diameter_mm = 1.0;
    const auto job = build_job(lines, profile_, small(20, 41));
    ASSERT_FALSE(job.has_value());
    EXPECT_NE(job.error().message.find("another tool"), std::string::npos);
}

TEST_F(GrooveJob, TellsOfWhatKeepsGroovesFromWhatWasAsked) {
    profile_.tool = {};
    const BuiltJob point = built(mesh(0.0), profile_, small(20, 41));
    ASSERT_EQ(point.report.warnings.size(), 1U);
    EXPECT_NE(point.report.warnings[0].find("the tool is a point"), std::string::npos);
    profile_.tool = {ToolShape::flat, 0.5};
    profile_.core_radius_mm = 9.9;
    const BuiltJob coarse = built(mesh(0.0), profile_, small(20, 41));
    ASSERT_EQ(coarse.report.warnings.size(), 2U);
    EXPECT_NE(coarse.report.warnings[0].find("farther from each other than the tool"), std::string::npos);
    EXPECT_NE(coarse.report.warnings[1].find("core radius of 9.90 mm"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::cam
