// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <array>

#include "hmi/ui/bench.hpp"
#include "hmi/ui/motion_buttons.hpp"
#include "hmi/ui/tokens.hpp"

class QScrollArea;
class QStackedWidget;
class QTabBar;
class QVBoxLayout;

namespace psicarve::ui {

/// How much room a window has for what stands beside its pages.
enum class Room : std::uint8_t {
    small,  ///< the panels become pages of one column
    usual,
    wide,  ///< more room for each
};

/// By the window's size in pixels of 100 %.
Room room_in(QSize window);

/// Start, Hold, Resume and Stop where the job's panel is a page that may be hidden.
class MotionBlock : public QWidget {
public:
    explicit MotionBlock(Bench& bench);

    void set_theme(const Tokens& tokens);
    void refresh();

private:
    Bench& bench_;
    MotionButtons buttons_;
};

/// Arranges the three panels beside the window's pages.
class SidePanels {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::SidePanels)
public:
    SidePanels(Bench& bench, QWidget* position, QWidget* jog, QWidget* job);

    QWidget& left() noexcept { return *left_; }
    QWidget& right() noexcept { return *right_; }
    MotionBlock& buttons() noexcept { return *buttons_; }
    /// True when something has changed its place.
    bool arrange(Room room);

private:
    void stack();
    void spread(Room room);

    std::array<QWidget*, 3> panels_;  ///< Position, Jog, Job
    std::array<QScrollArea*, 3> pages_{};
    QWidget* left_;
    QWidget* right_;
    QVBoxLayout* left_column_;
    QVBoxLayout* right_column_;
    QTabBar* names_;
    QStackedWidget* stack_;
    MotionBlock* buttons_;
    Room room_ = Room::usual;
};

}  // namespace psicarve::ui
