// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <functional>

#include "hmi/flat/load_model.hpp"
#include "shared/profile/profile.hpp"

class QDoubleSpinBox;

namespace psicarve::ui {

class TickBox;

/// Whether a drawing's lines are engraved, and how: what `psicarve slice` takes with --engrave.
class EngraveForm : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::EngraveForm)
public:
    explicit EngraveForm(std::function<void()> changed, QWidget* parent = nullptr);

    bool is_chosen() const;
    /// As for another drawing; the change is not told.
    void begin_anew(bool is_engraved);
    /// Cut with the machine's tool; without a diameter of its own, into its blank.
    void fill(flat::FlatOptions& options, const Profile& machine) const;

private:
    QDoubleSpinBox* field(const char* name, double least, double most, const QString& name_of_it);
    TickBox* tick(const char* name, const QString& text, const QString& hint);
    void show_what_applies();
    void tell() const;

    std::function<void()> changed_;
    bool is_told_ = true;
    TickBox* engrave_;
    QWidget* details_;
    QDoubleSpinBox* depth_;
    QDoubleSpinBox* start_;
    QDoubleSpinBox* diameter_;
    TickBox* full_turn_;
    TickBox* widths_;
};

}  // namespace psicarve::ui
