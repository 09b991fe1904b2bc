// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/move_dialog.hpp"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/axis_actions.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/order_card.hpp"
#include "hmi/ui/tick_box.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kDecimals = 3;
constexpr double kMost = 10'000.0;
constexpr int kMoveDialogFieldWidth = 110;

QDoubleSpinBox* field(Axis axis, const QString& id) {
    auto* box = new QDoubleSpinBox;
    ignore_wheel(box);
    box->setObjectName(id + QString::fromStdString(std::string{name_of(axis)}));
    box->setDecimals(kDecimals);
    box->setRange(-kMost, kMost);
    box->setSuffix(axis == Axis::psi ? QStringLiteral(" °") : QStringLiteral(" mm"));
    box->setMinimumWidth(kMoveDialogFieldWidth);
    return box;
}

}  // namespace

MoveDialog::MoveDialog(WindowContext& context, QWidget* parent)
    : QDialog(parent),
      context_(context),
      shape_(new ChoiceBox),
      reason_(role_label("label")),
      refused_(new OrderCard{context, session::OrderPlace::move, "move", OrderCard::Shape::wide}) {
    setObjectName("move_dialog");
    setWindowTitle(tr("Go to"));
    shape_->setObjectName("move_shape");
    shape_->setAccessibleName(tr("How to go there"));
    shape_->addItem(tr("straight line"), static_cast<int>(MoveShape::straight));
    shape_->addItem(tr("step by step"), static_cast<int>(MoveShape::stepped));
    shape_->addItem(tr("arc, from the head's + to Y's +"), static_cast<int>(MoveShape::arc));
    shape_->addItem(tr("arc, the other way"), static_cast<int>(MoveShape::clockwise));
    auto* grid = new QGridLayout;
    centre_head_ = role_label("label", tr("Centre of the arc"));
    grid->addWidget(role_label("label", tr("Position")), 0, 1);
    grid->addWidget(centre_head_, 0, 2);
    for (const Axis axis : kAllAxes) {
        const int line = static_cast<int>(index_of(axis)) + 1;
        rows_[index_of(axis)] = make_row(axis);
        const Row& row = rows_[index_of(axis)];
        grid->addWidget(row.is_wanted, line, 0);
        grid->addWidget(row.target, line, 1);
        if (row.centre != nullptr) grid->addWidget(row.centre, line, 2);
    }
    go_ = new ActionButton{
        [this](const WindowContext& now) { return session::move_lock(now.machine.view(), request()); },
        tr("Go"),
        [this] { context_.machine.order(session::move_command(request()), session::phrase("Go to")); }};
    go_->setObjectName("move_go");
    go_->setProperty("strong", true);
    go_->set_hint(tr("All chosen axes together; Ψ the short way. Stop and F1 end it."));
    auto* here = new QPushButton{tr("Present positions")};
    here->setObjectName("move_here");
    auto* shut = new QPushButton{tr("Close")};
    shut->setObjectName("move_close");
    for (QPushButton* button : {here, shut}) {
        button->setAutoDefault(false);
        button->setFocusPolicy(Qt::TabFocus);
    }
    connect(here, &QPushButton::clicked, this, [this] { take_positions(); });
    connect(shut, &QPushButton::clicked, this, [this] { close(); });
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(here);
    buttons->addStretch();
    buttons->addWidget(go_);
    buttons->addWidget(shut);
    reason_->setWordWrap(true);
    reason_->setMinimumHeight(2 * reason_->fontMetrics().lineSpacing());
    reason_->setObjectName("move_reason");
    auto* all = new QVBoxLayout{this};
    all->addLayout(grid);
    all->addWidget(shape_);
    all->addWidget(reason_);
    all->addLayout(buttons);
    all->addWidget(refused_);
    all->addStretch();  // what comes below the buttons moves none of them
    follow_fields();
}

/// What was refused was another move.
void MoveDialog::follow_fields() {
    const auto forget = [this] { context_.machine.forget_refused_order(session::OrderPlace::move); };
    connect(shape_, &QComboBox::currentIndexChanged, this, forget);
    for (const Row& row : rows_) {
        connect(row.is_wanted, &QCheckBox::toggled, this, forget);
        connect(row.target, &QDoubleSpinBox::valueChanged, this, forget);
        if (row.centre != nullptr) connect(row.centre, &QDoubleSpinBox::valueChanged, this, forget);
    }
}

void MoveDialog::set_theme(const Tokens& tokens) {
    refused_->set_theme(tokens);
}

MoveDialog::Row MoveDialog::make_row(Axis axis) {
    Row row{new TickBox{QString::fromUtf8(session::axis_letter(axis))}, field(axis, "move_to_"), nullptr};
    row.is_wanted->setObjectName("move_" + QString::fromStdString(std::string{name_of(axis)}));
    row.target->setAccessibleName(tr("Position of %1").arg(session::axis_letter(axis)));
    connect(row.target, &QDoubleSpinBox::valueChanged, row.is_wanted,
            [wanted = row.is_wanted] { wanted->setChecked(true); });
    if (axis == Axis::psi) return row;
    row.centre = field(axis, "move_centre_");
    row.centre->setAccessibleName(tr("Centre of the arc, %1").arg(session::axis_letter(axis)));
    return row;
}

bool MoveDialog::is_arc() const {
    const auto shape = static_cast<MoveShape>(shape_->currentData().toInt());
    return shape == MoveShape::arc || shape == MoveShape::clockwise;
}

session::MoveRequest MoveDialog::request() const {
    session::MoveRequest request;
    request.shape = static_cast<MoveShape>(shape_->currentData().toInt());
    for (const Axis axis : kAllAxes) {
        const Row& row = rows_[index_of(axis)];
        if (row.is_wanted->isChecked()) request.target[index_of(axis)] = row.target->value();
        if (row.centre != nullptr) request.centre[index_of(axis)] = row.centre->value();
    }
    return request;
}

void MoveDialog::take_positions() {
    for (const Axis axis : kAllAxes) {
        const auto position = session::position_of(context_.machine.view(), axis);
        const Row& row = rows_[index_of(axis)];
        if (position) row.target->setValue(*position);
        row.is_wanted->setChecked(false);
    }
}

void MoveDialog::open_here() {
    if (!isVisible()) {
        take_positions();
        context_.machine.forget_refused_order(session::OrderPlace::move);
    }
    show();
    raise();
    activateWindow();
}

void MoveDialog::refresh() {
    if (!isVisible()) return;
    reason_->setText(go_->refresh(context_));
    refused_->refresh();
    centre_head_->setEnabled(is_arc());
    for (const Row& row : rows_) {
        if (row.centre != nullptr) row.centre->setEnabled(is_arc() && row.is_wanted->isChecked());
    }
}

}  // namespace psicarve::ui
