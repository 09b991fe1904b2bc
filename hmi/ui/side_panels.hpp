// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <array>
#include <functional>
#include <memory>

#include "hmi/ui/motion_buttons.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QLabel;
class QScrollArea;
class QStackedWidget;
class QTabBar;
class QVBoxLayout;

namespace psicarve::ui {

class OrderCard;
class FloatingPanel;

/// How much room a window has for what stands beside its pages.
enum class Room : std::uint8_t {
    small,  ///< the panels become pages of one column
    usual,
    wide,  ///< more room for each
};

/// By the window's size in pixels of 100 %.
Room room_in(QSize window);

/// How a window begins that has no place yet.
struct FirstPlace {
    QSize size;
    bool is_maximised = false;  ///< only without its frame there is the usual room
};
/// `screen`: what the desktop leaves free of it, in pixels of 100 %.
FirstPlace first_place(QSize screen);

/// Start, Hold, Resume and Stop where the job's panel is a page that may be hidden, and why they are locked.
class MotionBlock : public QWidget {
public:
    explicit MotionBlock(WindowContext& context);

    void set_theme(const Tokens& tokens);
    void refresh();

private:
    WindowContext& context_;
    MotionButtons buttons_;
    QLabel* reason_;
    OrderCard* refused_;
};

/// Arranges the three panels beside the window's pages.
class SidePanels {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::SidePanels)
public:
    static constexpr std::size_t kCount = 3;

    SidePanels(WindowContext& context, QWidget* position, QWidget* jog, QWidget* job);
    ~SidePanels();

    QWidget& left() noexcept { return *left_; }
    QWidget& right() noexcept { return *right_; }
    MotionBlock& buttons() noexcept { return *buttons_; }
    /// True when something has changed its place.
    bool arrange(Room room);
    static QString name(std::size_t panel);
    static QString short_name(std::size_t panel);
    /// In a frame of its own above the window, or back in its place. `put_back`: the frame was closed;
    /// `left`: another window became the active one.
    void float_panel(std::size_t panel, QWidget* window, std::function<void()> put_back,
                     std::function<void()> left);
    void dock_panel(std::size_t panel);
    /// Of a panel that floats.
    QWidget& frame(std::size_t panel) noexcept;
    bool is_floating(std::size_t panel) const noexcept { return floats_[panel] != nullptr; }
    /// Whether it is a frame of ours.
    bool is_ours(const QWidget* window) const noexcept;

private:
    void place();
    void stack();
    void spread(Room room);

    std::array<QWidget*, kCount> panels_;  ///< Position, Jog, Job
    std::array<std::unique_ptr<FloatingPanel>, kCount> floats_;
    std::array<QScrollArea*, kCount> pages_{};
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
