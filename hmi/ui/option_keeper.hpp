// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QVariant>

#include <functional>
#include <map>
#include <span>

class QTableView;
class QWidget;

namespace psicarve::ui {

class WindowSettings;

/// Brings back what the operator has chosen in the window's fields: numbers of slicing, steps and speeds of a
/// jog, colours, filters, the sound at an alarm, widths of columns. Never anything that moves, arms or drives
/// the machine faster: no feed override, no dry run, no armed keys; and nothing that belongs to one model or
/// recording.
class OptionKeeper : public QObject {
public:
    /// Fills the fields of the window in; `changed` is called at each later change of one. What cannot be a
    /// field's value leaves it as it is.
    OptionKeeper(QWidget& window, WindowSettings& settings, std::function<void()> changed);

    /// By settings that came later. What was chosen meanwhile stays, and so does what drives the machine
    /// (jog, wiring test): the operator may be about to press a key. Kept values that are not taken stay
    /// kept.
    void fill_in_late();
    /// Those that were changed since.
    void write();

    /// Of the fields, by the name of their object: in the order in which they are filled in.
    static std::span<const char* const> names();

private:
    void keep(const QString& name, const QVariant& value);
    void fill_in(const char* name);
    void fill_in_tables();
    bool was_changed(const QString& name) const { return fresh_.count(name) != 0; }
    void fill_in_columns(QTableView& table, int count);
    void watch(QTableView& table, int count);

    QWidget& window_;
    WindowSettings& settings_;
    std::function<void()> changed_;
    std::map<QString, QVariant> fresh_;
    bool is_filling_ = false;  ///< what changes is not the operator's choice
};

}  // namespace psicarve::ui
