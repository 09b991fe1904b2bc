// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <array>
#include <functional>

#include "hmi/flat/load_model.hpp"
#include "hmi/model/mesh.hpp"

class QComboBox;
class QDoubleSpinBox;

namespace psicarve::ui {

class TickBox;

/// How a model is turned and mirrored before it is placed, and whether it is made as large as fits: what
/// `psicarve slice` takes with --rotate, --mirror and --fit.
class TurnForm : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::TurnForm)
public:
    /// `turned` is called when the model is to be turned otherwise; `resized` when it shall fit, or no
    /// longer.
    TurnForm(std::function<void()> turned, std::function<void()> resized, QWidget* parent = nullptr);

    /// As for another file; the change is not told.
    void begin_anew();
    /// Shows what such a model takes; a table takes nothing of it.
    void show_what_applies(flat::ModelKind kind, bool is_engraved, bool is_table);
    model::MeshTurn turn() const;
    bool fits() const;

private:
    void show_details();

    std::function<void()> turned_;
    std::function<void()> resized_;
    bool is_told_ = true;
    bool may_turn_ = true;
    bool may_fit_ = true;
    TickBox* turn_;
    TickBox* fit_;
    QWidget* details_;
    std::array<QDoubleSpinBox*, 3> angles_{};  ///< about the file's x, y, z
    QComboBox* mirror_;
};

}  // namespace psicarve::ui
