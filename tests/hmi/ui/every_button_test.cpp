// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons that other tests have no need of, pressed one by one, each with its effect.
#include <gtest/gtest.h>

#include <QButtonGroup>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTimer>
#include <QWheelEvent>

#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "shared/base/units.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/profile/profile_text.hpp"
#include "tests/hmi/replay/recorded_run.hpp"
#include "tests/hmi/ui/pages_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;

class EveryButton : public replay::test::RecordedOn<test::PagesRig> {
protected:
    std::int64_t pulses(Axis axis) { return machine_view().status->position_pulses[index_of(axis)]; }
    MeshView& view_beside(const QPushButton& button) {
        for (QWidget* at = button.parentWidget(); at != nullptr; at = at->parentWidget()) {
            for (QWidget* child : at->findChildren<QWidget*>()) {
                if (auto* const view = dynamic_cast<MeshView*>(child)) return *view;
            }
        }
        throw std::runtime_error{"no view beside it"};
    }
};

TEST_F(EveryButton, OfTheJogPadMovesItsAxisByAStepItsWay) {
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    struct Pad {
        const char* name;
        Axis axis;
        int way;
    };
    const Profile profile;
    // Homed heads stand outside: in before out.
    for (const Pad pad :
         {Pad{"jog_r1_in", Axis::r1, -1}, Pad{"jog_r1_out", Axis::r1, 1}, Pad{"jog_r2_in", Axis::r2, -1},
          Pad{"jog_r2_out", Axis::r2, 1}, Pad{"jog_y_up", Axis::y, 1}, Pad{"jog_y_down", Axis::y, -1},
          Pad{"jog_psi_plus", Axis::psi, 1}, Pad{"jog_psi_minus", Axis::psi, -1}}) {
        std::array<std::int64_t, kAxisCount> before{};
        for (const Axis axis : kAllAxes) before[index_of(axis)] = pulses(axis);
        const double step = pad.axis == Axis::psi ? 1.0 : 0.1;  // degrees or mm, as chosen at first
        const auto pulses_of_step = std::llround(step * axis_motion(profile, pad.axis).pulses_per_unit);
        ASSERT_TRUE(click(pad.name));
        ASSERT_TRUE(comes_true([&] {
            return machine_view().state() == S::ready &&
                   pulses(pad.axis) == before[index_of(pad.axis)] + pad.way * pulses_of_step;
        })) << pad.name
            << ": " << pulses(pad.axis) - before[index_of(pad.axis)] << all_messages().toStdString();
        for (const Axis other : kAllAxes) {
            if (other == pad.axis) continue;
            EXPECT_EQ(pulses(other), before[index_of(other)]) << pad.name << ", " << name_of(other);
        }
    }
}

// A motor that is asked for too much loses steps: on its way back the axis meets its switch too early.
TEST_F(EveryButton, OfAnAlarmMovesTheAxisOffItsSwitchAndResets) {
    Profile machine;
    machine.r1.speed_mm_s = 2.0;
    machine.r1.home_speed_mm_s = 1.0;
    Profile hasty = machine;
    hasty.r1.speed_mm_s = 10.0;
    for (const auto& [profile, name] : {std::pair{machine, "true.toml"}, std::pair{hasty, "hasty.toml"}}) {
        const std::string text = profile_to_toml(profile);
        ASSERT_TRUE(write_file_atomically(file(name), std::as_bytes(std::span{text})));
    }
    start_core({"--profile", file("hasty.toml"), "--machine", file("true.toml")});
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    part<QButtonGroup>("jog_linear_step").buttons().back()->click();  // 10 mm
    ASSERT_TRUE(click("jog_r1_in"));
    ASSERT_TRUE(comes_true([&] { return machine_view().state() == S::ready && pulses(Axis::r1) < 21'000; }))
        << pulses(Axis::r1) << all_messages().toStdString();
    part<QSlider>("jog_linear_speed").setValue(10);  // 1 mm/s: slow enough
    ASSERT_TRUE(click("jog_r1_out"));
    ASSERT_TRUE(comes_to(S::alarm));
    ASSERT_TRUE(machine_view().is_active(Signal::r1_limit));
    EXPECT_TRUE(part<QLabel>("alarm_title").text().contains("R1"))
        << part<QLabel>("alarm_title").text().toStdString();
    EXPECT_EQ(button("reset_alarm").toolTip(), "Switch R1 is still closed");
    const auto truly = [&] { return machine_view().status->sim_true_position_pulses[index_of(Axis::r1)]; };
    const std::int64_t at_switch = truly();
    ASSERT_TRUE(click("back_off"));
    ASSERT_TRUE(comes_true([&] {
        return machine_view().state() == S::alarm && !machine_view().is_active(Signal::r1_limit);
    })) << all_messages().toStdString();
    EXPECT_LT(truly(), at_switch);
    EXPECT_EQ(button("back_off").toolTip(), "Back off: no switch is closed");
    ASSERT_TRUE(click("reset_alarm"));
    ASSERT_TRUE(comes_to(S::off));
    ASSERT_TRUE(click("home"));
    EXPECT_TRUE(comes_to(S::ready));
}

TEST_F(EveryButton, OfAViewTurnsIt) {
    open_window();
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    constexpr double kQuarter_rad = 1.5707963267948966;
    for (const char* page : {"model_page", "carving_page"}) {
        show_page(page);
        int pressed = 0;
        for (QPushButton* each : window_->findChild<QWidget*>(page)->findChildren<QPushButton*>()) {
            const QString name = each->text();
            if (!QStringList{"Front", "Side", "Top", "Iso", "Fit"}.contains(name)) continue;
            ++pressed;
            MeshView& view = view_beside(*each);
            const session::SceneView& seen = view.picture().view;
            session::SceneView odd = seen;
            odd.azimuth_rad = 1.0;
            odd.elevation_rad = 0.5;
            view.look_as(odd);
            QWheelEvent nearer{QPointF{50, 50},   view.mapToGlobal(QPointF{50, 50}),
                               QPoint{},          QPoint{0, 240},
                               Qt::NoButton,      Qt::NoModifier,
                               Qt::NoScrollPhase, false};
            QApplication::sendEvent(&view, &nearer);
            const session::SceneView before = seen;
            ASSERT_NE(before.zoom, 1.0);
            each->click();
            if (name == "Fit") {
                EXPECT_EQ(seen.zoom, 1.0);
                EXPECT_EQ(seen.pan_x, 0.0);
                EXPECT_EQ(seen.azimuth_rad, before.azimuth_rad);
                continue;
            }
            EXPECT_EQ(seen.zoom, before.zoom) << "it is as near as before";
            EXPECT_NE(seen.azimuth_rad, before.azimuth_rad) << name.toStdString();
            if (name == "Iso") {
                EXPECT_GT(seen.elevation_rad, 0.0);
                EXPECT_LT(seen.elevation_rad, kQuarter_rad);
                continue;
            }
            EXPECT_NEAR(seen.elevation_rad, name == "Top" ? kQuarter_rad : 0.0, 1e-12) << name.toStdString();
            EXPECT_NEAR(seen.azimuth_rad, name == "Side" ? 0.0 : -kQuarter_rad, 1e-12) << name.toStdString();
        }
        EXPECT_EQ(pressed, 5) << page;
    }
}

TEST_F(EveryButton, SaveAsAsksForANameAndSavesUnderIt) {
    open_window();
    show_page("profile_page");
    edit("core_radius_mm", "1.7");
    const QString path = QString::fromStdString(file("mine.toml"));
    ASSERT_TRUE(comes_true([&] { return button("profile_save_as").isEnabled(); }));
    bool is_asked = false;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, window_.get(), [&] {
        auto* const dialog = open_dialog();
        if (dialog == nullptr || is_asked) return;
        is_asked = true;
        if (auto* const name = dialog->findChild<QLineEdit*>("fileNameEdit")) name->setText(path);
        dialog->accept();
        if (dialog->isVisible()) dialog->reject();  // it would be waited for
    });
    look.start(0);
    button("profile_save_as").click();
    look.stop();
    EXPECT_TRUE(is_asked);
    ASSERT_TRUE(comes_true([&] { return profile().draft().path() == path.toStdString(); }))
        << all_messages().toStdString();
    EXPECT_EQ(load_profile(path.toStdString())->core_radius_mm, 1.7);
    EXPECT_EQ(profile().draft().changed_count(), 0U);
}

TEST_F(EveryButton, OfATimelineGoesToItsEndAndItsBegin) {
    record();
    open_window();
    window_->open(QString::fromStdString(trace()));
    replay::ReplaySession& desk = window_->context().replay;
    ASSERT_TRUE(comes_true([&] { return desk.is_open() && desk.is_settled(); }));
    ASSERT_TRUE(click("replay_begin"));
    EXPECT_EQ(desk.clock().now_ns(), 0);
    ASSERT_TRUE(click("replay_end"));
    EXPECT_EQ(desk.clock().now_ns(), desk.clock().end_ns());
    ASSERT_TRUE(comes_true([&] { return desk.is_settled(); }));
    for (const Axis axis : kAllAxes)
        EXPECT_EQ(desk.view().status->position_pulses[index_of(axis)], end_.position_pulses[index_of(axis)])
            << name_of(axis);
    ASSERT_TRUE(click("replay_begin"));
    EXPECT_EQ(desk.clock().now_ns(), 0);
}

}  // namespace
}  // namespace psicarve::ui
