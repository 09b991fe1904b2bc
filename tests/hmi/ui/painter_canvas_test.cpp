// SPDX-License-Identifier: GPL-3.0-or-later
// What takes long to draw is drawn by another thread, and seen coarsely until then.
#include <gtest/gtest.h>

#include <QImage>

#include <cmath>
#include <memory>

#include "hmi/ui/mesh_view.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using session::MeshScene;

/// Of 72 000 facets, with lobes that the coarse one cuts off.
std::shared_ptr<const MeshScene> lobed_scene(std::uint32_t rgb, double lobes = 12.0) {
    constexpr std::size_t kRound = 300;
    constexpr std::size_t kUp = 121;
    auto scene = std::make_shared<MeshScene>();
    for (std::size_t row = 0; row < kUp; ++row) {
        for (std::size_t i = 0; i < kRound; ++i) {
            const double turn_rad = 2.0 * kPi * static_cast<double>(i) / kRound;
            const double radius = 10.0 + std::sin(lobes * turn_rad);
            scene->vertices.push_back({static_cast<float>(radius * std::cos(turn_rad)),
                                       static_cast<float>(radius * std::sin(turn_rad)),
                                       static_cast<float>(row) / 6.0F - 10.0F});
        }
    }
    scene->vertices.push_back({0.0F, 0.0F, 10.0F});
    scene->vertex_rgb.assign(scene->vertices.size(), rgb);
    scene->facets = session::lathe_facets(kRound, kUp, 1);
    scene->coarse_facets = session::lathe_facets(kRound, kUp, 20);
    scene->size = {22.0, 22.0, 20.0};
    return scene;
}

class PaintedView : public ::testing::Test {
protected:
    explicit PaintedView(bool is_lasting = true) { prepare(view_, is_lasting); }
    static void prepare(MeshView& view, bool is_lasting) {
        view.resize(400, 300);
        view.set_theme(tokens_of(Theme::light));
        view.set_lasting(is_lasting);
    }
    static QImage image_of(MeshView& view) { return view.grab().toImage(); }
    /// As the view has it that does everything itself, at once.
    static QImage expected(const std::shared_ptr<const MeshScene>& scene, MeshView::Side side,
                           bool is_coarse) {
        MeshView view{Drawing::painter};
        prepare(view, false);
        view.show_scene(scene);
        view.look_from(side);
        view.set_moving(is_coarse);
        return image_of(view);
    }
    bool becomes(const QImage& wanted) {
        const auto end = std::chrono::steady_clock::now() + two_process::kLimit;
        while (image_of(view_) != wanted) {
            QApplication::processEvents();
            if (std::chrono::steady_clock::now() > end) return false;
        }
        return true;
    }

    static constexpr auto kIso = MeshView::Side::iso;
    static constexpr std::uint32_t kGrey = 0xC2C8CE;
    static constexpr std::uint32_t kYellow = 0xFFC21A;
    const std::shared_ptr<const MeshScene> scene_ = lobed_scene(kGrey);
    MeshView view_{Drawing::painter};
};

TEST_F(PaintedView, IsCoarseUntilSomebodyElseHasDrawnItAll) {
    ASSERT_NE(expected(scene_, kIso, true), expected(scene_, kIso, false));
    view_.show_scene(scene_);
    EXPECT_EQ(image_of(view_), expected(scene_, kIso, true)) << "nothing is delivered without the loop";
    EXPECT_TRUE(becomes(expected(scene_, kIso, false)));
    view_.set_legend({});  // changes nothing of what is drawn
    EXPECT_EQ(image_of(view_), expected(scene_, kIso, false)) << "it is kept";
}

TEST_F(PaintedView, KeepsItsImageUntilItsColoursAreDrawn) {
    view_.show_scene(scene_);
    ASSERT_TRUE(becomes(expected(scene_, kIso, false)));
    const auto recoloured = lobed_scene(kYellow);
    view_.replace_scene(recoloured);
    EXPECT_EQ(image_of(view_), expected(scene_, kIso, false)) << "no flicker";
    EXPECT_TRUE(becomes(expected(recoloured, kIso, false)));
}

TEST_F(PaintedView, TakesNoImageOfAnotherBodyOfTheSameSize) {
    view_.show_scene(scene_);
    ASSERT_TRUE(becomes(expected(scene_, kIso, false)));
    const auto other = lobed_scene(kGrey, 9.0);
    view_.replace_scene(other);
    EXPECT_EQ(image_of(view_), expected(other, kIso, true));
    EXPECT_TRUE(becomes(expected(other, kIso, false)));
}

TEST_F(PaintedView, TakesNoImageOfAnotherSide) {
    view_.show_scene(scene_);
    (void)image_of(view_);  // one is on its way
    view_.look_from(MeshView::Side::top);
    EXPECT_EQ(image_of(view_), expected(scene_, MeshView::Side::top, true));
    EXPECT_TRUE(becomes(expected(scene_, MeshView::Side::top, false)));
    view_.look_from(kIso);
    (void)image_of(view_);
    view_.set_moving(true);  // drawn at once
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(image_of(view_), expected(scene_, kIso, true)) << "what is on its way is too late";
        QApplication::processEvents();
    }
}

class ChangingView : public PaintedView {
protected:
    ChangingView() : PaintedView(false) {}
};

TEST_F(ChangingView, IsDrawnAtOnceAsItsSceneMayBeAnotherSoon) {
    view_.show_scene(scene_);
    EXPECT_EQ(image_of(view_), expected(scene_, kIso, false));
}

}  // namespace
}  // namespace psicarve::ui
