// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVariant>
#include <QVariantMap>

class QObject;
class QWidget;

namespace psicarve::ui {

/// What was chosen in a field: a number, an entry, a tick, the button of a group. Invalid: it is no field.
QVariant value_of_field(const QObject& field);
/// Fills it in. What cannot be its value leaves it as it is: it may have been written by another version, or
/// by hand.
void put_into_field(QObject& field, const QVariant& value);

/// Those of a form, by the names of its fields, and back in the form's order.
QVariantMap values_of_fields(const QWidget& form);
void put_into_fields(QWidget& form, const QVariantMap& values);

}  // namespace psicarve::ui
