// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractScrollArea>
#include <QCoreApplication>

#include <cstdint>
#include <functional>
#include <map>

#include "hmi/program/decoding.hpp"
#include "hmi/program/text_window.hpp"
#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {

/// A program's text with the numbers of its lines, what is wrong beside them, and the line that runs. Only
/// the lines that are seen are ever read.
class ProgramTextView : public QAbstractScrollArea {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ProgramTextView)
public:
    /// The text outlives the view.
    explicit ProgramTextView(program::TextWindow& text, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    /// Null: none.
    void show_program(const program::DecodedPointer& program);
    /// Lines have been read.
    void lines_changed() { viewport()->update(); }
    /// 0: none. Where it is followed it is brought into sight.
    void mark_running(std::uint64_t line);
    void set_following(bool follows);
    /// In the middle, and chosen.
    void go_to(std::uint64_t line);
    std::uint64_t chosen_line() const noexcept { return chosen_; }
    std::uint64_t running_line() const noexcept { return running_; }
    std::uint64_t first_line() const;
    std::uint64_t seen_lines() const;
    void set_on_chosen(std::function<void(std::uint64_t line)> chosen) { on_chosen_ = std::move(chosen); }

    QSize sizeHint() const override { return {360, 200}; }
    QSize minimumSizeHint() const override { return {200, 90}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    std::uint64_t line_count() const noexcept;
    int row_height() const;
    int gutter_width() const;
    void fit_bar();
    void bring_into_sight(std::uint64_t line);
    void draw_line(QPainter& painter, std::uint64_t line, const QRect& row) const;
    void draw_problem(QPainter& painter, const gcode::Problem& problem, const QRect& row, int text_end) const;

    program::TextWindow& text_;
    const Tokens* tokens_ = nullptr;
    program::DecodedPointer program_;
    std::map<std::uint64_t, const gcode::Problem*> problems_;  ///< the first of each line
    QFont letters_;
    std::uint64_t running_ = 0;
    std::uint64_t chosen_ = 0;
    bool follows_ = true;
    std::function<void(std::uint64_t)> on_chosen_;
};

/// "feed_missing: a move that cuts, and no feed; give F ...", as the command line says it.
QString problem_words(const gcode::Problem& problem);

}  // namespace psicarve::ui
