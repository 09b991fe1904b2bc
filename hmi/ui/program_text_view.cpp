// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/program_text_view.hpp"

#include <QFontDatabase>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>

#include <algorithm>
#include <limits>

#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kTextRowGap_px = 3;
constexpr int kTextGap_px = 8;
constexpr int kTextLetters_px = 13;
constexpr int kLeastDigits = 4;
constexpr int kRunningBar_px = 4;
constexpr int kWheelLines = 3;

}  // namespace

QString problem_words(const gcode::Problem& problem) {
    return words(gcode::problem_phrase(problem));
}

ProgramTextView::ProgramTextView(program::TextWindow& text, QWidget* parent)
    : QAbstractScrollArea(parent),
      text_(text),
      letters_(QFontDatabase::systemFont(QFontDatabase::FixedFont)) {
    setObjectName("program_text");
    setAccessibleName(tr("The program's text"));
    letters_.setPixelSize(kTextLetters_px);
    letters_.setStyleHint(QFont::TypeWriter);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::TabFocus);
    verticalScrollBar()->setSingleStep(kWheelLines);
}

void ProgramTextView::set_theme(const Tokens& tokens) {
    tokens_ = &tokens;
    viewport()->update();
}

void ProgramTextView::show_program(const program::DecodedPointer& program) {
    if (program == program_) return;
    const bool is_same_file = program && program_ && program->request.path == program_->request.path;
    program_ = program;
    problems_.clear();
    if (program_) {
        // An error goes before a warning.
        for (const auto* list : {&program_->problems.errors(), &program_->problems.warnings()})
            for (const gcode::Problem& problem : *list) problems_.emplace(problem.line, &problem);
    }
    if (!is_same_file) {
        chosen_ = 0;
        verticalScrollBar()->setValue(0);
    }
    fit_bar();
    viewport()->update();
}

std::uint64_t ProgramTextView::line_count() const noexcept {
    return program_ ? program_->lines.line_count() : 0;
}

int ProgramTextView::row_height() const {
    return QFontMetrics{letters_}.height() + kTextRowGap_px;
}

int ProgramTextView::gutter_width() const {
    const auto digits = std::max(static_cast<int>(QString::number(line_count()).size()), kLeastDigits);
    return digits * QFontMetrics{letters_}.horizontalAdvance('0') + 2 * kTextGap_px;
}

std::uint64_t ProgramTextView::first_line() const {
    return static_cast<std::uint64_t>(verticalScrollBar()->value()) + 1;
}

std::uint64_t ProgramTextView::seen_lines() const {
    return static_cast<std::uint64_t>(std::max(viewport()->height() / row_height(), 1));
}

void ProgramTextView::fit_bar() {
    const auto seen = static_cast<std::int64_t>(seen_lines());
    const auto most = std::min<std::int64_t>(static_cast<std::int64_t>(line_count()) - seen,
                                             std::numeric_limits<int>::max() - 1);
    verticalScrollBar()->setPageStep(static_cast<int>(seen));
    verticalScrollBar()->setRange(0, static_cast<int>(std::max<std::int64_t>(most, 0)));
    text_.want(first_line(), seen_lines() + 1);
}

void ProgramTextView::resizeEvent(QResizeEvent* event) {
    QAbstractScrollArea::resizeEvent(event);
    fit_bar();
}

void ProgramTextView::scrollContentsBy(int /*dx*/, int /*dy*/) {
    text_.want(first_line(), seen_lines() + 1);
    viewport()->update();
}

void ProgramTextView::bring_into_sight(std::uint64_t line) {
    if (line >= first_line() && line < first_line() + seen_lines()) return;
    const std::uint64_t before = seen_lines() / 3;
    verticalScrollBar()->setValue(static_cast<int>(
        std::min<std::uint64_t>(line > before ? line - before - 1 : 0, std::numeric_limits<int>::max() - 1)));
}

void ProgramTextView::mark_running(std::uint64_t line) {
    if (line == running_) return;
    running_ = line;
    if (follows_ && running_ != 0) bring_into_sight(running_);
    viewport()->update();
}

void ProgramTextView::set_following(bool follows) {
    follows_ = follows;
    if (follows_ && running_ != 0) bring_into_sight(running_);
}

void ProgramTextView::go_to(std::uint64_t line) {
    chosen_ = line;
    bring_into_sight(line);
    viewport()->update();
    if (on_chosen_) on_chosen_(line);
}

void ProgramTextView::mousePressEvent(QMouseEvent* event) {
    const auto row = static_cast<std::uint64_t>(std::max(event->pos().y(), 0) / row_height());
    if (first_line() + row <= line_count()) go_to(first_line() + row);
}

void ProgramTextView::paintEvent(QPaintEvent* /*event*/) {
    if (tokens_ == nullptr) return;
    QPainter painter{viewport()};
    painter.fillRect(viewport()->rect(), tokens_->field);
    painter.fillRect(QRect{0, 0, gutter_width(), viewport()->height()}, tokens_->panel);
    if (!program_) {
        painter.setPen(tokens_->text2);
        painter.drawText(viewport()->rect().adjusted(kTextGap_px, 0, -kTextGap_px, 0),
                         Qt::AlignCenter | Qt::TextWordWrap, tr("No program is open."));
        return;
    }
    painter.setFont(letters_);
    const int height = row_height();
    for (std::uint64_t row = 0; row <= seen_lines(); ++row) {
        const std::uint64_t line = first_line() + row;
        if (line > line_count()) break;
        draw_line(painter, line, {0, static_cast<int>(row) * height, viewport()->width(), height});
    }
}

void ProgramTextView::draw_line(QPainter& painter, std::uint64_t line, const QRect& row) const {
    const auto found = problems_.find(line);
    const gcode::Problem* const problem = found == problems_.end() ? nullptr : found->second;
    const int gutter = gutter_width();
    if (line == chosen_) painter.fillRect(row.adjusted(gutter, 0, 0, 0), tokens_->raised);
    if (line == running_) {
        painter.fillRect(row, tokens_->sel);
        painter.fillRect(QRect{row.left(), row.top(), kRunningBar_px, row.height()}, tokens_->run_fill);
    }
    painter.setPen(line == running_ ? tokens_->text : tokens_->text2);
    painter.drawText(row.adjusted(0, 0, gutter - row.width() - kTextGap_px, 0),
                     Qt::AlignRight | Qt::AlignVCenter, QString::number(line));
    const std::string* const text = text_.line(line);
    const QString shown =
        text != nullptr
            ? QString::fromUtf8(text->data(), static_cast<qsizetype>(text->size())).replace('\t', ' ')
            : QString{};
    painter.setPen(line > program_->facts.line_count ? tokens_->dis : tokens_->text);
    const QRect room = row.adjusted(gutter + kTextGap_px, 0, 0, 0);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, shown);
    if (problem != nullptr)
        draw_problem(painter, *problem, row, room.left() + painter.fontMetrics().horizontalAdvance(shown));
}

/// Beside the text, or over its end where there is no room: what is wrong is worth more.
void ProgramTextView::draw_problem(QPainter& painter, const gcode::Problem& problem, const QRect& row,
                                   int text_end) const {
    const bool is_warning = gcode::is_warning(problem.code);
    const QString text = "◀ " + problem_words(problem);
    const int wanted = painter.fontMetrics().horizontalAdvance(text) + 2 * kTextGap_px;
    const int least_left = row.left() + gutter_width() + row.width() / 4;
    const int left = std::max(std::min(text_end + 2 * kTextGap_px, row.right() - wanted),
                              std::min(least_left, text_end + 2 * kTextGap_px));
    const QRect room{left, row.top(), row.right() - left + 1, row.height()};
    painter.fillRect(room, is_warning ? tokens_->warn_ground : tokens_->alarm_ground);
    painter.setPen(is_warning ? tokens_->warn : tokens_->alarm);
    const QRect inside = room.adjusted(kTextGap_px, 0, -kTextGap_px, 0);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, inside.width()));
}

}  // namespace psicarve::ui
