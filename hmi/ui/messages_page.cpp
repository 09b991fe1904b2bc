// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/messages_page.hpp"

#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <span>

#include "hmi/session/support_bundle.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/message_pane.hpp"
#include "hmi/ui/tick_box.hpp"
#include "hmi/ui/words.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/segment/layout.hpp"

namespace psicarve::ui {
namespace {

using session::Severity;
enum Column { kTime, kKind, kAxes, kWhat, kRemedy, kColumns };
constexpr int kMessagesPageTimeWidth = 100;
constexpr int kMessagesPageKindWidth = 100;
constexpr int kMessagesPageAxesWidth = 60;
constexpr int kSearchWidth = 150;
constexpr int kLeastPaneHeight = 72;
constexpr int kMostPaneHeight = 160;
constexpr int kLeastTableHeight = 72;
constexpr int kLeastSearchWidth = 90;

Glyph glyph_of(Severity severity) {
    if (severity == Severity::alarm) return Glyph::octagon;
    return severity == Severity::warning ? Glyph::triangle : Glyph::info;
}

/// In the order of the box. A refused command is a warning, and a command, too.
enum class Wanted : std::uint8_t { all, alarms, warnings, commands, information };

Wanted kind_of(const session::Message& message) {
    if (message.severity == Severity::alarm) return Wanted::alarms;
    if (message.severity == Severity::warning) return Wanted::warnings;
    return message.is_command ? Wanted::commands : Wanted::information;
}

bool is_known(const session::Message& message) {
    return message.time != decltype(message.time){};
}

/// Of another day with the day, in as much room.
QString short_time(const session::Message& message) {
    if (!is_known(message)) return QStringLiteral("\u2013");
    const QString day = local_time(message.time, "MM-dd");
    const bool is_today = QDateTime::currentDateTime().toString("MM-dd") == day;
    return local_time(message.time, is_today ? "HH:mm:ss.zzz" : "MM-dd HH:mm:ss");
}

}  // namespace

MessagesPage::MessagesPage(WindowContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      kinds_(new ChoiceBox),
      find_(new QLineEdit),
      table_(new QTableWidget{0, kColumns}),
      pane_(new MessagePane{context}) {
    setObjectName("messages_page");
    kinds_->addItems({tr("All"), tr("Alarms"), tr("Warnings"), tr("Commands"), tr("Information")});
    kinds_->setObjectName("messages_kind");
    kinds_->setAccessibleName(tr("Which messages are shown"));
    connect(kinds_, &QComboBox::currentIndexChanged, this, [this] { filter(); });
    find_->setObjectName("messages_find");
    find_->setPlaceholderText(tr("Search"));
    find_->setAccessibleName(tr("Search the messages"));
    find_->setClearButtonEnabled(true);
    find_->setMinimumWidth(kLeastSearchWidth);
    find_->setMaximumWidth(kSearchWidth);
    connect(find_, &QLineEdit::textChanged, this, [this] { filter(); });
    table_->setObjectName("messages");
    table_->setHorizontalHeaderLabels(
        {tr("Time"), tr("Kind"), tr("Axis"), tr("What happened"), tr("What to do")});
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(24);
    table_->setColumnWidth(kTime, kMessagesPageTimeWidth);
    table_->setColumnWidth(kKind, kMessagesPageKindWidth);
    table_->setColumnWidth(kAxes, kMessagesPageAxesWidth);
    table_->horizontalHeader()->setSectionResizeMode(kWhat, QHeaderView::Stretch);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setShowGrid(false);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->setMinimumHeight(kLeastTableHeight);
    pane_->setFixedHeight(kMostPaneHeight);
    connect(table_, &QTableWidget::itemSelectionChanged, this, [this] { show_selected(); });
    auto* head = new FlowLayout;
    head->setSpacing(kGap);
    head->addWidget(role_label("label", tr("Show")));
    head->addWidget(kinds_);
    head->addWidget(find_);
    head->addWidget(make_sound());
    head->add_end();
    auto* save = new QPushButton{tr("Save log…")};
    save->setObjectName("save_log");
    save->setFocusPolicy(Qt::TabFocus);
    auto* bundle = new QPushButton{tr("Support bundle…")};
    bundle->setObjectName("save_bundle");
    bundle->setFocusPolicy(Qt::TabFocus);
    bundle->setToolTip(tr("Profile, log, snapshot of job and status, versions: for whoever helps"));
    connect(save, &QPushButton::clicked, this, [this] { choose_log(); });
    connect(bundle, &QPushButton::clicked, this, [this] { choose_bundle(); });
    head->addWidget(save);
    head->addWidget(bundle);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->addLayout(head);
    all->addWidget(table_, 1);
    all->addWidget(pane_);
}

QWidget* MessagesPage::make_sound() {
    auto* sound = new TickBox{tr("Sound at an alarm")};
    sound->setObjectName("alarm_sound");
    sound->setFocusPolicy(Qt::TabFocus);
    sound->setChecked(true);
    sound->setToolTip(
        tr("The desktop's bell, once at each new alarm; not for recordings, nor for what was "
           "there before the window"));
    connect(sound, &QCheckBox::toggled, this, [this](bool is_on) { context_.bell.set_on(is_on); });
    return sound;
}

QString MessagesPage::name_of(const session::Message& message) {
    if (message.severity == Severity::alarm) return tr("Alarm");
    if (message.severity == Severity::warning) return tr("Warning");
    return message.is_command ? tr("Command") : tr("Info");
}

/// Rows are the messages, newest first.
void MessagesPage::show_selected() {
    const QList<QTableWidgetItem*> selected = table_->selectedItems();
    const auto& messages = context_.log.messages();
    const auto fresh = static_cast<std::size_t>(context_.log.count() - shown_count_);  // without a row yet
    const int row = selected.isEmpty() ? -1 : selected.front()->row();
    const std::size_t from_newest = fresh + static_cast<std::size_t>(std::max(row, 0));
    const bool is_one = row >= 0 && from_newest < messages.size() && !table_->isRowHidden(row);
    const session::Message* const message = is_one ? &messages[messages.size() - 1 - from_newest] : nullptr;
    pane_->show_message(message, message != nullptr ? name_of(*message) : QString{});
}

void MessagesPage::show_selected_row() {
    const QList<QTableWidgetItem*> selected = table_->selectedItems();
    if (!selected.isEmpty()) table_->scrollToItem(selected.front());
}

void MessagesPage::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    table_->setRowCount(0);
    shown_count_ = 0;
    refresh();
}

void MessagesPage::choose_log() {
    const QString path =
        ask_where_to_save(this, tr("Save the log"), "psicarve.log", tr("Text (*.log *.txt)"));
    if (!path.isEmpty()) save_log(path);
}

void MessagesPage::choose_bundle() {
    const QString folder = ask_for_folder(this, tr("Folder for the support bundle"), QDir::homePath());
    if (!folder.isEmpty()) save_bundle(folder);
}

void MessagesPage::save_log(const QString& path) {
    const auto save = [this, file = path.toStdString(), text = session::log_text(context_.log.messages())] {
        const auto saved = write_file_atomically(file, std::as_bytes(std::span{text}));
        return told(saved, session::phrase("Log saved: %1", file));
    };
    queue_.post(context_.saves.noted(path.toStdString(), save));
}

void MessagesPage::save_bundle(const QString& folder) {
    session::SupportBundle bundle;
    bundle.messages = session::log_text(context_.log.messages());
    bundle.log_folder = context_.keeper.folder();
    const session::MachineView& machine = context_.machine.view();
    if (!machine.is_profile_of_job) bundle.profile = machine.profile;
    bundle.versions = std::string{"psicarve   " PSICARVE_VERSION "\nlayout     "} +
                      std::to_string(kLayoutVersion) + "\nQt         " + qVersion() + "\n" +
                      session::system_text();
    bundle.segment_name = context_.machine.options().segment_name;
    bundle.group = context_.machine.options().group;
    const std::string stamp = QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss").toStdString();
    const auto save = [this, bundle, stamp, place = folder.toStdString()] {
        const auto made = session::write_support_bundle(bundle, place, stamp);
        return told(made ? Result<void>{} : Result<void>{made.error()},
                    session::phrase("Support bundle: %1", made ? *made : std::string{}));
    };
    queue_.post(context_.saves.noted(folder.toStdString(), save));
}

session::BackgroundQueue::Finish MessagesPage::told(const Result<void>& done,
                                                    const session::Phrase& success) {
    return [this, success, why = done ? std::string{} : done.error().message] {
        if (why.empty()) {
            context_.log.add(Severity::info, success);
        } else {
            context_.log.add(Severity::warning, session::phrase("Not saved: %1", why));
        }
    };
}

void MessagesPage::refresh() {
    queue_.deliver();
    pane_->refresh();
    const auto& messages = context_.log.messages();
    if (tokens_ == nullptr || shown_count_ == context_.log.count()) return;
    const auto fresh = static_cast<std::size_t>(context_.log.count() - shown_count_);
    shown_count_ = context_.log.count();
    for (std::size_t i = messages.size() - std::min(fresh, messages.size()); i < messages.size(); ++i)
        add(messages[i]);
    table_->setRowCount(std::min(table_->rowCount(), static_cast<int>(session::MessageLog::kMost)));
    filter();
}

void MessagesPage::add(const session::Message& message) {
    const bool is_alarm = message.severity == Severity::alarm;
    const QColor colour = is_alarm                                ? tokens_->alarm
                          : message.severity == Severity::warning ? tokens_->warn
                                                                  : tokens_->text2;
    table_->insertRow(0);
    const QString texts[kColumns] = {short_time(message), name_of(message),
                                     message.axes.empty() ? tr("–") : QString::fromStdString(message.axes),
                                     words(message.what), words(message.remedy)};
    for (int column = 0; column < kColumns; ++column) {
        auto* item = new QTableWidgetItem{texts[column]};
        item->setToolTip(column == kTime && is_known(message)
                             ? local_time(message.time, "yyyy-MM-dd HH:mm:ss.zzz")
                             : plain_tip(texts[column]));
        if (is_alarm) item->setBackground(tokens_->alarm_ground);
        if (column == kKind) {
            item->setForeground(colour);
            item->setIcon(glyph_icon(glyph_of(message.severity), colour, colour));
            item->setData(Qt::UserRole, static_cast<int>(kind_of(message)));
            item->setData(Qt::UserRole + 1, message.is_command);
        }
        table_->setItem(0, column, item);
    }
    table_->resizeRowToContents(0);
}

void MessagesPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    table_->setColumnWidth(kRemedy, table_->width() / 4);
    table_->resizeRowsToContents();  // words are wrapped
    pane_->setFixedHeight(std::clamp(height() / 3, kLeastPaneHeight, kMostPaneHeight));
    show_selected_row();
}

void MessagesPage::filter() {
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QTableWidgetItem& kind = *table_->item(row, kKind);
        const auto wanted = static_cast<Wanted>(kinds_->currentIndex());
        const bool is_wanted = wanted == Wanted::all ||
                               kind.data(Qt::UserRole).toInt() == kinds_->currentIndex() ||
                               (wanted == Wanted::commands && kind.data(Qt::UserRole + 1).toBool());
        const auto holds = [&](Column column) {
            return table_->item(row, column)->text().contains(find_->text(), Qt::CaseInsensitive);
        };
        const bool is_found = holds(kAxes) || holds(kWhat) || holds(kRemedy);
        table_->setRowHidden(row, !is_wanted || !is_found);
    }
    show_selected();
}

}  // namespace psicarve::ui
