// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/model_report_dialog.hpp"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kValueWidth = 440;

}  // namespace

ModelReportDialog::ModelReportDialog(QWidget* parent)
    : QDialog(parent), title_(role_label("title")), grid_(new QGridLayout) {
    setObjectName("model_report");
    setWindowTitle(tr("Report on the model"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* all = new QVBoxLayout{this};
    all->addWidget(title_);
    grid_->setHorizontalSpacing(3 * kGap);
    grid_->setColumnStretch(1, 1);
    grid_->setColumnMinimumWidth(1, kValueWidth);
    all->addLayout(grid_);
    all->addStretch();
    auto* buttons = new QDialogButtonBox;
    QPushButton* close_button = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    close_button->setObjectName("model_report_close");
    connect(close_button, &QPushButton::clicked, this, [this] { close(); });
    all->addWidget(buttons);
}

void ModelReportDialog::show_rows(const QString& title, const std::vector<session::ReportRow>& rows) {
    title_->setText(title);
    while (lines_.size() < rows.size()) {
        const Line line{role_label("label"), plain_label()};
        line.value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        line.value->setWordWrap(true);
        const auto at = static_cast<int>(lines_.size());
        grid_->addWidget(line.name, at, 0, Qt::AlignTop);
        grid_->addWidget(line.value, at, 1);
        lines_.push_back(line);
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const bool is_there = i < rows.size();
        lines_[i].name->setText(is_there ? words(rows[i].name) : QString{});
        lines_[i].value->setText(is_there ? words(rows[i].value) : QString{});
        lines_[i].name->setVisible(is_there);
        lines_[i].value->setVisible(is_there);
    }
    // Longer lines take more of them.
    layout()->activate();
    const int wanted = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width()) : 0;
    if (height() < wanted) resize(width(), wanted);
}

}  // namespace psicarve::ui
