// SPDX-License-Identifier: GPL-3.0-or-later
// Turned, mirrored, made to fit, planned: what comes between a model's file and its publication.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>

#include <fstream>
#include <nlohmann/json.hpp>

#include "hmi/ui/mesh_view.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;
using test::WindowRig;

class PlacedModel : public WindowRig {
protected:
    void open_owl() {
        open_window();
        window_->open(QString::fromStdString(example("figurine.stl")));
        ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
        ASSERT_TRUE(shows("27.3 × 27.7 × 52.6")) << size().toStdString();
    }
    QString size() { return part<QLabel>("mesh_facts").text().section('\n', 0, 0); }
    bool shows(const QString& wanted) {
        return comes_true([&] { return size() == wanted; });
    }
    void tick(const char* name, bool is_on = true) {
        if (button(name).isChecked() != is_on) button(name).click();
    }
    void set(const char* name, double value) { part<QDoubleSpinBox>(name).setValue(value); }
    nlohmann::json sliced_report() {
        part<QSpinBox>("layers").setValue(20);
        part<QSpinBox>("points").setValue(20);
        EXPECT_TRUE(click("slice"));
        EXPECT_TRUE(comes_to(OpenJobState::job)) << all_messages().toStdString();
        return nlohmann::json::parse(window_->context().open_job.job()->view.report_json());
    }
};

TEST_F(PlacedModel, IsTurnedAndMirroredAsInTheCommandLine) {
    ASSERT_NO_FATAL_FAILURE(open_owl());
    EXPECT_FALSE(part<QDoubleSpinBox>("turn_x").isVisible());
    tick("turn");
    EXPECT_TRUE(part<QDoubleSpinBox>("turn_x").isVisible());
    set("turn_x", 90.0);
    ASSERT_TRUE(shows("27.3 × 52.6 × 27.7")) << size().toStdString();
    part<QComboBox>("mirror").setCurrentIndex(2);
    ASSERT_TRUE(comes_true([&] { return window_->context().open_job.mesh()->turn.mirror == 1U; }));
    take_picture("turned_light");
    const auto turn = sliced_report()["turn"];
    EXPECT_EQ(turn["mirror"], "y") << turn.dump();
    EXPECT_EQ(turn["rotate_deg"][0], 90.0) << turn.dump();
    // Another look at the same file keeps it, another file does not.
    window_->open(QString::fromStdString(example("figurine.stl")));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    EXPECT_TRUE(shows("27.3 × 52.6 × 27.7")) << size().toStdString();
    window_->open(QString::fromStdString(example("small.stl")));
    ASSERT_TRUE(comes_true([&] { return !part<QCheckBox>("turn").isChecked(); }));
    ASSERT_TRUE(comes_to(OpenJobState::model));
    EXPECT_FALSE(window_->context().open_job.mesh()->turn.any());
}

TEST_F(PlacedModel, IsAsInItsFileAgainOnceItIsNotTurned) {
    ASSERT_NO_FATAL_FAILURE(open_owl());
    tick("turn");
    set("turn_y", -90.0);
    ASSERT_TRUE(shows("52.6 × 27.7 × 27.3")) << size().toStdString();
    tick("turn", false);
    EXPECT_TRUE(shows("27.3 × 27.7 × 52.6")) << size().toStdString();
    EXPECT_FALSE(window_->context().open_job.mesh()->turn.any());
}

TEST_F(PlacedModel, IsMadeAsLargeAsFits) {
    ASSERT_NO_FATAL_FAILURE(open_owl());
    tick("fit");
    EXPECT_FALSE(part<QDoubleSpinBox>("height").isEnabled());
    EXPECT_EQ(part<QDoubleSpinBox>("scale").toolTip(), "Largest sets it");
    const auto report = sliced_report();
    const Profile machine;
    const double room_mm =
        static_cast<double>(axis_motion(machine, Axis::y).travel_max_pulses) / machine.y.pulses_per_mm -
        machine.job.base_height_mm;
    EXPECT_GT(report["scale"].get<double>(), 1.5) << report.dump();
    EXPECT_TRUE(all_messages().contains("itted")) << all_messages().toStdString();
    EXPECT_LE(report["scale"].get<double>() * 52.6, room_mm + 0.1);
    tick("fit", false);
    EXPECT_TRUE(part<QDoubleSpinBox>("height").isEnabled());
    EXPECT_EQ(sliced_report()["scale"], 1.0);
}

TEST_F(PlacedModel, TellsBeforeItIsPublishedHowLongItTakes) {
    // Beside the programs in their folder it needs no help.
    qputenv("PATH", QByteArray::fromStdString(in_build("bin:")) + qgetenv("PATH"));
    ASSERT_NO_FATAL_FAILURE(open_owl());
    sliced_report();
    const auto time = [&] { return part<QLabel>("job_time").text(); };
    ASSERT_TRUE(comes_true([&] { return time().startsWith("at least "); })) << time().toStdString();
    ASSERT_TRUE(comes_true([&] { return time().endsWith(" planned"); }))
        << time().toStdString() << all_messages().toStdString();
    EXPECT_NE(part<QLabel>("reference").text(), "–");
}

TEST_F(PlacedModel, HasTheNumberOfItsWarningsOnItsTab) {
    ASSERT_NO_FATAL_FAILURE(open_owl());
    const auto* const tabs = window_->findChild<QTabWidget*>();
    EXPECT_EQ(tabs->tabBar()->tabButton(0, QTabBar::RightSide), nullptr) << "the mesh is sound";
    sliced_report();
    const auto& warnings = window_->context().open_job.job()->warnings;
    ASSERT_FALSE(warnings.empty());
    const auto count = [&] {
        const auto* const badge = qobject_cast<QLabel*>(tabs->tabBar()->tabButton(0, QTabBar::RightSide));
        return badge != nullptr ? badge->text() : QString{};
    };
    EXPECT_TRUE(comes_true([&] { return count() == QString::number(warnings.size()); }))
        << count().toStdString();
    EXPECT_EQ(tabs->tabText(0), "Model");
    EXPECT_EQ(tabs->tabBar()->accessibleTabName(0), QString{"Model: %1 to look at"}.arg(warnings.size()));
}

TEST_F(PlacedModel, StandsInTheChosenBlankAndIsWarnedOfBeforeItIsSliced) {
    ASSERT_NO_FATAL_FAILURE(open_owl());
    const auto& label = *part<MeshView>("model_view").findChild<QLabel*>("blank_label");
    ASSERT_TRUE(comes_true([&] { return label.isVisible() && label.text().startsWith("least blank ⌀ "); }))
        << label.text().toStdString();
    const auto& warnings = part<QListWidget>("warnings");
    EXPECT_EQ(warnings.count(), 0);
    set("blank_radius", 17.0);
    set("blank_height", 70.0);
    set("blank_x", -6.0);
    ASSERT_TRUE(comes_true([&] { return label.text() == "blank ⌀ 34.0 mm"; })) << label.text().toStdString();
    ASSERT_EQ(warnings.count(), 1);
    EXPECT_TRUE(warnings.item(0)->text().startsWith("The model stands out of the blank"))
        << warnings.item(0)->text().toStdString();
    take_picture("chosen_blank_light");
    set("blank_x", 0.0);
    EXPECT_TRUE(comes_true([&] { return warnings.count() == 0; }));
    set("blank_radius", 10.0);
    ASSERT_TRUE(comes_true([&] { return warnings.count() == 1; }));
    sliced_report();
    const auto& told = window_->context().open_job.job()->warnings;
    EXPECT_TRUE(comes_true([&] { return static_cast<std::size_t>(warnings.count()) == told.size(); }))
        << "the job's are enough";
}

TEST_F(PlacedModel, WithHolesIsWarnedOfThemOnce) {
    std::ofstream{file("open.obj")}
        << "v -5 -5 0\nv 5 -5 0\nv 5 5 0\nv -5 5 0\nv -5 -5 9\nv 5 -5 9\nv 5 5 9\nv -5 5 9\n"
           "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5\n";
    open_window();
    window_->open(QString::fromStdString(file("open.obj")));
    ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
    sliced_report();
    const auto& warnings = part<QListWidget>("warnings");
    ASSERT_TRUE(comes_true([&] { return warnings.count() > 0; }));
    QStringList told;
    for (int i = 0; i < warnings.count(); ++i) told += warnings.item(i)->text();
    EXPECT_EQ(told.removeDuplicates(), 0) << told.join('\n').toStdString();
    EXPECT_EQ(told.filter("holes").size(), 1) << told.join('\n').toStdString();
    const QStringList messages = all_messages().split('\n');
    for (const QString& warning : told)
        EXPECT_EQ(messages.filter(warning).size(), 1) << warning.toStdString();
}

TEST_F(PlacedModel, IsReportedAsInTheCommandLine) {
    open_window();
    EXPECT_FALSE(button("model_report_open").isEnabled());
    std::ofstream{file("open.obj")}
        << "v -5 -5 0\nv 5 -5 0\nv 5 5 0\nv -5 5 0\nv -5 -5 9\nv 5 -5 9\nv 5 5 9\nv -5 5 9\n"
           "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5\n";
    window_->open(QString::fromStdString(file("open.obj")));
    ASSERT_TRUE(click("model_report_open"));
    const auto report = [this] {
        QStringList text;
        for (const QLabel* label : part<QDialog>("model_report").findChildren<QLabel*>())
            if (label->isVisible()) text += label->text();
        return text.join('\n');
    };
    EXPECT_TRUE(comes_true([&] { return report().contains("holes: 1, open edges: 3"); }))
        << report().toStdString();
    EXPECT_TRUE(report().contains("OBJ, facets: 11")) << report().toStdString();
    EXPECT_TRUE(comes_true([&] { return report().contains("a point leaves nothing"); }))
        << report().toStdString();
    part<QComboBox>("tool").setCurrentIndex(2);
    EXPECT_TRUE(comes_true([&] { return report().contains("More than 0.1 mm on "); }))
        << report().toStdString();
    EXPECT_FALSE(report().contains("…")) << report().toStdString();
    test::keep_picture(part<QDialog>("model_report"), "model_report");
    window_->open(QString::fromStdString(example("small.stl")));
    EXPECT_TRUE(comes_true([&] { return report().startsWith("small.stl"); })) << report().toStdString();
}

TEST_F(PlacedModel, IsEngravedAnewWhenTheMachineHasAnotherTool) {
    open_window();
    std::ofstream{file("line.svg")}
        << R"(<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="20mm")"
        << R"( viewBox="0 0 40 20"><path d="M5 5 H35 V15 H5 Z" stroke="black"/></svg>)";
    window_->open(QString::fromStdString(file("line.svg")));
    ASSERT_TRUE(comes_true([&] { return part<QCheckBox>("engrave").isVisible(); }))
        << all_messages().toStdString();
    tick("engrave");
    ASSERT_TRUE(comes_true([&] {
        const auto mesh = window_->context().open_job.mesh();
        return mesh && mesh->grooves;
    })) << all_messages().toStdString();
    EXPECT_FALSE(part<QCheckBox>("turn").isVisible());
    const auto before = window_->context().open_job.mesh();
    Profile other;
    other.tool = {ToolShape::ball, 2.0, other.tool.angle_deg};
    std::ofstream{file("other.toml")} << profile_to_toml(other);
    window_->context().machine.offer_profile(other);
    start_core({"--profile", file("other.toml")});
    ASSERT_TRUE(comes_true([&] {
        const auto mesh = window_->context().open_job.mesh();
        return mesh && mesh != before && mesh->grooves;
    })) << all_messages().toStdString();
    ASSERT_TRUE(window_->context().open_job.shape().engraving);
    EXPECT_EQ(window_->context().open_job.shape().engraving->tool.diameter_mm, 2.0);
    sliced_report();
    ASSERT_TRUE(click("publish"));
    EXPECT_TRUE(comes_to(OpenJobState::published)) << all_messages().toStdString();
}

}  // namespace
}  // namespace psicarve::ui
