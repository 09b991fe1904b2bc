// SPDX-License-Identifier: GPL-3.0-or-later
// What is written into the picture of a model can be read.
#include <gtest/gtest.h>

#include <QLabel>

#include <algorithm>
#include <cmath>
#include <vector>

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
                   window_->context().open_job.view().state == session::OpenJobState::model &&
                   blank().isVisible();
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

double luminance_of(const QColor& colour) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

/// As WCAG 2 has it.
double contrast_of(const QColor& one, const QColor& other) {
    const auto [low, high] = std::minmax({luminance_of(one), luminance_of(other)});
    return (high + 0.05) / (low + 0.05);
}

TEST_P(SceneLabels, CanBeReadWhateverIsBehindThem) {
    constexpr double kLegible = 4.5;
    open_window();
    ASSERT_NO_FATAL_FAILURE(open_model("small.stl"));
    const auto heads = [&](const Tokens& tokens) {
        std::vector<MeshView::Head> both;
        for (const double side : {-1.0, 1.0}) {
            MeshView::Head head;
            head.body = view().picture().bodies.front();
            head.name = side < 0.0 ? "R1" : "R2";
            head.colour = side < 0.0 ? tokens.r1 : tokens.r2;
            head.label_place = {side, 0.0, 0.0};
            head.alarm = MeshView::Head::Alarm{{4.0 * side, 0.0, 0.0}, 0.1, "limit"};
            both.push_back(std::move(head));
        }
        return both;
    };
    for (const ThemeChoice theme : {ThemeChoice::light, ThemeChoice::dark}) {
        window_->set_theme(theme);
        const Tokens& tokens = tokens_of(theme_of(theme));
        view().set_heads(heads(tokens));
        view().set_legend("legend");
        view().look_from(Side::top);
        QApplication::processEvents();
        const QImage picture = view().grab().toImage();
        int looked_at = 0;
        for (const QLabel* label : view().findChildren<QLabel*>()) {
            if (!label->isVisible() || label->text().isEmpty()) continue;
            const QColor ground = picture.pixelColor(label->geometry().topLeft() + QPoint{1, 1});
            EXPECT_EQ(ground.name(), tokens.view.name()) << label->text().toStdString();
            EXPECT_GE(contrast_of(label->palette().color(QPalette::WindowText), ground), kLegible)
                << label->text().toStdString();
            ++looked_at;
        }
        EXPECT_GE(looked_at, 7);
        for (const QColor& ink : {tokens.r1, tokens.r2, tokens.alarm, tokens.text2})
            EXPECT_GE(contrast_of(ink, tokens.view), kLegible) << ink.name().toStdString();
        view().set_heads({});
        view().set_legend({});
    }
}

INSTANTIATE_TEST_SUITE_P(All, SceneLabels,
                         ::testing::Values(Language::english, Language::chinese, Language::russian),
                         [](const auto& named) {
                             return std::string{kLanguages[static_cast<std::size_t>(named.param)].code};
                         });

TEST(UnrolledLabels, HaveTheRoomThatTheWidestNeeds) {
    UnrolledView view;
    view.resize(600, 400);
    view.set_heights(10'120.101, 10'120.109);
    QFont small = view.font();
    small.setPixelSize(11);
    EXPECT_GE(view.map_area().left(), QFontMetricsF{small}.horizontalAdvance("10120.105 mm"));
    view.set_heights(26.0, 26.0);
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
