// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/messages_page.hpp"

#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using session::Severity;
enum Column { kTime, kKind, kWhat, kRemedy, kColumns };
constexpr int kTimeWidth = 100;
constexpr int kKindWidth = 96;
constexpr int kWhatWidth = 330;

Glyph glyph_of(Severity severity) {
    if (severity == Severity::alarm) return Glyph::octagon;
    return severity == Severity::warning ? Glyph::triangle : Glyph::info;
}

}  // namespace

MessagesPage::MessagesPage(Bench& bench, QWidget* parent)
    : QWidget(parent), bench_(bench), least_(new ChoiceBox), table_(new QTableWidget{0, kColumns}) {
    least_->addItems({tr("All"), tr("Warnings and alarms"), tr("Alarms")});
    least_->setAccessibleName(tr("Which messages are shown"));
    connect(least_, &QComboBox::currentIndexChanged, this, [this] { filter(); });
    table_->setObjectName("messages");
    table_->setHorizontalHeaderLabels({tr("Time"), tr("Kind"), tr("What happened"), tr("What to do")});
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(24);
    table_->setColumnWidth(kTime, kTimeWidth);
    table_->setColumnWidth(kKind, kKindWidth);
    table_->setColumnWidth(kWhat, kWhatWidth);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setShowGrid(false);
    auto* head = new QHBoxLayout;
    head->addWidget(role_label("label", tr("Show")));
    head->addWidget(least_);
    head->addStretch();
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->addLayout(head);
    all->addWidget(table_, 1);
}

QString MessagesPage::name_of_severity(Severity severity) {
    if (severity == Severity::alarm) return tr("Alarm");
    return severity == Severity::warning ? tr("Warning") : tr("Info");
}

void MessagesPage::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    table_->setRowCount(0);
    shown_count_ = 0;
    refresh();
}

void MessagesPage::refresh() {
    const auto& messages = bench_.log.messages();
    if (tokens_ == nullptr || shown_count_ == bench_.log.count()) return;
    const auto fresh = static_cast<std::size_t>(bench_.log.count() - shown_count_);
    shown_count_ = bench_.log.count();
    for (std::size_t i = messages.size() - std::min(fresh, messages.size()); i < messages.size(); ++i)
        add(messages[i]);
    table_->setRowCount(std::min(table_->rowCount(), static_cast<int>(session::MessageLog::kMost)));
    filter();
}

void MessagesPage::add(const session::Message& message) {
    const auto ms =
        std::chrono::duration_cast<std::chrono::milliseconds>(message.time.time_since_epoch()).count();
    const QString time = QDateTime::fromMSecsSinceEpoch(ms).toString("HH:mm:ss.zzz");
    const bool is_alarm = message.severity == Severity::alarm;
    const QColor colour = is_alarm                                ? tokens_->alarm
                          : message.severity == Severity::warning ? tokens_->warn
                                                                  : tokens_->text2;
    table_->insertRow(0);
    const QString texts[kColumns] = {time, name_of_severity(message.severity), words(message.what),
                                     words(message.remedy)};
    for (int column = 0; column < kColumns; ++column) {
        auto* item = new QTableWidgetItem{texts[column]};
        item->setToolTip(texts[column]);
        if (is_alarm) item->setBackground(tokens_->alarm_ground);
        if (column == kKind) {
            item->setForeground(colour);
            item->setIcon(glyph_icon(glyph_of(message.severity), colour, colour));
            item->setData(Qt::UserRole, static_cast<int>(message.severity));
        }
        table_->setItem(0, column, item);
    }
}

void MessagesPage::filter() {
    for (int row = 0; row < table_->rowCount(); ++row) {
        const int severity = table_->item(row, kKind)->data(Qt::UserRole).toInt();
        table_->setRowHidden(row, severity < least_->currentIndex());
    }
}

}  // namespace psicarve::ui
