// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings, pictures and tables in the window, as `psicarve slice` takes them.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <QUrl>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hmi/ui/file_filters.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using session::OpenJobState;

class FlatFiles : public test::WindowRig {
protected:
    QString written(const std::string& name, const std::string& content) const {
        std::ofstream{file(name), std::ios::binary} << content;
        return QString::fromStdString(file(name));
    }
    /// Bright above dark, as wide as high.
    QString picture() const {
        std::string rows = "P2 40 40 9\n";
        for (int i = 0; i < 40 * 40; ++i) rows += i < 800 ? "9 " : "0 ";
        return written("relief.pgm", rows);
    }
    void set(const char* name, double value) { part<QDoubleSpinBox>(name).setValue(value); }
    QString facts() { return part<QLabel>("mesh_facts").text().section('\n', 0, 0); }
    bool shows(const QString& size) {
        return comes_true([&] { return facts() == size; });
    }
    /// What stands in space, as it is drawn.
    std::shared_ptr<const session::MeshScene> shown() {
        const auto& bodies = part<MeshView>("model_view").picture().bodies;
        return bodies.empty() ? nullptr : bodies.front().scene;
    }
    /// The same once the form's last word is in it, whatever its colours are by then.
    std::shared_ptr<const session::MeshScene> settled() {
        EXPECT_TRUE(comes_true([&] {
            const auto scene = shown();
            const auto wanted = window_->context().open_job.scene();
            return !window_->context().open_job.view().is_busy() && scene && wanted &&
                   scene->vertices == wanted->vertices;
        }));
        return shown();
    }
    void slice_coarsely() {
        part<QSpinBox>("layers").setValue(20);
        part<QSpinBox>("points").setValue(20);
        ASSERT_TRUE(click("slice"));
        ASSERT_TRUE(comes_to(OpenJobState::job)) << all_messages().toStdString();
    }
    void drop(const QString& path) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDropEvent event{QPointF{400, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier};
        static_cast<QObject&>(*window_).event(&event);
    }
};

/// A vertex of an upright body about its own axis.
struct Spot {
    double radius_mm;
    double direction_rad;  ///< from 0 on
    double height_mm;      ///< from the body's middle
};

/// Of the body's side; the middles of its lids stand on the axis.
std::vector<Spot> spots_of(const session::MeshScene& scene) {
    std::vector<Spot> spots;
    for (const auto& vertex : scene.vertices) {
        const double x = double{vertex[0]} + scene.middle[0];
        const double y = double{vertex[1]} + scene.middle[1];
        const double direction = std::atan2(y, x);
        if (std::hypot(x, y) > 1.0)
            spots.push_back(
                {std::hypot(x, y), direction < 0.0 ? direction + 2.0 * kPi : direction, vertex[2]});
    }
    return spots;
}

TEST_F(FlatFiles, OpenADrawingThatIsDroppedAndMakeItHigher) {
    open_window();
    drop(QString::fromStdString(example("flower.svg")));
    ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
    ASSERT_TRUE(shows("41.5 × 41.5 × 20.0")) << facts().toStdString();
    EXPECT_FALSE(part<QComboBox>("up").isVisible());
    EXPECT_FALSE(part<QDoubleSpinBox>("relief_diameter").isVisible());
    EXPECT_EQ(part<QComboBox>("axis_at").currentText(), "centroid");
    set("height", 30.0);
    ASSERT_TRUE(shows("41.5 × 41.5 × 30.0")) << "as wide as before: " << facts().toStdString();
    set("scale", 0.5);
    ASSERT_TRUE(comes_true([&] { return facts().startsWith("20."); })) << facts().toStdString();
    EXPECT_TRUE(facts().endsWith(" × 30.0")) << "scaled, but not in height: " << facts().toStdString();
    ASSERT_NO_FATAL_FAILURE(slice_coarsely());
    const auto job = window_->context().open_job.job();
    EXPECT_EQ(job->view.source_name(), "flower.svg");
    EXPECT_EQ(job->view.layer_count(), 20U);
    take_picture("drawing_light");
    // What was sliced is not what the fields say any more.
    EXPECT_TRUE(comes_true([&] { return part<QLabel>("desk_state").text().startsWith("The job is ready"); }))
        << part<QLabel>("desk_state").text().toStdString();
    part<QSpinBox>("layers").setValue(21);
    EXPECT_TRUE(comes_true([&] { return part<QLabel>("desk_state").text().startsWith("Changed since"); }))
        << part<QLabel>("desk_state").text().toStdString();
    ASSERT_NO_FATAL_FAILURE(slice_coarsely());
    EXPECT_TRUE(comes_true([&] { return part<QLabel>("desk_state").text().startsWith("The job is ready"); }));
    window_->findChild<QTabWidget*>()->setCurrentIndex(1);
    ASSERT_TRUE(comes_true([&] {
        return part<QSlider>("layer_slider").toolTip().contains("takes at least 0:0");
    })) << part<QSlider>("layer_slider").toolTip().toStdString();
    EXPECT_TRUE(part<QLabel>("job_bound").text().contains(" %"))
        << part<QLabel>("job_bound").text().toStdString();
    EXPECT_TRUE(test::KeptSettings{}.recent_files().contains(QString::fromStdString(example("flower.svg"))));
    // A mesh is as it is in its file again.
    EXPECT_FALSE(part<QLabel>("layers_none").isVisible());
    window_->open(QString::fromStdString(example("small.stl")));
    EXPECT_TRUE(comes_true([&] { return part<QLabel>("layers_none").isVisible(); }))
        << "the layers of the model before";
    window_->findChild<QTabWidget*>()->setCurrentIndex(0);
    ASSERT_TRUE(comes_true([&] { return part<QComboBox>("up").isVisible(); }));
    EXPECT_EQ(part<QDoubleSpinBox>("height").value(), 0.0);
    EXPECT_EQ(part<QDoubleSpinBox>("scale").value(), 0.0);
}

TEST_F(FlatFiles, EngraveADrawingOfOpenLinesAsSoonAsItIsOpen) {
    open_window();
    const QString path = written("waves.svg",
                                 "<svg width='60mm' height='20mm' viewBox='0 0 60 20'>"
                                 "<path d='M5 10 Q 15 0 25 10 T 45 10' fill='none' stroke='black'/></svg>");
    drop(path);
    ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
    EXPECT_TRUE(all_messages().contains("waves.svg has no closed outline: its lines are engraved"));
    EXPECT_FALSE(all_messages().contains("longest stroke")) << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return part<QCheckBox>("engrave").isChecked(); }));
    EXPECT_TRUE(part<QDoubleSpinBox>("engrave_depth").isVisible());
    ASSERT_TRUE(comes_true([&] { return facts().startsWith("40.0 × 40.0 × "); })) << facts().toStdString();
    set("engrave_diameter", 30.0);
    ASSERT_TRUE(comes_true([&] { return facts().startsWith("30.0 × 30.0 × "); })) << facts().toStdString();
    // The same file again is what the form says of it.
    window_->open(path);
    ASSERT_TRUE(comes_true([&] { return !window_->context().open_job.view().is_busy(); }));
    EXPECT_TRUE(part<QCheckBox>("engrave").isChecked());
    EXPECT_TRUE(facts().startsWith("30.0 × 30.0 × ")) << facts().toStdString();
    take_picture("open_lines_light");
    const auto& fields = part<QScrollArea>("model_fields");
    for (const auto* field : fields.widget()->findChildren<QAbstractSpinBox*>()) {
        const int right = field->mapTo(fields.viewport(), QPoint{field->width(), 0}).x();
        EXPECT_TRUE(!field->isVisible() || right <= fields.viewport()->width()) << "cut off: " << right;
    }
    ASSERT_NO_FATAL_FAILURE(slice_coarsely());
    EXPECT_EQ(window_->context().open_job.job()->view.source_name(), "waves.svg");
    // Another drawing is one to be extruded again.
    window_->open(QString::fromStdString(example("flower.svg")));
    ASSERT_TRUE(shows("41.5 × 41.5 × 20.0")) << facts().toStdString();
    EXPECT_FALSE(part<QCheckBox>("engrave").isChecked());
}

TEST_F(FlatFiles, OfferAnotherCylinderForOpenLinesThatDoNotFit) {
    open_window();
    window_->open(written("wide.svg",
                          "<svg width='200mm' height='9mm' viewBox='0 0 200 9'>"
                          "<path d='M5 5 L150 5' fill='none' stroke='black'/></svg>"));
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("choose a scale of at most"); }))
        << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return part<QCheckBox>("engrave").isVisible(); }));
    EXPECT_TRUE(part<QCheckBox>("engrave").isChecked());
    EXPECT_FALSE(button("slice").isEnabled());
    set("engrave_diameter", 60.0);
    ASSERT_TRUE(comes_true([&] { return facts().startsWith("60.0 × 60.0 × "); }))
        << all_messages().toStdString();
    EXPECT_TRUE(comes_true([&] { return button("slice").isEnabled(); }));
}

TEST_F(FlatFiles, WrapAPictureRoundACylinder) {
    open_window();
    window_->open(picture());
    ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
    ASSERT_TRUE(shows("40.0 × 40.0 × 125.7")) << facts().toStdString();
    EXPECT_TRUE(part<QDoubleSpinBox>("relief_diameter").isVisible());
    EXPECT_FALSE(part<QComboBox>("axis_at").isVisible());
    set("relief_diameter", 20.0);
    ASSERT_TRUE(shows("20.0 × 20.0 × 62.8")) << facts().toStdString();
    EXPECT_NEAR(part<QDoubleSpinBox>("relief_around").value(), 62.83, 0.001);
    set("relief_around", 94.25);
    EXPECT_NEAR(part<QDoubleSpinBox>("relief_diameter").value(), 30.0, 0.001);
    ASSERT_TRUE(shows("30.0 × 30.0 × 94.2")) << facts().toStdString();
    set("relief_around", 62.83);
    set("relief_black", 4.0);
    button("relief_invert").click();
    EXPECT_TRUE(window_->context().open_job.view().is_busy()) << "the second wish waits for the first";
    ASSERT_TRUE(comes_true([&] { return !window_->context().open_job.view().is_busy(); }));
    ASSERT_NO_FATAL_FAILURE(slice_coarsely());
    take_picture("picture_light");
    const auto job = window_->context().open_job.job();
    // Dark is at the lower half of the picture, which now is the higher surface.
    EXPECT_NEAR(static_cast<double>(job->view.r_left_pulses(1)[5]) / 400.0, 10.0, 0.01);
    EXPECT_NEAR(static_cast<double>(job->view.r_left_pulses(18)[5]) / 400.0, 6.0, 0.01);
}

/// Of a picture whose upper half is bright in its first three quarters, and the lower in its first; round a
/// cylinder, from direction 0 on. Nothing beside the edges of these fields.
std::optional<bool> is_bright(const Spot& spot, double height_mm) {
    constexpr double kBeside = 0.05;
    const double column = spot.direction_rad / (2.0 * kPi);
    const double row = 0.5 - spot.height_mm / height_mm;
    const double edge = row < 0.5 ? 0.75 : 0.25;
    if (std::min({std::abs(column - edge), std::abs(row - 0.5), column, 1.0 - column}) < kBeside)
        return std::nullopt;
    return column < edge;
}

TEST_F(FlatFiles, ShowAPictureOnItsCylinderBeforeAnythingIsSliced) {
    std::string rows = "P2 40 40 9\n";
    for (int i = 0; i < 40 * 40; ++i) rows += i % 40 < (i < 800 ? 30 : 10) ? "9 " : "0 ";
    open_window();
    window_->open(written("fields.pgm", rows));
    ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
    set("relief_diameter", 20.0);
    set("relief_black", 3.0);
    const auto expect_depths = [](const session::MeshScene& scene, double bright_mm, double dark_mm) {
        std::array<int, 2> looked_at{};
        for (const Spot& spot : spots_of(scene)) {
            const auto bright = is_bright(spot, scene.size[2]);
            if (!bright) continue;
            ++looked_at[*bright ? 1 : 0];
            ASSERT_NEAR(spot.radius_mm, *bright ? bright_mm : dark_mm, 0.01)
                << spot.direction_rad << ' ' << spot.height_mm;
        }
        EXPECT_GT(std::min(looked_at[0], looked_at[1]), 1000);
    };
    const auto before = settled();
    ASSERT_TRUE(before);
    expect_depths(*before, 10.0, 7.0);
    take_picture("picture_unsliced");
    button("relief_invert").click();
    const auto inverted = settled();
    ASSERT_TRUE(inverted);
    EXPECT_NE(inverted->vertices, before->vertices);
    expect_depths(*inverted, 7.0, 10.0);
    EXPECT_FALSE(window_->context().open_job.job()) << "nothing was sliced";
}

/// From the wave that is drawn below, on the surface that is unrolled from direction 0 on.
double from_wave_mm(double along_mm, double up_mm) {
    double nearest = 1e9;
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 200.0;
        const double rise = 20.0 * t * (1.0 - t);
        nearest = std::min({nearest, std::hypot(along_mm - 20.0 * t, up_mm - rise),
                            std::hypot(along_mm - 20.0 - 20.0 * t, up_mm + rise)});
    }
    return nearest;
}

TEST_F(FlatFiles, ShowAGrooveWhereItIsCutBeforeAnythingIsSliced) {
    open_window();
    part<QComboBox>("tool").setCurrentIndex(2);
    set("tool_diameter", 3.0);
    window_->open(written("waves.svg",
                          "<svg width='60mm' height='20mm' viewBox='0 0 60 20'>"
                          "<path d='M5 10 Q 15 0 25 10 T 45 10' fill='none' stroke='black'/></svg>"));
    ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
    ASSERT_TRUE(comes_true([&] { return part<QCheckBox>("engrave").isChecked(); }));
    set("engrave_diameter", 30.0);
    set("engrave_depth", 0.6);
    const auto scene = settled();
    ASSERT_TRUE(scene);
    int deep = 0;
    for (const Spot& spot : spots_of(*scene)) {
        const double along_mm = spot.direction_rad * 15.0;
        // The wave begins at direction 0, and its groove before it.
        const double off_mm = std::min(from_wave_mm(along_mm, spot.height_mm),
                                       from_wave_mm(along_mm - 2.0 * kPi * 15.0, spot.height_mm));
        const double ball_mm = off_mm < 1.5 ? 1.5 - std::sqrt(1.5 * 1.5 - off_mm * off_mm) : 1.5;
        ASSERT_NEAR(spot.radius_mm, 15.0 - std::max(0.0, 0.6 - ball_mm), 0.02)
            << spot.direction_rad << ' ' << spot.height_mm;
        deep += off_mm < 0.1 ? 1 : 0;
    }
    EXPECT_GT(deep, 100);
    take_picture("groove_unsliced");
    EXPECT_FALSE(window_->context().open_job.job()) << "nothing was sliced";
}

TEST_F(FlatFiles, ShowNoBodyThatWasNotAskedFor) {
    open_window();
    window_->open(picture());
    ASSERT_TRUE(comes_to(OpenJobState::model));
    set("height", 150.0);
    ASSERT_TRUE(comes_true([&] { return all_messages().contains("choose at most 125.66 mm of height"); }))
        << all_messages().toStdString();
    EXPECT_TRUE(comes_true([&] { return !button("slice").isEnabled(); }));
    EXPECT_EQ(facts(), "");
    button("relief_full_turn").click();
    ASSERT_TRUE(shows("40.0 × 40.0 × 150.0")) << all_messages().toStdString();
    EXPECT_TRUE(comes_true([&] { return button("slice").isEnabled(); }));
}

TEST_F(FlatFiles, TakeATableAsAJob) {
    open_window();
    window_->open(written("radii.csv", "y_mm,r_mm\n1,10,11,12,11\n2,9,10,11,10\n"));
    ASSERT_TRUE(comes_to(OpenJobState::job)) << all_messages().toStdString();
    const auto job = window_->context().open_job.job();
    EXPECT_EQ(job->view.layer_count(), 2U);
    EXPECT_EQ(job->view.point_count(), 3U);
    EXPECT_EQ(job->view.source_name(), "radii.csv");
    window_->open(written("wrong.csv", "y_mm,r_mm\n1,10,x\n"));
    EXPECT_TRUE(comes_true([&] {
        return all_messages().contains("line 2: 'x' is not a number that a table");
    })) << all_messages().toStdString();
    EXPECT_EQ(window_->context().open_job.job(), job) << "what is open stays open";
}

TEST_F(FlatFiles, AreReloadedAsTheFormHasThemWhenTheyWereWrittenAnew) {
    open_window();
    const QString path =
        written("one.svg", "<svg width='9mm' height='9mm'><rect width='5' height='5'/></svg>");
    window_->open(path);
    ASSERT_TRUE(comes_to(OpenJobState::model)) << all_messages().toStdString();
    set("height", 30.0);
    ASSERT_TRUE(comes_true([&] { return facts().endsWith("× 30.0"); })) << facts().toStdString();
    const QString before = facts();
    EXPECT_FALSE(button("reload").isVisible());
    written("one.svg", "<svg width='90mm' height='90mm'><rect width='50' height='50'/></svg>");
    ASSERT_TRUE(comes_true([&] { return button("reload").isVisible(); }));
    EXPECT_TRUE(all_messages().contains("one.svg was written since it was opened"))
        << all_messages().toStdString();
    ASSERT_TRUE(click("reload"));
    ASSERT_TRUE(comes_true([&] { return facts() != before; }));
    EXPECT_TRUE(facts().endsWith("× 30.0")) << facts().toStdString();
    EXPECT_TRUE(comes_true([&] { return !button("reload").isVisible(); }));
}

TEST_F(FlatFiles, StandInTheFiltersOfTheDialog) {
    const QStringList filters = filters_of_files().split(";;");
    for (const char* ending : {"stl", "obj", "ply", "3mf", "off", "svg", "dxf", "png", "jpg", "jpeg", "tif",
                               "tiff", "bmp", "pgm", "csv", "job", "psi", "snap", "trace"}) {
        const QString pattern = QStringLiteral("*.") + ending;
        EXPECT_EQ(filters.filter(pattern + " ").size() + filters.filter(pattern + ")").size(), 2)
            << ending << ": among all, and among its kind";
    }
}

}  // namespace
}  // namespace psicarve::ui
