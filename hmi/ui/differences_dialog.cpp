// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/differences_dialog.hpp"

#include <QDialogButtonBox>
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

/// The first column and both values.
QTableWidget* table_of(const std::vector<session::DifferenceRow>& rows, const QStringList& heads) {
    const int count = static_cast<int>(rows.size());
    auto* table = new QTableWidget{count, 3};
    table->setObjectName("differences_table");
    table->setHorizontalHeaderLabels(heads);
    table->setColumnWidth(0, kWhatWidth);
    table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    table->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setShowGrid(false);
    for (int line = 0; line < count; ++line) {
        const session::DifferenceRow& row = rows[static_cast<std::size_t>(line)];
        int column = 0;
        for (const session::Phrase* text : {&row.what, &row.a, &row.b}) {
            auto* cell = new QTableWidgetItem{words(*text)};
            cell->setToolTip(cell->text());
            table->setItem(line, column++, cell);
        }
    }
    table->setVisible(count > 0);
    return table;
}

}  // namespace

DifferencesDialog::DifferencesDialog(const std::shared_ptr<const session::Comparison>& comparison,
                                     QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("Comparison"));
    setAttribute(Qt::WA_DeleteOnClose);
    const std::size_t count = comparison->rows.size();
    const QString a = file_name(comparison->path_a);
    const QString b = file_name(comparison->path_b);
    QVBoxLayout& all = lay_out(count == 0 ? tr("%1 and %2: nothing differs").arg(a, b)
                                          : tr("%1 and %2: %3 differences").arg(a, b).arg(count),
                               comparison->rows, a, b);
    auto* shut = new QPushButton{tr("Close")};
    shut->setObjectName("differences_close");
    shut->setAutoDefault(false);
    connect(shut, &QPushButton::clicked, this, [this] { close(); });
    all.addWidget(shut, 0, Qt::AlignRight);
}

DifferencesDialog::DifferencesDialog(const Question& question,
                                     const std::vector<session::DifferenceRow>& rows, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(question.title);
    QVBoxLayout& all = lay_out(question.text, rows, question.before, question.after);
    auto* buttons = new QDialogButtonBox;
    auto* accept = buttons->addButton(question.accept, QDialogButtonBox::AcceptRole);
    accept->setObjectName("differences_accept");
    auto* cancel = buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    cancel->setObjectName("differences_cancel");
    accept->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    all.addWidget(buttons);
}

QVBoxLayout& DifferencesDialog::lay_out(const QString& said, const std::vector<session::DifferenceRow>& rows,
                                        const QString& a, const QString& b) {
    setObjectName("differences");
    auto* all = new QVBoxLayout{this};
    auto* title = role_label("title", said);
    title->setObjectName("differences_said");
    title->setWordWrap(true);
    all->addWidget(title);
    all->addWidget(table_of(rows, {tr("What"), a, b}), 1);
    if (!rows.empty()) resize(kSize);
    return *all;
}

}  // namespace psicarve::ui
