// SPDX-License-Identifier: GPL-3.0-or-later
// What is written into the picture of a model can be read.
#include <gtest/gtest.h>

#include <QLabel>

#include "hmi/ui/language.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/preflight_list.hpp"
#include "hmi/ui/unrolled_view.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using Side = MeshView::Side;

class SceneLabels : public test::WindowRig, public ::testing::WithParamInterface<Language> {
public:
    SceneLabels() { use_language(GetParam()); }
    ~SceneLabels() override { use_language(Language::english); }

protected:
    void open_model(const QString& name) {
        window_->open(QString::fromStdString(example("")) + name);
        ASSERT_TRUE(comes_true([&] {
            return window_->windowTitle().startsWith(name) &&
                   window_->bench().desk.sight().state == session::DeskState::model && blank().isVisible();
        })) << all_messages().toStdString();
    }
    MeshView& view() { return part<MeshView>("model_view"); }
    QLabel& axis() { return *view().findChild<QLabel*>("axis_label"); }
    QLabel& blank() { return *view().findChild<QLabel*>("blank_label"); }
};

TEST_P(SceneLabels, LieOnNobodysWordsFromAnySide) {
    open_window();
    window_->resize(1280, 720);
    for (const char* name : {"figurine.stl", "letter.stl", "small.stl"}) {
        ASSERT_NO_FATAL_FAILURE(open_model(QString::fromLatin1(name)));
        const auto look = [&](const QString& from) {
            for (const QLabel* label : view().findChildren<QLabel*>()) {
                if (!label->isVisible() || label->text().isEmpty()) continue;
                for (QLabel* sut : {&axis(), &blank()}) {
                    EXPECT_TRUE(sut == label || !sut->geometry().intersects(label->geometry()))
                        << name << ", " << from.toStdString() << ": " << sut->text().toStdString() << " on "
                        << label->text().toStdString();
                }
            }
        };
        for (const Side side : {Side::front, Side::side, Side::top, Side::iso}) {
            view().look_from(side);
            look(QString{"side %1"}.arg(static_cast<int>(side)));
        }
        for (int tilt = -9; tilt <= 9; ++tilt) {
            session::SceneView from = view().picture().view;
            from.elevation_rad = 0.17 * tilt;
            view().look_as(from);
            look(QString{"tilt %1"}.arg(tilt));
        }
        view().look_from(Side::iso);
        take_picture(QString{"labels_%1_%2"}.arg(QLatin1String(name)).arg(static_cast<int>(GetParam())));
    }
}

TEST_P(SceneLabels, StandOnTheirOwnGround) {
    open_window();
    ASSERT_NO_FATAL_FAILURE(open_model("small.stl"));
    view().look_from(Side::top);  // in the middle of the body
    QApplication::processEvents();
    const QImage picture = view().grab().toImage();
    const QColor ground = picture.pixelColor(axis().geometry().topLeft() + QPoint{1, 1});
    EXPECT_EQ(ground.name(), tokens_of(Theme::light).view.name());
}

INSTANTIATE_TEST_SUITE_P(All, SceneLabels,
                         ::testing::Values(Language::english, Language::chinese, Language::russian),
                         [](const auto& named) {
                             return std::string{kLanguages[static_cast<std::size_t>(named.param)].code};
                         });

TEST(UnrolledLabels, HaveTheRoomThatTheWidestNeeds) {
    UnrolledView view;
    view.resize(600, 400);
    session::RadiusMap map;
    map.rows = map.columns = 2;
    map.radius_mm.assign(4, 0.0F);
    map.most_mm = 1.0;
    view.show_map(map, 10'120.101, 10'120.109);
    QFont small = view.font();
    small.setPixelSize(11);
    EXPECT_GE(view.map_area().left(), QFontMetricsF{small}.horizontalAdvance("10120.105 mm"));
    view.show_map(map, 26.0, 26.0);
    EXPECT_LE(view.height_marks().decimals, 3);
}

TEST(LookedAtBeforeStart, IsNamedWithoutItsRemedy) {
    session::Check check{session::phrase("Ticks in time"), session::phrase("missed 51"),
                         session::Check::Verdict::warning};
    check.remedy = session::phrase("lengthen tick.period_us");
    EXPECT_EQ(to_look_at_in({check}), "Ticks in time: missed 51") << "more lines would move Start and Hold";
}

}  // namespace
}  // namespace psicarve::ui
