// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/mdi_line.hpp"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include <algorithm>

#include "hmi/gcode/block.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/program_ground.hpp"
#include "hmi/ui/program_text_view.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

/// Far more than a block has: what is too long is refused with words, not cut.
constexpr int kMostLetters = 1 << 20;

bool is_return(const QKeyEvent& key) {
    return key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
}

/// A letter that ends a line, wherever the text was copied from.
bool ends_line(QChar letter) {
    return letter == '\n' || letter == '\r' || letter == QChar::LineSeparator ||
           letter == QChar::ParagraphSeparator;
}

}  // namespace

MdiLine::MdiLine(WindowContext& context, QWidget* parent)
    : QWidget(parent), context_(context), line_(new QLineEdit), said_(role_label("label")) {
    setObjectName("mdi");
    line_->setObjectName("mdi_line");
    line_->setAccessibleName(tr("One block of G-code, run by Return"));
    line_->setPlaceholderText(tr("One block; Return runs it"));
    line_->setMaxLength(kMostLetters);
    line_->setText(QString::fromStdString(context_.program.typed));
    line_->installEventFilter(this);
    said_->setObjectName("mdi_said");
    said_->setWordWrap(true);
    connect(line_, &QLineEdit::textChanged, this, [this](const QString& text) {
        context_.program.typed = text.toStdString();
        refused_.clear();
        is_text_refused_ = false;
    });
    connect(line_, &QLineEdit::returnPressed, this, [this] { run_block(); });
    auto* row = new QHBoxLayout;
    row->setSpacing(kGap);
    row->addWidget(role_label("head", tr("MDI")));
    row->addWidget(line_, 1);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(kSmallGap);
    all->addLayout(row);
    all->addWidget(said_);
}

void MdiLine::run_block() {
    const QString block = line_->text().trimmed();
    if (block.isEmpty()) return;
    is_text_refused_ = true;
    if (std::any_of(block.begin(), block.end(), ends_line)) {
        refused_ = tr("The text has more than one line; only one block is run.");
        return refresh();
    }
    if (const qsizetype bytes = block.toUtf8().size(); bytes > qsizetype{gcode::kMostLineBytes}) {
        refused_ = tr("The block has %1 bytes; a line has %2 at most.").arg(bytes).arg(gcode::kMostLineBytes);
        return refresh();
    }
    is_text_refused_ = false;
    if (const auto lock = program::machine_lock(program_ground(context_))) {
        refused_ = words(*lock);
        return refresh();
    }
    context_.program.run_block(block.toStdString(), context_.machine.view());
    behind_last_ = 0;
    line_->selectAll();
    refresh();
}

/// Older ones by Up, back to what was being typed by Down.
void MdiLine::bring_back(bool is_older) {
    const auto& blocks = context_.program.blocks();
    if (is_older ? behind_last_ == blocks.size() : behind_last_ == 0) return;
    if (behind_last_ == 0) typed_ = line_->text();
    behind_last_ += is_older ? 1 : std::size_t(-1);
    line_->setText(behind_last_ == 0 ? typed_ : QString::fromStdString(blocks[blocks.size() - behind_last_]));
}

bool MdiLine::eventFilter(QObject* watched, QEvent* event) {
    if (watched == line_ && event->type() == QEvent::ShortcutOverride &&
        is_return(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    if (watched == line_ && event->type() == QEvent::KeyPress) {
        const auto* const key = static_cast<QKeyEvent*>(event);
        // A shortcut of the window's begins something else; a key that is held runs nothing twice.
        if (is_return(*key) &&
            (key->isAutoRepeat() || (key->modifiers() & ~Qt::KeyboardModifiers{Qt::KeypadModifier}) != 0))
            return true;
        const bool is_up = key->key() == Qt::Key_Up;
        if ((is_up || key->key() == Qt::Key_Down) && key->modifiers() == Qt::NoModifier) {
            bring_back(is_up);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

QString MdiLine::said() const {
    if (!refused_.isEmpty()) return refused_;
    const program::ProgramDesk& desk = context_.program;
    if (desk.is_block() && desk.is_under_way()) return tr("The block runs.");
    if (desk.is_block() && desk.ended()) {
        const auto& ended = *desk.ended();
        QStringList wrong;
        for (const gcode::Problem& problem : ended.problems.errors())
            wrong += tr("Column %1: %2").arg(problem.column).arg(problem_words(problem));
        if (!wrong.isEmpty()) return wrong.join('\n');
        if (!ended.is_done) return words(session::error_phrase(ended.said));
        return tr("The block is run.");
    }
    return tr(
        "Each block is a program of its own: G21 G17 G90 G94 G54 G80 hold before it, without a feed, and "
        "the spindle is off behind it.");
}

void MdiLine::refresh() {
    const program::ProgramDesk& desk = context_.program;
    if (!refused_.isEmpty() && !is_text_refused_ && !program::machine_lock(program_ground(context_)))
        refused_.clear();
    const bool is_wrong = !refused_.isEmpty() ||
                          (desk.is_block() && desk.ended() && !desk.ended()->is_done && !desk.is_under_way());
    const QString text = said();
    if (said_->text() != text) said_->setText(text);
    set_styled(said_, "role", is_wrong ? "problem" : "label");
}

}  // namespace psicarve::ui
