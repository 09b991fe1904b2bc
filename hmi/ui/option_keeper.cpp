// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/option_keeper.hpp"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QSpinBox>
#include <QTableView>

#include <string_view>
#include <utility>

#include "hmi/ui/field_value.hpp"
#include "hmi/ui/settings.hpp"

namespace psicarve::ui {
namespace {

// A field that is filled in by another one stands behind it.
constexpr const char* kKeptFields[] = {
    "jog_linear_step",
    "jog_angular_step",
    "jog_linear_speed",
    "jog_angular_speed",
    "up",
    "layers",
    "points",
    "joining",
    "tool",
    "tool_diameter",
    "tool_angle",
    "tool_flute",
    "blank_radius",
    "blank_height",
    "blank_x",
    "blank_z",
    "depth_limit",
    "roughing",
    "stepdown",
    "allowance",
    "stepover",
    "colouring",
    "messages_kind",
    "messages_span",
    "alarm_sound",
    "latency_seconds",
    "latency_period",
    "latency_cpu",
    "test_rate",
    "test_pulses",
};

bool drives_machine(std::string_view name) {
    return name.starts_with("jog_") || name.starts_with("test_");
}

/// The first columns of a table; the others take the room that is left.
struct KeptColumns {
    const char* table;
    int count;
};
constexpr KeptColumns kKeptColumns[] = {{"messages", 3}, {"entries", 2}, {"computer_table", 2}};
constexpr int kLeastColumn_px = 16;
constexpr int kMostColumn_px = 2'000;

QString name_of_column(const QTableView& table, int column) {
    return QStringLiteral("%1_column_%2").arg(table.objectName()).arg(column);
}

template <typename Told>
void at_each_change(QObject& field, QObject& listener, Told told) {
    if (auto* group = qobject_cast<QButtonGroup*>(&field))
        QObject::connect(group, &QButtonGroup::idToggled, &listener, [told](int, bool is_on) {
            if (is_on) told();
        });
    if (auto* button = qobject_cast<QAbstractButton*>(&field))
        QObject::connect(button, &QAbstractButton::toggled, &listener, told);
    if (auto* box = qobject_cast<QComboBox*>(&field))
        QObject::connect(box, &QComboBox::currentIndexChanged, &listener, told);
    if (auto* number = qobject_cast<QSpinBox*>(&field))
        QObject::connect(number, &QSpinBox::valueChanged, &listener, told);
    if (auto* number = qobject_cast<QDoubleSpinBox*>(&field))
        QObject::connect(number, &QDoubleSpinBox::valueChanged, &listener, told);
    if (auto* slider = qobject_cast<QAbstractSlider*>(&field))
        QObject::connect(slider, &QAbstractSlider::valueChanged, &listener, told);
}

}  // namespace

OptionKeeper::OptionKeeper(QWidget& window, WindowSettings& settings, std::function<void()> changed)
    : window_(window), settings_(settings), changed_(std::move(changed)) {
    for (const char* const name : kKeptFields) fill_in(name);
    fill_in_tables();
    for (const char* const name : kKeptFields) {
        auto* const field = window_.findChild<QObject*>(name);
        if (field != nullptr)
            at_each_change(*field, *this, [this, field, name] { keep(name, value_of_field(*field)); });
    }
    for (const KeptColumns& kept : kKeptColumns) {
        if (auto* const table = window_.findChild<QTableView*>(kept.table)) watch(*table, kept.count);
    }
}

void OptionKeeper::fill_in_late() {
    is_filling_ = true;
    for (const char* const name : kKeptFields) {
        if (!drives_machine(name)) fill_in(name);
    }
    fill_in_tables();
    is_filling_ = false;
}

/// What was chosen, too: a field before it may have filled it in otherwise.
void OptionKeeper::fill_in(const char* name) {
    const auto chosen = fresh_.find(name);
    const QVariant value = chosen != fresh_.end() ? chosen->second : settings_.option(name);
    auto* const field = window_.findChild<QObject*>(name);
    if (field != nullptr && value.isValid()) put_into_field(*field, value);
}

void OptionKeeper::fill_in_tables() {
    for (const KeptColumns& kept : kKeptColumns) {
        if (auto* const table = window_.findChild<QTableView*>(kept.table))
            fill_in_columns(*table, kept.count);
    }
}

std::span<const char* const> OptionKeeper::names() {
    return kKeptFields;
}

void OptionKeeper::fill_in_columns(QTableView& table, int count) {
    for (int column = 0; column < count; ++column) {
        const QString name = name_of_column(table, column);
        const int width_px = was_changed(name) ? 0 : settings_.option(name).toInt();
        if (width_px >= kLeastColumn_px && width_px <= kMostColumn_px) table.setColumnWidth(column, width_px);
    }
}

void OptionKeeper::watch(QTableView& table, int count) {
    connect(table.horizontalHeader(), &QHeaderView::sectionResized, this,
            [this, count, &table](int column, int, int width_px) {
                if (column < count) keep(name_of_column(table, column), width_px);
            });
}

void OptionKeeper::keep(const QString& name, const QVariant& value) {
    if (is_filling_) return;
    fresh_[name] = value;
    changed_();
}

void OptionKeeper::write() {
    for (const auto& [name, value] : std::exchange(fresh_, {})) settings_.set_option(name, value);
}

}  // namespace psicarve::ui
