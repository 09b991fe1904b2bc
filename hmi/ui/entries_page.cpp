// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/entries_page.hpp"

#include <QAbstractTableModel>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "hmi/session/display_text.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using session::Severity;
enum Column { kTime, kKind, kWhat, kColumns };
constexpr int kTimeWidth = 110;
constexpr int kKindWidth = 96;
constexpr int kEntriesPageRowHeight = 24;

}  // namespace

/// The entries where they lie: twenty thousand of them cost nothing until they are looked at.
class EntriesPage::Model : public QAbstractTableModel {
public:
    explicit Model(const WindowContext& context) : context_(context) {}

    void begin_anew() {
        beginResetModel();
        rows_ = static_cast<int>(entries().size());
        endResetModel();
    }
    void set_theme(const Tokens& tokens) { tokens_ = &tokens; }
    int rowCount(const QModelIndex& parent) const override { return parent.isValid() ? 0 : rows_; }
    int columnCount(const QModelIndex& parent) const override { return parent.isValid() ? 0 : kColumns; }

    QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
        if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
        const QString names[kColumns] = {EntriesPage::tr("Time"), EntriesPage::tr("Kind"),
                                         EntriesPage::tr("What happened")};
        return names[section];
    }

    QVariant data(const QModelIndex& index, int role) const override {
        const auto row = static_cast<std::size_t>(index.row());
        if (row >= entries().size()) return {};
        const replay::Entry& entry = entries()[row];
        if (role == Qt::ForegroundRole && index.column() == kKind && tokens_ != nullptr)
            return entry.severity == Severity::alarm     ? tokens_->alarm
                   : entry.severity == Severity::warning ? tokens_->warn
                                                         : tokens_->text2;
        if (role != Qt::DisplayRole) return {};
        if (index.column() == kTime) return QString::fromStdString(session::time_text_ms(entry.time_ns));
        if (index.column() == kWhat) return words(entry.what);
        return entry.severity == Severity::alarm     ? EntriesPage::tr("alarm")
               : entry.severity == Severity::warning ? EntriesPage::tr("warning")
                                                     : EntriesPage::tr("info");
    }

private:
    const std::vector<replay::Entry>& entries() const { return context_.replay.facts().entries; }

    const WindowContext& context_;
    const Tokens* tokens_ = nullptr;
    int rows_ = 0;
};

EntriesPage::EntriesPage(WindowContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      model_(std::make_unique<Model>(context)),
      table_(new QTableView),
      note_(role_label("small")) {
    setObjectName("entries_page");
    table_->setObjectName("entries");
    table_->setModel(model_.get());
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(kEntriesPageRowHeight);
    table_->setColumnWidth(kTime, kTimeWidth);
    table_->setColumnWidth(kKind, kKindWidth);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setShowGrid(false);
    table_->setAccessibleName(tr("Entries of the recording"));
    connect(table_, &QTableView::clicked, this, [this](const QModelIndex& index) {
        const auto row = static_cast<std::size_t>(index.row());
        const auto& entries = context_.replay.facts().entries;
        if (row < entries.size()) context_.replay.clock().seek(entries[row].time_ns);
    });
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(kGap, kGap, kGap, kGap);
    all->addWidget(table_, 1);
    all->addWidget(note_);
}

EntriesPage::~EntriesPage() {
    table_->setModel(nullptr);
}

void EntriesPage::set_theme(const Tokens& tokens) {
    model_->set_theme(tokens);
}

void EntriesPage::refresh() {
    if (shown_edition_ != context_.replay.edition()) {
        shown_edition_ = context_.replay.edition();
        shown_row_ = -1;
        model_->begin_anew();
    }
    if (!isVisible() || !context_.replay.is_open()) return;
    note_->setText(context_.replay.facts().knows_states
                       ? tr("From the flight recorder. A click goes to an entry.")
                       : tr("Read off the pins: a trace has no flight recorder. A click goes to an entry."));
    const int row = replay::entry_at(context_.replay.facts().entries, context_.replay.clock().now_ns());
    if (row == shown_row_) return;
    shown_row_ = row;
    if (row < 0) return table_->clearSelection();
    // Of entries of one instant the one that was clicked stays selected.
    const QModelIndex chosen = table_->selectionModel()->currentIndex();
    const auto& entries = context_.replay.facts().entries;
    const bool is_same = chosen.isValid() && chosen.row() < static_cast<int>(entries.size()) &&
                         entries[static_cast<std::size_t>(chosen.row())].time_ns ==
                             entries[static_cast<std::size_t>(row)].time_ns;
    if (!is_same) table_->selectRow(row);
}

}  // namespace psicarve::ui
