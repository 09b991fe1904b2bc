// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/computer_table.hpp"

#include <QHeaderView>

#include <algorithm>

#include "hmi/ui/frames.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using V = session::ComputerRow::Verdict;
enum ComputerColumn { kName, kSeen, kRemedy, kComputerColumns };
constexpr int kRowHeight = 22;
constexpr int kNameWidth = 180;
constexpr int kSeenWidth = 200;

bool is_same(const session::ComputerRow& a, const session::ComputerRow& b) {
    return a.name == b.name && a.verdict == b.verdict && a.seen == b.seen && a.remedy == b.remedy;
}

Glyph glyph_of(V verdict) {
    if (verdict == V::good) return Glyph::check;
    return verdict == V::warning ? Glyph::triangle : Glyph::octagon;
}

QColor colour_of(V verdict, const Tokens& tokens) {
    if (verdict == V::good) return tokens.run;
    return verdict == V::warning ? tokens.warn : tokens.alarm;
}

}  // namespace

ComputerTable::ComputerTable(QWidget* parent) : QTableWidget(0, kComputerColumns, parent) {
    setHorizontalHeaderLabels({tr("What keeps ticks in time"), tr("Found"), tr("What to do")});
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(kRowHeight);
    verticalHeader()->setDefaultSectionSize(kRowHeight);
    setColumnWidth(kName, kNameWidth);
    setColumnWidth(kSeen, kSeenWidth);
    horizontalHeader()->setStretchLastSection(true);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setShowGrid(false);
    setWordWrap(true);
    // The bar at the side takes its width from the last column once there are more rows than fit.
    connect(
        horizontalHeader(), &QHeaderView::sectionResized, this, [this] { fit_rows(); }, Qt::QueuedConnection);
}

void ComputerTable::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    fill();
}

void ComputerTable::show_rows(const std::vector<session::ComputerRow>& rows) {
    if (std::equal(rows.begin(), rows.end(), shown_.begin(), shown_.end(), is_same)) return;
    shown_ = rows;
    fill();
}

void ComputerTable::fill() {
    if (tokens_ == nullptr) return;
    setRowCount(static_cast<int>(shown_.size()));
    for (int line = 0; line < rowCount(); ++line) {
        const session::ComputerRow& row = shown_[static_cast<std::size_t>(line)];
        const QString texts[kComputerColumns] = {words(row.name), words(row.seen), words(row.remedy)};
        const QColor colour = colour_of(row.verdict, *tokens_);
        for (int column = 0; column < kComputerColumns; ++column) {
            auto* cell = new QTableWidgetItem{texts[column]};
            cell->setToolTip(texts[column]);
            if (column == kName) cell->setIcon(glyph_icon(glyph_of(row.verdict), colour, colour));
            setItem(line, column, cell);
        }
    }
    fit_rows();
}

void ComputerTable::fit_rows() {
    for (int line = 0; line < rowCount(); ++line) {
        const int needed = sizeHintForRow(line);
        setRowHeight(line, needed > kRowHeight ? needed + kSmallGap : kRowHeight);
    }
}

}  // namespace psicarve::ui
