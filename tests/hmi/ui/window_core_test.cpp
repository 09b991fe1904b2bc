// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QDialog>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QKeyEvent>
#include <QLabel>
#include <QRegularExpression>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>

#include <algorithm>
#include <set>
#include <vector>

#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/messages_page.hpp"
#include "hmi/ui/report_dialog.hpp"
#include "hmi/ui/strip.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;
using test::WindowRig;
using S = MachineState;

/// The window and a real core on the simulated machine.
class WindowOnCore : public WindowRig {
protected:
    void open_long_job() { publish_job(two_process::long_job()); }
    void carve_long_job() { carve_job(two_process::long_job()); }
    QByteArray content_of(const char* name) const {
        QFile saved{QString::fromStdString(file(name))};
        return saved.open(QIODevice::ReadOnly) ? saved.readAll() : QByteArray{};
    }
};

TEST_F(WindowOnCore, CarvesAlthoughTheFeedIsChangedOnTheWayToTheFirstPoint) {
    start_core();
    open_window();
    open_long_job();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(click("start"));
    auto& slider = *window_->findChild<QSlider*>("override");
    int percent = 100;
    ASSERT_TRUE(comes_true([&] {
        slider.setValue(percent = percent == 100 ? 90 : 100);
        return machine_view().state() == S::carving;
    }));
}

TEST_F(WindowOnCore, CarvesHoldsResumesStopsInAnEmergencyAndGoesOn) {
    start_core();
    open_window();
    carve_long_job();
    take_picture("carving_light");
    EXPECT_FALSE(button("start").isEnabled());
    EXPECT_EQ(button("start").toolTip(), "Start: already carving");
    window_->findChild<QSlider*>("override")->setValue(130);
    ASSERT_TRUE(comes_true([&] { return machine_view().status->override_percent == 130; }));
    window_->findChild<QSlider*>("rapid_override")->setValue(40);
    ASSERT_TRUE(comes_true([&] { return machine_view().status->rapid_override_percent == 40; }));
    ASSERT_TRUE(click("full"));
    ASSERT_TRUE(comes_true([&] { return machine_view().status->override_percent == 100; }));
    ASSERT_TRUE(click("hold"));
    ASSERT_TRUE(comes_to(S::held));
    take_picture("held_light");
    ASSERT_TRUE(click("resume"));
    ASSERT_TRUE(comes_to(S::carving));
    QKeyEvent press{QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier};
    QApplication::sendEvent(window_.get(), &press);
    ASSERT_TRUE(comes_to(S::alarm));
    window_->set_theme(ThemeChoice::dark);
    take_picture("alarm_dark");
    EXPECT_EQ(window_->findChild<QLabel*>("alarm_title")->text(), "Emergency stop");
    const int layer = window_->findChild<QSpinBox*>("layer")->value();
    const CoreStatus& stopped = *machine_view().status;
    EXPECT_EQ(layer,
              static_cast<int>(stopped.points_done / (stopped.points_total / two_process::kLongLayers)) + 1);
    ASSERT_TRUE(click("reset_alarm"));
    ASSERT_TRUE(comes_to(S::off));
    EXPECT_TRUE(button("start").toolTip().endsWith("is not homed"))
        << button("start").toolTip().toStdString();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    window_->context().machine.start(static_cast<std::uint32_t>(layer - 1));
    ASSERT_TRUE(comes_to(S::carving));
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
}

TEST_F(WindowOnCore, CarvesLayerAfterLayer) {
    start_core();
    open_window();
    open_long_job();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    auto* const layer = window_->findChild<QSpinBox*>("layer");
    for (const int carved : {1, 2, 3}) {
        EXPECT_EQ(layer->value(), carved);
        ASSERT_TRUE(click("one_layer"));
        ASSERT_TRUE(comes_true([&] {
            return machine_view().state() == S::ready && layer->value() == carved + 1;
        })) << all_messages().toStdString();
        EXPECT_EQ(machine_view().status->points_done, static_cast<std::uint64_t>(carved) * 201);
    }
    take_picture("one_layer_light");
}

TEST_F(WindowOnCore, KeepsALogSavesABundleAndReportsTheRun) {
    start_core();
    open_window();
    // What the core accepts before it was heard first is no news.
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard(); }));
    EXPECT_FALSE(button("report_button").isEnabled());
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(two_process::lobed_job(3, 40));
    ASSERT_TRUE(save_snapshot(snapshot, file("short.job")));
    window_->open(QString::fromStdString(file("short.job")));
    ASSERT_TRUE(comes_to(OpenJobState::job));
    EXPECT_EQ(button("report_button").toolTip(), "Report: no job was started");
    window_->context().open_job.publish();
    ASSERT_TRUE(comes_to(OpenJobState::published));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    const auto text = [&](const char* name) { return window_->findChild<QLabel*>(name)->text(); };
    ASSERT_TRUE(comes_true([&] { return text("job_time").endsWith(" planned"); }));
    EXPECT_EQ(text("job_time"), text("reference") + " planned");
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_true([&] { return window_->context().runs.is_over(); }))
        << all_messages().toStdString();
    ASSERT_TRUE(click("report_button"));
    auto* const report = static_cast<ReportDialog*>(window_->findChild<QDialog*>("report"));
    ASSERT_NE(report, nullptr);
    test::keep_picture(*report, "report_light");
    report->save(QString::fromStdString(file("report.json")));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("report.json"); }))
        << all_messages().toStdString();
    const QByteArray json = content_of("report.json");
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    EXPECT_EQ(object["layers"].toInt(), 3) << json.toStdString();
    EXPECT_GT(object["carve_seconds"].toDouble(), 0.0);
    EXPECT_GT(object["reference_seconds"].toDouble(), 0.0);
    EXPECT_EQ(object["pulses"].toObject()["psi"].toInteger(),
              static_cast<qint64>(machine_view().status->emitted_pulses[index_of(Axis::psi)]));
    EXPECT_TRUE(object["verified"].isNull());
    auto* const page = static_cast<MessagesPage*>(window_->findChild<QWidget*>("messages_page"));
    page->save_log(QString::fromStdString(file("saved.log")));
    page->save_bundle(QString::fromStdString(file("")));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("Support bundle: "); }))
        << all_messages().toStdString();
    EXPECT_TRUE(content_of("saved.log").contains("Job no. 1 accepted"));
    const QDir bundle{
        QDir{QString::fromStdString(file(""))}.entryInfoList({"psicarve-support-*"}).front().filePath()};
    for (const char* name :
         {"messages.txt", "profile.toml", "snapshot.psi", "versions.txt", "psicarve-hmi.log"})
        EXPECT_TRUE(bundle.exists(name)) << name;
    const auto saved = load_snapshot(bundle.filePath("snapshot.psi").toStdString());
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->job_blob, snapshot.job_blob);
    window_.reset();
    EXPECT_TRUE(content_of("state/psicarve/psicarve-hmi.log").contains("report.json"));
}

TEST_F(WindowOnCore, TakesAModelFromItsFileToACarvedPiece) {
    start_core();
    open_window();
    auto* const tabs = window_->findChild<QTabWidget*>();
    window_->open(QString::fromStdString(example("figurine.stl")));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    take_picture("model_light");
    window_->findChild<QSpinBox*>("layers")->setValue(120);
    window_->findChild<QSpinBox*>("points")->setValue(100);
    EXPECT_EQ(button("publish").toolTip(), "Publish: there is no job; slice the model first");
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(OpenJobState::job));
    EXPECT_TRUE(button("start").toolTip().endsWith("is not homed"))
        << button("start").toolTip().toStdString();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_EQ(button("start").toolTip(), "Start: the job is not published");
    ASSERT_TRUE(click("publish"));
    ASSERT_TRUE(comes_to(OpenJobState::published));
    tabs->setCurrentIndex(1);
    auto* const slider = window_->findChild<QSlider*>("layer_slider");
    ASSERT_TRUE(comes_true([&] { return slider->maximum() == 120; }));
    slider->setValue(60);
    EXPECT_EQ(window_->findChild<QSpinBox*>("layer_number")->value(), 60);
    take_picture("layers_light");
    ASSERT_TRUE(click("start"));
    tabs->setCurrentIndex(2);
    ASSERT_TRUE(comes_true([&] { return machine_view().status->points_done > 6'000; }))
        << all_messages().toStdString();
    take_picture("carving_view_light");
    EXPECT_TRUE(window_->findChild<QLabel*>("axis_speed_psi")->text().endsWith(" °/s"));
    auto& view = *static_cast<MeshView*>(window_->findChild<QWidget*>("carving_view"));
    const auto colours = [&view] {
        const auto& rgb = view.picture().bodies.front().scene->vertex_rgb;
        return std::set<std::uint32_t>{rgb.begin(), rgb.end()};
    };
    const auto plain = colours();
    EXPECT_LE(plain.size(), 2U);  // carved and, if it is not over yet, blank
    ASSERT_TRUE(click("colour_radius"));
    ASSERT_TRUE(comes_true([&] { return colours().size() > 20; }));
    take_picture("carving_radius_light");
    ASSERT_TRUE(click("colour_deviation"));
    ASSERT_TRUE(comes_true([&] { return true; }));
    take_picture("carving_deviation_light");
    // The core is exact: hardly a cell is blue or brown, however far it has come.
    const auto& painted = view.picture().bodies.front().scene->vertex_rgb;
    const auto is_plain = [&](std::uint32_t rgb) { return plain.contains(rgb); };
    const auto grey = static_cast<std::size_t>(std::count_if(painted.begin(), painted.end(), is_plain));
    EXPECT_GT(grey, painted.size() / 10 * 9);
    ASSERT_TRUE(click("colour_done"));
    ASSERT_TRUE(comes_true([&] {
        return machine_view().state() == S::ready &&
               machine_view().status->points_done == machine_view().status->points_total;
    })) << all_messages().toStdString();
    window_->set_theme(ThemeChoice::dark);
    ASSERT_TRUE(comes_true([&] { return true; }));
    take_picture("carved_dark");
    tabs->setCurrentIndex(1);
    ASSERT_TRUE(comes_true([&] { return true; }));
    take_picture("layers_dark");
    tabs->setCurrentIndex(3);
    ASSERT_TRUE(comes_true([&] { return true; }));
    take_picture("messages_dark");
}

TEST_F(WindowOnCore, ShowsAFreshBlankWhenItStartsAnew) {
    start_core();
    open_window();
    auto* const tabs = window_->findChild<QTabWidget*>();
    auto& view = *static_cast<MeshView*>(window_->findChild<QWidget*>("carving_view"));
    const auto colours = [&]() -> std::vector<std::uint32_t> {
        return view.picture().bodies.empty() ? std::vector<std::uint32_t>{}
                                             : view.picture().bodies.front().scene->vertex_rgb;
    };
    carve_long_job();
    tabs->setCurrentIndex(2);
    ASSERT_TRUE(comes_true([&] { return machine_view().status->layer > 100; }));
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(comes_true([&] { return !colours().empty() && colours().front() != colours().back(); }));
    const auto before = colours();
    const auto carved = std::count(before.begin(), before.end(), before.front());
    EXPECT_GT(carved, 0);
    ASSERT_TRUE(click_and_answer("start_anew", "anew_go"));
    ASSERT_TRUE(click("hold"));
    ASSERT_TRUE(comes_to(S::held));
    ASSERT_TRUE(comes_true([&] {
        const auto now = colours();
        return !now.empty() && std::count(now.begin(), now.end(), now.back()) > std::ssize(now) - carved;
    }));
}

TEST_F(WindowOnCore, JogsAStepOnAClickAndOnAndOnWhileHeld) {
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    const auto y_pulses = [&] { return machine_view().status->position_pulses[index_of(Axis::y)]; };
    const auto from_pulses = y_pulses();
    ASSERT_TRUE(click("jog_y_up"));
    ASSERT_TRUE(comes_true([&] {
        return y_pulses() == from_pulses + 40 && machine_view().state() == S::ready;
    })) << all_messages().toStdString();
    button("jog_y_up").setDown(true);
    Q_EMIT button("jog_y_up").pressed();
    ASSERT_TRUE(comes_true([&] { return y_pulses() > from_pulses + 40; })) << all_messages().toStdString();
    Q_EMIT button("jog_y_up").released();
    ASSERT_TRUE(comes_to(S::ready));
}

TEST_F(WindowOnCore, AsksBeforeItLeavesAMachineAtWork) {
    start_core();
    open_window();
    carve_long_job();
    int asked = 0;
    CloseChoice choice = CloseChoice::stay_open;
    window_->set_close_question([&] {
        ++asked;
        return choice;
    });
    EXPECT_FALSE(window_->close());
    EXPECT_EQ(asked, 1);
    choice = CloseChoice::leave_running;
    EXPECT_TRUE(window_->close());
    window_.reset();
    EXPECT_TRUE(reaches(S::carving));
    open_window();  // and finds the job again
    ASSERT_TRUE(comes_to(OpenJobState::published));
    ASSERT_TRUE(comes_to(S::carving));
    choice = CloseChoice::hold;
    window_->set_close_question([&] { return choice; });
    EXPECT_FALSE(window_->close()) << "not before the core has taken it";
    ASSERT_TRUE(comes_true([&] { return !window_->isVisible(); }));
    EXPECT_TRUE(reaches(S::held));
    open_window();
    ASSERT_TRUE(comes_to(S::held));
    choice = CloseChoice::stop;
    window_->set_close_question([&] { return choice; });
    EXPECT_TRUE(window_->close());
    EXPECT_TRUE(reaches(S::ready));
}

TEST_F(WindowOnCore, TellsTheRunningJobFromTheOneThatWasSlicedMeanwhile) {
    start_core();
    open_window();
    auto* const tabs = window_->findChild<QTabWidget*>();
    tabs->setCurrentIndex(2);
    carve_long_job();
    const auto running = window_->context().open_job.core_job();
    ASSERT_NE(running, nullptr);
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    EXPECT_EQ(part<QLabel>("desk_job").text(), "small.stl");
    EXPECT_EQ(part<QLabel>("desk_job_note").text(), "not sliced");
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(OpenJobState::job));
    ASSERT_EQ(machine_view().state(), S::carving) << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return part<QLabel>("desk_job_note").text() == "not published"; }));
    EXPECT_TRUE(part<QLabel>("desk_job").isVisible());
    EXPECT_EQ(part<QLabel>("machine_job").text(), "lobed");
    EXPECT_TRUE(part<QLabel>("machine_job_note").text().startsWith("no. 1")) << "how far it is";
    EXPECT_EQ(window_->context().open_job.core_job(), running);
    EXPECT_EQ(window_->context().open_job.view().core_layer_count, two_process::kLongLayers);
    auto& view = *static_cast<MeshView*>(window_->findChild<QWidget*>("carving_view"));
    EXPECT_FALSE(view.picture().bodies.empty());
    take_picture("running_and_next_light");
    ASSERT_TRUE(click("stop"));
    ASSERT_TRUE(comes_to(S::ready));
    EXPECT_EQ(button("start").toolTip(), "Start: the job is not published");
    EXPECT_EQ(window_->findChild<QSpinBox*>("layer")->value(), 1);
}

TEST_F(WindowOnCore, ShowsThatTheCoreIsGone) {
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    auto* const position = window_->findChild<QLabel*>("position_r1");
    const QString last = position->text();
    EXPECT_FALSE(position->font().strikeOut());
    core_.reset();
    ASSERT_TRUE(comes_true([&] { return !button("home").isEnabled(); }));
    EXPECT_TRUE(position->font().strikeOut());
    EXPECT_EQ(position->text(), last);
    EXPECT_TRUE(all_messages().contains("The core has ended"));
    const auto labels = window_->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return QRegularExpression{"^last known [0-2][0-9]:[0-5][0-9]:[0-5][0-9]$"}
            .match(label->text())
            .hasMatch();
    }));
}

}  // namespace
}  // namespace psicarve::ui
