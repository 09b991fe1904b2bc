// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDialog>

#include <array>

#include "hmi/session/move_request.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/window_context.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace psicarve::ui {

class OrderCard;

/// Sends axes to a place: straight, step by step, or round a centre. Stays open beside the window.
class MoveDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MoveDialog)
public:
    explicit MoveDialog(WindowContext& context, QWidget* parent = nullptr);

    /// Opens it with the axes' present positions.
    void open_here();
    void refresh();
    void set_theme(const Tokens& tokens);

private:
    struct Row {
        QCheckBox* is_wanted;
        QDoubleSpinBox* target;
        QDoubleSpinBox* centre;
    };
    Row make_row(Axis axis);
    void follow_fields();
    session::MoveRequest request() const;
    bool is_arc() const;
    void take_positions();

    WindowContext& context_;
    std::array<Row, kAxisCount> rows_{};
    QComboBox* shape_;
    QLabel* centre_head_;
    ActionButton* go_;
    QLabel* reason_;
    OrderCard* refused_;
};

}  // namespace psicarve::ui
