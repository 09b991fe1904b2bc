// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/messages_page.hpp"

#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <span>

#include "hmi/session/support_bundle.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/message_pane.hpp"
#include "hmi/ui/tick_box.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/segment/layout.hpp"

namespace psicarve::ui {
namespace {

using session::Severity;
using Kind = MessageFilter::Kind;
constexpr int kMessagesPageTimeWidth = 100;
constexpr int kMessagesPageKindWidth = 100;
constexpr int kMessagesPageAxesWidth = 60;
constexpr int kSearchWidth = 150;
constexpr int kLeastPaneHeight = 72;
constexpr int kMostPaneHeight = 160;
constexpr int kLeastTableHeight = 72;
constexpr int kLeastSearchWidth = 90;
constexpr int kRowHeight = 24;

}  // namespace

MessagesPage::MessagesPage(WindowContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      kinds_(new ChoiceBox),
      spans_(new ChoiceBox),
      find_(new QLineEdit),
      model_(context),
      table_(new QTableView),
      pane_(new MessagePane{context}) {
    setObjectName("messages_page");
    make_head();
    make_table();
    auto* head = new FlowLayout;
    head->setSpacing(kGap);
    head->addWidget(role_label("label", tr("Show")));
    head->addWidget(kinds_);
    head->addWidget(spans_);
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

void MessagesPage::make_head() {
    kinds_->addItems({tr("All"), tr("Alarms"), tr("Warnings"), tr("Commands"), tr("Information")});
    kinds_->setObjectName("messages_kind");
    kinds_->setAccessibleName(tr("Which messages are shown"));
    connect(kinds_, &QComboBox::currentIndexChanged, this, [this] { filter(); });
    spans_->addItems({tr("All runs"), tr("Since the start")});
    spans_->setObjectName("messages_span");
    spans_->setAccessibleName(tr("Of which time messages are shown"));
    spans_->setToolTip(
        tr("All runs: also what the cores have written down before this window was opened, in grey"));
    connect(spans_, &QComboBox::currentIndexChanged, this, [this] { filter(); });
    find_->setObjectName("messages_find");
    find_->setPlaceholderText(tr("Search"));
    find_->setAccessibleName(tr("Search the messages"));
    find_->setClearButtonEnabled(true);
    find_->setMinimumWidth(kLeastSearchWidth);
    find_->setMaximumWidth(kSearchWidth);
    connect(find_, &QLineEdit::textChanged, this, [this] { filter(); });
}

void MessagesPage::make_table() {
    table_->setObjectName("messages");
    table_->setModel(&model_);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
    table_->setColumnWidth(MessageModel::kTime, kMessagesPageTimeWidth);
    table_->setColumnWidth(MessageModel::kKind, kMessagesPageKindWidth);
    table_->setColumnWidth(MessageModel::kAxes, kMessagesPageAxesWidth);
    table_->horizontalHeader()->setSectionResizeMode(MessageModel::kWhat, QHeaderView::Stretch);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setShowGrid(false);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->setMinimumHeight(kLeastTableHeight);
    pane_->setFixedHeight(kMostPaneHeight);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { note_choice(); });
    connect(table_->verticalScrollBar(), &QScrollBar::valueChanged, this, [this] { fit_rows(); });
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

void MessagesPage::note_choice() {
    const QModelIndexList selected = table_->selectionModel()->selectedRows();
    chosen_.reset();
    if (!selected.isEmpty()) chosen_ = model_.row(selected.front().row());
    show_chosen();
}

void MessagesPage::show_chosen() {
    const bool is_shown = chosen_ && model_.index_of(*chosen_) >= 0;
    const session::Message* const message = is_shown ? model_.message_of(*chosen_) : nullptr;
    pane_->show_message(message, message != nullptr ? MessageModel::name_of(*message) : QString{});
}

/// All rows are others: the same message is chosen again.
void MessagesPage::choose_again() {
    const int row = chosen_ ? model_.index_of(*chosen_) : -1;
    if (row >= 0) table_->selectRow(row);
    show_chosen();
    fit_rows();
}

/// Words are wrapped: of the rows that are seen, as there may be thousands.
void MessagesPage::fit_rows() {
    if (!isVisible()) return;
    const int height_px = table_->viewport()->height();
    for (int row = std::max(table_->rowAt(0), 0); row < model_.rowCount(); ++row) {
        table_->resizeRowToContents(row);
        if (table_->rowViewportPosition(row) > height_px) return;
    }
}

void MessagesPage::set_theme(const Tokens& tokens) {
    model_.set_theme(tokens);
    choose_again();
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
    if (model_.refresh()) choose_again();
}

bool MessagesPage::is_quiet() const {
    return queue_.is_idle() && !pane_->is_saving();
}

void MessagesPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    table_->setColumnWidth(MessageModel::kRemedy, table_->width() / 4);
    pane_->setFixedHeight(std::clamp(height() / 3, kLeastPaneHeight, kMostPaneHeight));
    fit_rows();
    if (chosen_ && model_.index_of(*chosen_) >= 0)
        table_->scrollTo(model_.index(model_.index_of(*chosen_), MessageModel::kTime));
}

void MessagesPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    fit_rows();
}

void MessagesPage::filter() {
    model_.set_filter(
        {static_cast<Kind>(kinds_->currentIndex()), spans_->currentIndex() == 0, find_->text()});
    choose_again();
}

}  // namespace psicarve::ui
