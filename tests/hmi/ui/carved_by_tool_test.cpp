// SPDX-License-Identifier: GPL-3.0-or-later
// The page Carving with a tool that has a size: what it leaves, not what its tip passes.
#include <gtest/gtest.h>

#include <QLabel>
#include <QTabWidget>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

#include "hmi/piece/expected_piece.hpp"
#include "hmi/piece/tool_way.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "shared/base/units.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

constexpr double kGrooves_mm = 2.0;  // from one to the next
constexpr double kOutside_mm = 12.0;
constexpr double kGround_mm = 9.0;
constexpr double kBall_mm = 3.0;  // its radius
constexpr double kBlankHeight_mm = 14.0;
constexpr double kBlankMiddle_mm = 0.5 * kBlankHeight_mm;

/// How far a ball's side is behind its tip.
double behind_tip_mm(double beside_mm) {
    return kBall_mm - std::sqrt(kBall_mm * kBall_mm - beside_mm * beside_mm);
}

/// Rings that are narrower than the ball: its tip goes to their ground.
double grooves_mm(double height_mm) {
    return std::fmod(height_mm, kGrooves_mm) < 0.5 * kGrooves_mm ? kGround_mm : kOutside_mm;
}

class CarvedByTool : public test::WindowRig {
protected:
    static Profile profile_with(ToolShape shape) {
        Profile profile;
        profile.tool.shape = shape;
        profile.tool.diameter_mm = 2.0 * kBall_mm;
        profile.blank.radius_mm = 13.0;
        profile.blank.height_mm = kBlankHeight_mm;
        profile.blank.offset_x_mm = 0.5;
        return profile;
    }
    using Radius = std::function<double(double height_mm)>;
    /// A post whose tips stand so far out.
    static JobTable post_job(const Profile& profile, const Radius& tip_mm) {
        JobTable table = two_process::lobed_job(60, 61, profile);
        for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
            const double height_mm = 1.0 + 0.12 * layer;
            table.layer_height_pulses[layer] = pulses_from_mm(height_mm, profile.y.pulses_per_mm);
            const double radius_mm = tip_mm(height_mm);
            for (std::uint32_t point = 0; point < table.point_count; ++point) {
                const std::size_t at = std::size_t{layer} * table.point_count + point;
                table.r_left_pulses[at] =
                    static_cast<std::int32_t>(pulses_from_mm(radius_mm, profile.r1.pulses_per_mm));
                table.r_right_pulses[at] =
                    static_cast<std::int32_t>(pulses_from_mm(radius_mm, profile.r2.pulses_per_mm));
            }
        }
        return table;
    }
    void carve_with(ToolShape shape, const Radius& tip_mm = grooves_mm) {
        const Profile profile = profile_with(shape);
        std::ofstream{file("machine.toml")} << profile_to_toml(profile);
        window_.reset();
        start_core({"--profile", file("machine.toml")});
        open_window();
        window_->findChild<QTabWidget*>()->setCurrentIndex(2);
        ASSERT_NO_FATAL_FAILURE(carve_job(post_job(profile, tip_mm)));
        ASSERT_TRUE(comes_true([&] { return is_done() && is_shown(); })) << all_messages().toStdString();
    }
    bool is_done() { return machine_view().state() == S::ready && machine_view().status->job_end_tick != 0; }
    bool is_shown() {
        const auto& bodies = view().picture().bodies;
        if (bodies.empty()) return false;
        const auto& rgb = bodies.front().scene->vertex_rgb;
        return std::count(rgb.begin(), rgb.end(), rgb[rgb.size() / 2]) > std::ssize(rgb) / 3 &&
               !part<QLabel>("carving_behind").text().contains("catching up");
    }
    MeshView& view() { return part<MeshView>("carving_view"); }
    /// Of all that stands between two heights [mm above the table].
    std::vector<double> radii_between(double low_mm, double high_mm, double middle_mm) {
        std::vector<double> radii;
        const auto& vertices = view().picture().bodies.front().scene->vertices;
        for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
            const double height_mm = static_cast<double>(vertices[i][2]) + middle_mm;
            if (height_mm < low_mm || height_mm > high_mm) continue;
            radii.push_back(std::hypot(vertices[i][0], vertices[i][1]));
        }
        return radii;
    }
};

TEST_F(CarvedByTool, LessIsLeftWhereABallWentThanWhereAPointDid) {
    // The rib between two grooves: a point leaves it, a ball that is wider than it takes it away.
    ASSERT_NO_FATAL_FAILURE(carve_with(ToolShape::point));
    const double first_mm = 1.0;
    const double last_mm = 1.0 + 0.12 * 59;
    const auto ribs = radii_between(3.2, 3.8, 0.5 * (first_mm + last_mm));
    ASSERT_FALSE(ribs.empty());
    EXPECT_NEAR(*std::max_element(ribs.begin(), ribs.end()), kOutside_mm, 0.1);
    take_picture("carved_by_point_light");
    core_.reset();
    ASSERT_NO_FATAL_FAILURE(carve_with(ToolShape::ball));
    take_picture("carved_by_ball_light");
    const auto taken = radii_between(3.2, 3.8, kBlankMiddle_mm);
    ASSERT_FALSE(taken.empty());
    EXPECT_LT(*std::max_element(taken.begin(), taken.end()), kOutside_mm - 1.0);
    EXPECT_GT(*std::min_element(taken.begin(), taken.end()), kGround_mm - 0.05);
    // Above the job the blank stands off the axis, and is the whole blank.
    const auto above = radii_between(last_mm + kBall_mm + 0.2, kBlankHeight_mm, kBlankMiddle_mm);
    ASSERT_FALSE(above.empty());
    EXPECT_NEAR(*std::max_element(above.begin(), above.end()), 13.5, 0.01);
    EXPECT_NEAR(*std::min_element(above.begin(), above.end()), 12.5, 0.01);
}

TEST_F(CarvedByTool, MoreIsLeftInAGrooveThatABallDoesNotReachInto) {
    // A ring four millimetres wide and three deep, in which a ball of six comes to rest on the rims.
    constexpr double kRing_mm = 5.0;
    constexpr double kHalfRing_mm = 2.0;
    const auto model_mm = [](double height_mm) {
        return std::abs(height_mm - kRing_mm) < kHalfRing_mm ? kGround_mm : kOutside_mm;
    };
    // As the slicer has it: as deep as the ball gets before any of it touches the model.
    const auto tip_mm = [&](double height_mm) {
        double tip = 0.0;
        for (double beside = -kBall_mm; beside <= kBall_mm; beside += 0.01)
            tip = std::max(tip, model_mm(height_mm + beside) - behind_tip_mm(beside));
        return tip;
    };
    const double deepest_mm = kOutside_mm - behind_tip_mm(kHalfRing_mm);
    ASSERT_NEAR(tip_mm(kRing_mm), deepest_mm, 0.02);
    ASSERT_NO_FATAL_FAILURE(carve_with(ToolShape::ball, tip_mm));
    // Between the rims the ball's own round is left, far out from the model's ground.
    const auto furthest_off_mm = [&] {
        double most_mm = 0.0;
        for (const double beside : {-1.5, -1.0, 0.0, 1.0, 1.5}) {
            const double left_mm = deepest_mm + behind_tip_mm(beside);
            EXPECT_GT(left_mm, kGround_mm + 2.0);
            const double height_mm = kRing_mm + beside;
            const auto left = radii_between(height_mm - 0.1, height_mm + 0.1, kBlankMiddle_mm);
            EXPECT_FALSE(left.empty());
            for (const double radius_mm : left) most_mm = std::max(most_mm, std::abs(radius_mm - left_mm));
        }
        return most_mm;
    };
    // What the core has done is cut by a thread of its own.
    EXPECT_TRUE(comes_true([&] { return furthest_off_mm() <= 0.1; })) << furthest_off_mm();
    take_picture("carved_ring_light");
    // A point would leave where its tip came by, which beside the middle is further out.
    EXPECT_GT(tip_mm(kRing_mm + 1.0), deepest_mm + behind_tip_mm(1.0) + 0.4);
}

TEST_F(CarvedByTool, IsThePieceThatTheJobsToolIsToLeave) {
    ASSERT_NO_FATAL_FAILURE(carve_with(ToolShape::ball));
    const auto job = window_->context().open_job.core_job();
    ASSERT_TRUE(job);
    const auto geometry = verify::JobGeometry::make(job->view, job->profile).value();
    const piece::StockMap wanted =
        piece::expected_piece(geometry, job->profile,
                              piece::view_blank_of(geometry, job->profile, piece::kViewColumns), nullptr, {})
            .value();
    const auto worst_mm = [&] {
        const auto& vertices = view().picture().bodies.front().scene->vertices;
        const double middle_mm =
            wanted.bottom_mm() + 0.5 * wanted.row_mm() * static_cast<double>(wanted.row_count());
        double worst = 0.0;
        for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
            const double height_mm = static_cast<double>(vertices[i][2]) + middle_mm;
            const double row = std::clamp(std::floor((height_mm - wanted.bottom_mm()) / wanted.row_mm()), 0.0,
                                          static_cast<double>(wanted.row_count() - 1));
            double turn = std::atan2(vertices[i][1], vertices[i][0]) / (2.0 * kPi);
            if (turn < 0.0) turn += 1.0;
            const auto columns = static_cast<double>(wanted.column_count());
            const auto column =
                static_cast<std::size_t>(std::llround(turn * columns)) % wanted.column_count();
            const double radius_mm = std::hypot(vertices[i][0], vertices[i][1]);
            worst = std::max(worst, std::abs(radius_mm - wanted.row(static_cast<std::size_t>(row))[column]));
        }
        return worst;
    };
    // Half a cell on a wall as steep as the ball's side.
    EXPECT_TRUE(comes_true([&] { return worst_mm() < 0.5 * wanted.row_mm(); })) << worst_mm();
    // A window that comes later shows the same.
    open_window();
    window_->findChild<QTabWidget*>()->setCurrentIndex(2);
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard() && is_shown(); }));
    EXPECT_TRUE(comes_true([&] { return worst_mm() < 0.5 * wanted.row_mm(); })) << worst_mm();
}

}  // namespace
}  // namespace psicarve::ui
