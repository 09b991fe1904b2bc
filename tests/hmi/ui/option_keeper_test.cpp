// SPDX-License-Identifier: GPL-3.0-or-later
// What the operator has chosen survives the window; what moves the machine does not.
#include <gtest/gtest.h>

#include <QAbstractSlider>
#include <QButtonGroup>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QSpinBox>
#include <QTableView>
#include <algorithm>
#include <map>
#include <set>

#include "hmi/ui/option_keeper.hpp"
#include "hmi/ui/settings.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

using S = MachineState;
using test::KeptSettings;

class KeptOptions : public test::WindowRig {
protected:
    using Values = std::map<QString, double>;

    /// Of each field that is kept: a number, a choice's or a button's place.
    Values values() {
        Values found;
        for (const char* const name : OptionKeeper::names()) {
            auto* const field = window_->findChild<QObject*>(name);
            if (field == nullptr) {
                ADD_FAILURE() << "no field " << name;
                continue;
            }
            found[name] = value_of(*field);
        }
        return found;
    }
    static double value_of(QObject& field) {
        if (auto* group = qobject_cast<QButtonGroup*>(&field)) return group->checkedId();
        if (auto* tick = qobject_cast<QAbstractButton*>(&field)) return tick->isChecked() ? 1 : 0;
        if (auto* box = qobject_cast<QComboBox*>(&field)) return box->currentIndex();
        if (auto* number = qobject_cast<QSpinBox*>(&field)) return number->value();
        if (auto* number = qobject_cast<QDoubleSpinBox*>(&field)) return number->value();
        if (auto* slider = qobject_cast<QAbstractSlider*>(&field)) return slider->value();
        ADD_FAILURE() << field.objectName().toStdString() << " is nothing that has a value";
        return 0.0;
    }
    /// As a hand would, to something else than what it is.
    static void change(QObject& field) {
        if (auto* group = qobject_cast<QButtonGroup*>(&field)) {
            for (QAbstractButton* button : group->buttons()) {
                if (!button->isChecked()) return button->click();
            }
        }
        if (auto* tick = qobject_cast<QAbstractButton*>(&field)) tick->click();
        if (auto* box = qobject_cast<QComboBox*>(&field)) box->setCurrentIndex(1);
        if (auto* number = qobject_cast<QSpinBox*>(&field)) number->setValue(number->value() + 7);
        if (auto* number = qobject_cast<QDoubleSpinBox*>(&field)) number->setValue(number->value() + 1.25);
        if (auto* slider = qobject_cast<QAbstractSlider*>(&field)) slider->setValue(slider->value() - 3);
    }
};

TEST_F(KeptOptions, AreThereInTheNextWindow) {
    open_window();
    const Values usual = values();
    for (const char* const name : OptionKeeper::names()) change(part<QObject>(name));
    const Values chosen = values();
    for (const auto& [name, value] : usual) EXPECT_NE(chosen.at(name), value) << name.toStdString();
    for (const char* const table : {"messages", "entries", "computer_table"})
        part<QTableView>(table).setColumnWidth(1, 133);
    // Nobody closes it.
    ASSERT_TRUE(comes_true([&] { return KeptSettings{}.option("messages_column_1").toInt() == 133; }));
    open_window();
    const Values kept = values();
    for (const auto& [name, value] : chosen) EXPECT_EQ(kept.at(name), value) << name.toStdString();
    for (const char* const table : {"messages", "entries", "computer_table"})
        EXPECT_EQ(part<QTableView>(table).columnWidth(1), 133) << table;
    take_picture("kept_options_light");
}

TEST_F(KeptOptions, AreWrittenByAWindowThatIsClosedAtOnce) {
    open_window();
    part<QSpinBox>("layers").setValue(321);
    EXPECT_TRUE(window_->close());
    open_window();
    EXPECT_EQ(part<QSpinBox>("layers").value(), 321);
}

TEST_F(KeptOptions, AreNotForgottenOverAModelThatHasNoSuchField) {
    open_window();
    part<QComboBox>("up").setCurrentIndex(1);
    window_->open(QString::fromStdString(example("flower.svg")));
    ASSERT_TRUE(comes_true([&] { return part<QComboBox>("axis_at").currentText() == "centroid"; }));
    EXPECT_TRUE(window_->close());
    open_window();
    EXPECT_EQ(part<QComboBox>("up").currentIndex(), 1);
}

TEST_F(KeptOptions, ThatNoFieldCanHaveAreLeftAlone) {
    open_window();
    const Values usual = values();
    const int width_px = part<QTableView>("messages").columnWidth(0);
    window_.reset();
    for (const char* const name : OptionKeeper::names()) KeptSettings{}.set_option(name, "a saw");
    KeptSettings{}.set_option("points", -5);
    KeptSettings{}.set_option("blank_radius", 1e9);
    KeptSettings{}.set_option("jog_linear_speed", 100'000);
    KeptSettings{}.set_option("jog_linear_step", 7);
    KeptSettings{}.set_option("tool", 99);
    KeptSettings{}.set_option("messages_column_0", -20);
    open_window();
    for (const auto& [name, value] : values()) EXPECT_EQ(value, usual.at(name)) << name.toStdString();
    EXPECT_EQ(part<QTableView>("messages").columnWidth(0), width_px);
}

TEST_F(KeptOptions, NeverMoveNorArmNorDriveFaster) {
    start_core();
    open_window();
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(S::ready));
    part<QAbstractSlider>("override").setValue(170);
    ASSERT_TRUE(comes_true([&] { return machine_view().status->override_percent == 170; }));
    button("dry_run").setChecked(true);
    part<QAbstractSlider>("jog_linear_speed").setValue(33);
    ASSERT_TRUE(click("arm_keys"));
    ASSERT_EQ(button("arm_keys").text(), "Disarm keyboard jog");
    EXPECT_TRUE(window_->close());
    window_.reset();
    core_.reset();
    start_core();
    open_window();
    ASSERT_TRUE(comes_to(S::off));
    const auto beat = machine_view().status->heartbeat;
    ASSERT_TRUE(comes_true([&] { return machine_view().status->heartbeat > beat + 5; }));
    EXPECT_EQ(machine_view().state(), S::off);
    EXPECT_EQ(machine_view().status->override_percent, 100U);
    EXPECT_EQ(part<QAbstractSlider>("override").value(), 100);
    EXPECT_FALSE(button("dry_run").isChecked());
    EXPECT_EQ(button("arm_keys").text(), "Arm keyboard jog");
    EXPECT_EQ(part<QAbstractSlider>("jog_linear_speed").value(), 33) << "it was restored all the same";
}

/// Whoever adds a field to the window decides here whether it survives.
TEST_F(KeptOptions, AreAllButThoseThatBelongToOneModelRunOrMoment) {
    open_window();
    std::set<QString> expected{
        // Of one model.
        "axis_at", "axis_x", "axis_y", "height", "scale", "mirror", "turn_x", "turn_y", "turn_z",
        "model_or_piece", "engrave_depth", "engrave_start", "engrave_diameter", "relief_diameter",
        "relief_around", "relief_black", "relief_white", "relief_gamma", "relief_smooth", "relief_seam",
        // Of one run, or of the machine's.
        "override", "rapid_override", "layer", "point", "test_output", "program_from_line",
        // Where one looks at the moment.
        "layer_slider", "point_slider", "layer_number", "map_of", "program_plane"};
    for (const char* const name : OptionKeeper::names()) expected.insert(name);
    const auto is_part_of_something = [](const QObject& field) {
        return field.objectName().startsWith("qt_") ||
               qobject_cast<const QDialog*>(field.parent()) != nullptr;
    };
    const auto check = [&](const QObject& field) {
        const auto* const widget = qobject_cast<const QWidget*>(&field);
        const bool is_in_dialog = widget != nullptr && widget->window() != window_.get();
        const bool is_of_profile =
            widget != nullptr && window_->findChild<QWidget*>("profile_page")->isAncestorOf(widget);
        if (is_part_of_something(field) || is_in_dialog || is_of_profile) return;
        EXPECT_TRUE(expected.contains(field.objectName()))
            << field.metaObject()->className() << " '" << field.objectName().toStdString() << "' in "
            << field.parent()->objectName().toStdString();
    };
    for (QComboBox* field : window_->findChildren<QComboBox*>()) check(*field);
    for (QAbstractSpinBox* field : window_->findChildren<QAbstractSpinBox*>()) check(*field);
    for (QSlider* field : window_->findChildren<QSlider*>()) check(*field);
    for (QButtonGroup* field : window_->findChildren<QButtonGroup*>()) check(*field);
}

}  // namespace
}  // namespace psicarve::ui
