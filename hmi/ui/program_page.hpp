// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <array>
#include <cstdint>
#include <functional>

#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QAbstractButton;
class QBoxLayout;
class QButtonGroup;
class QLabel;
class QLayout;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace psicarve::ui {

class ActionButton;
class ApproachCard;
class ElidedLabel;
class MdiLine;
class ProgramPathView;
class ProgramTextView;
class RapidOverride;
class TickBox;

/// A program in G-code: its text, what is wrong with it, its path, how it is run and where it is; and one
/// block typed by hand. Its members: widgets, and which edition of the program they show.
class ProgramPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ProgramPage)
public:
    /// `open`: a file, as every one is opened.
    ProgramPage(WindowContext& context, std::function<void(const QString& path)> open,
                QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    /// Errors of the program that is open.
    std::size_t error_count() const;
    /// Asks for a file.
    void choose_file();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QLayout* make_head();
    QLayout* make_switches();
    QLayout* make_views();
    TickBox* switch_box(const char* name, const QString& text, const QString& hint,
                        std::function<void(bool)> take);
    void switch_single(bool is_on);
    void switch_optional_stop(bool is_on);
    void order_switch(CommandKind kind, bool is_on, const session::Phrase& name);
    void make_problems();
    void start();
    void show_program();
    void show_switches();
    void show_buttons();
    void show_running();
    QString facts_text() const;
    QString state_text() const;
    QString modes_text() const;
    QString offsets_text() const;
    static QString origin_name(const ProgramOrigin& origin);
    QString places_text(const std::array<double, kAxisCount>& places) const;
    void decode_again();

    WindowContext& context_;
    std::function<void(const QString&)> open_;
    ElidedLabel* name_;
    QPushButton* again_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QProgressBar* progress_;
    TickBox* single_ = nullptr;
    TickBox* optional_ = nullptr;
    TickBox* delete_ = nullptr;
    TickBox* dry_ = nullptr;
    QSpinBox* from_line_ = nullptr;
    RapidOverride* rapids_ = nullptr;
    ActionButton* start_ = nullptr;
    ActionButton* stop_ = nullptr;
    QLabel* state_;
    QLabel* facts_;
    QLabel* modes_;
    ApproachCard* card_;
    ProgramTextView* text_;
    ProgramPathView* path_;
    TickBox* follow_ = nullptr;
    QBoxLayout* views_ = nullptr;
    QListWidget* problems_;
    MdiLine* mdi_;
    std::uint64_t shown_text_edition_ = 0;
    std::uint64_t shown_edition_ = static_cast<std::uint64_t>(-1);
};

}  // namespace psicarve::ui
