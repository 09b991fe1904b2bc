// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/field_value.hpp"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QWidget>

namespace psicarve::ui {
namespace {

QVariant key_of(const QComboBox& box, int index) {
    const QVariant data = box.itemData(index);
    return data.isValid() ? QVariant{data.toString()} : QVariant{index};
}

template <typename Number>
void put_number(Number& field, double value) {
    if (value >= field.minimum() && value <= field.maximum())
        field.setValue(static_cast<decltype(field.value())>(value));
}

}  // namespace

QVariant value_of_field(const QObject& field) {
    if (const auto* group = qobject_cast<const QButtonGroup*>(&field)) return group->checkedId();
    if (const auto* box = qobject_cast<const QComboBox*>(&field)) return key_of(*box, box->currentIndex());
    if (const auto* number = qobject_cast<const QSpinBox*>(&field)) return number->value();
    if (const auto* number = qobject_cast<const QDoubleSpinBox*>(&field)) return number->value();
    if (const auto* slider = qobject_cast<const QAbstractSlider*>(&field)) return slider->value();
    const auto* button = qobject_cast<const QAbstractButton*>(&field);
    if (button != nullptr && button->isCheckable()) return button->isChecked();
    return {};
}

void put_into_field(QObject& field, const QVariant& value) {
    if (auto* box = qobject_cast<QComboBox*>(&field)) {
        for (int i = 0; i < box->count(); ++i) {
            if (key_of(*box, i).toString() == value.toString()) return box->setCurrentIndex(i);
        }
        return;
    }
    auto* const button = qobject_cast<QAbstractButton*>(&field);
    if (button != nullptr && button->isCheckable() && value.canConvert<bool>())
        return button->setChecked(value.toBool());
    bool is_number = false;
    const double number_there = value.toDouble(&is_number);
    if (!is_number) return;
    if (auto* group = qobject_cast<QButtonGroup*>(&field)) {
        if (QAbstractButton* const chosen = group->button(value.toInt())) chosen->setChecked(true);
    }
    if (auto* number = qobject_cast<QSpinBox*>(&field)) put_number(*number, number_there);
    if (auto* number = qobject_cast<QDoubleSpinBox*>(&field)) put_number(*number, number_there);
    if (auto* slider = qobject_cast<QAbstractSlider*>(&field)) put_number(*slider, number_there);
}

QVariantMap values_of_fields(const QWidget& form) {
    QVariantMap values;
    for (const QWidget* const field : form.findChildren<QWidget*>()) {
        const QVariant value = value_of_field(*field);
        if (value.isValid() && !field->objectName().startsWith("qt_") && !field->objectName().isEmpty())
            values[field->objectName()] = value;
    }
    return values;
}

void put_into_fields(QWidget& form, const QVariantMap& values) {
    for (QWidget* const field : form.findChildren<QWidget*>()) {
        const auto kept = values.find(field->objectName());
        if (kept != values.end()) put_into_field(*field, *kept);
    }
}

}  // namespace psicarve::ui
