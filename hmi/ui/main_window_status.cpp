// SPDX-License-Identifier: GPL-3.0-or-later
#include <QHBoxLayout>
#include <QLabel>

#include "hmi/ui/core_profile_bar.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/main_window.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {

void MainWindow::make_status_bar() {
    constexpr int kHeight = 24;
    status_row_ = new QWidget;
    status_row_->setObjectName("statusbar");
    status_row_->setAttribute(Qt::WA_StyledBackground);
    status_row_->setFixedHeight(kHeight);
    auto* row = new QHBoxLayout{status_row_};
    row->setContentsMargins(kGap, 0, kGap, 0);
    row->setSpacing(2 * kGap);
    last_message_ = role_label("label");
    last_message_->setObjectName("last_message");
    last_message_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    profile_label_ = role_label("label");
    profile_label_->setObjectName("profile_label");
    row->addWidget(last_message_, 1);
    row->addWidget(role_label("label", "mm · °"));
    row->addWidget(profile_label_);
    row->addWidget(role_label(
        "label", tr("segment %1").arg(QString::fromStdString(context_.machine.options().segment_name))));
    language_label_ = role_label("label", tr("English"));  // each catalogue has its own name there
    language_label_->setObjectName("language");
    row->addWidget(language_label_);
}

void MainWindow::refresh_status_bar() {
    refresh_profile_label();
    if (!status_line_.look(context_.log, session::StatusLine::Clock::now())) return elide_message();
    show_last_message();
}

void MainWindow::show_last_message() {
    const session::Message& last = *status_line_.shown();
    const QString text = QStringLiteral("%1 %2").arg(local_time(last.time, "HH:mm:ss"), words(last.what));
    message_text_ = text;
    set_plain_tip(*last_message_, text);
    set_styled(last_message_, "trouble", last.severity == session::Severity::info ? "no" : "yes");
    elide_message();
}

/// As much as there is room for; all of it in the tooltip.
void MainWindow::elide_message() {
    const QString shown =
        last_message_->fontMetrics().elidedText(message_text_, Qt::ElideRight, last_message_->width());
    if (last_message_->text() != shown) last_message_->setText(shown);
}

void MainWindow::refresh_profile_label() {
    const session::MachineView& view = context_.shown();
    const QString name = view.is_profile_of_job ? tr("profile as the job's")
                         : view.profile ? tr("profile %1").arg(QString::fromStdString(view.profile->name))
                                        : tr("profile unknown");
    const QString unused = QString::fromStdString(view.unused_profile);
    const QString both = tr("%1, not %2 of --profile").arg(name, unused);
    // Where that would take more than a third of the row the bar above the pages says it, as long as it is
    // there.
    const QFontMetrics letters = profile_label_->fontMetrics();
    const bool has_room = 3 * letters.horizontalAdvance(both) <= width();
    const bool is_told_above = !core_profile_->isHidden();
    const QString text = unused.isEmpty() || (!has_room && is_told_above) ? name
                         : has_room                                       ? both
                                    : letters.elidedText(both, Qt::ElideMiddle, width() / 3);
    set_plain_tip(*profile_label_, text == both || unused.isEmpty() ? QString{} : both);
    if (profile_label_->text() == text) return;
    profile_label_->setText(text);
    set_styled(profile_label_, "role", unused.isEmpty() ? "label" : "problem");
}

}  // namespace psicarve::ui
