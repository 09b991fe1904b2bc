// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/differences_dialog.hpp"

#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "hmi/ui/frames.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr QSize kSize{760, 420};
constexpr int kWhatWidth = 300;

QString file_name(const std::string& path) {
    return QFileInfo{QString::fromStdString(path)}.fileName();
}

}  // namespace

DifferencesDialog::DifferencesDialog(const std::shared_ptr<const session::Comparison>& comparison,
                                     QWidget* parent)
    : QDialog(parent) {
    setObjectName("differences");
    setWindowTitle(tr("Comparison"));
    setAttribute(Qt::WA_DeleteOnClose);
    const int count = static_cast<int>(comparison->rows.size());
    const QString a = file_name(comparison->path_a);
    const QString b = file_name(comparison->path_b);
    auto* all = new QVBoxLayout{this};
    auto* said = role_label("title", count == 0 ? tr("%1 and %2: nothing differs").arg(a, b)
                                                : tr("%1 and %2: %3 differences").arg(a, b).arg(count));
    said->setObjectName("differences_said");
    said->setWordWrap(true);
    all->addWidget(said);
    auto* table = new QTableWidget{count, 3};
    table->setObjectName("differences_table");
    table->setHorizontalHeaderLabels({tr("What"), a, b});
    table->setColumnWidth(0, kWhatWidth);
    table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    table->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setShowGrid(false);
    for (int line = 0; line < count; ++line) {
        const session::DifferenceRow& row = comparison->rows[static_cast<std::size_t>(line)];
        int column = 0;
        for (const session::Phrase* text : {&row.what, &row.a, &row.b}) {
            auto* cell = new QTableWidgetItem{words(*text)};
            cell->setToolTip(cell->text());
            table->setItem(line, column++, cell);
        }
    }
    table->setVisible(count > 0);
    all->addWidget(table, 1);
    auto* shut = new QPushButton{tr("Close")};
    shut->setObjectName("differences_close");
    shut->setAutoDefault(false);
    connect(shut, &QPushButton::clicked, this, [this] { close(); });
    all->addWidget(shut, 0, Qt::AlignRight);
    if (count > 0) resize(kSize);
}

}  // namespace psicarve::ui
