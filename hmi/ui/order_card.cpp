// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/order_card.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>

#include <algorithm>

#include "hmi/ui/action_button.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using Help = session::OrderRefusal::Help;

constexpr int kOrderIconSide = 16;
constexpr int kReadWidth = 24;
constexpr int kWidthBeside = 300;

/// The one with the pages, of a panel in a frame of its own, too.
QWidget* window_of(const QWidget& user) {
    QWidget* const window = user.window();
    if (qobject_cast<QMainWindow*>(window) != nullptr) return window;
    QWidget* const owner = window->parentWidget();
    return owner != nullptr ? qobject_cast<QMainWindow*>(owner->window()) : nullptr;
}

/// Below their names, in the window.
QRect pages_of(const QWidget& window) {
    const auto* const tabs = window.findChild<QTabWidget*>("tabs");
    if (tabs == nullptr) return window.rect();
    const QRect all{tabs->mapTo(&window, QPoint{}), tabs->size()};
    return all.adjusted(kSmallGap, tabs->tabBar()->height() + kSmallGap, -kSmallGap, -kSmallGap);
}

Help help_now(const WindowContext& context) {
    const auto& told = context.machine.refused_order();
    return told ? told->help : Help::none;
}

std::optional<session::Phrase> help_lock(const WindowContext& context) {
    const auto action =
        help_now(context) == Help::reset_alarm ? session::Action::reset_alarm : session::Action::home;
    return session::lock_of(action, context.machine.view(), context.open_job.view());
}

}  // namespace

OrderCard::OrderCard(WindowContext& context, session::OrderPlace place, const QString& name, Shape shape,
                     QWidget* parent)
    : QFrame(parent),
      context_(context),
      place_(place),
      icon_(new QLabel),
      why_(plain_label()),
      remedy_(new ActionButton{help_lock, QString{}, [this] { help(); }}),
      read_(new QPushButton{QStringLiteral("\u2715")}) {
    read_->setAutoDefault(false);  // Enter in a dialog is not for it
    setObjectName("refused_" + name);
    setProperty("notice", true);
    why_->setObjectName(objectName() + "_why");
    why_->setWordWrap(true);
    remedy_->setObjectName(objectName() + "_remedy");
    remedy_->setProperty("small", true);
    remedy_->setAutoDefault(false);
    read_->setObjectName(objectName() + "_read");
    read_->setProperty("small", true);
    read_->setFocusPolicy(Qt::TabFocus);
    read_->setFixedWidth(kReadWidth);
    read_->setAccessibleName(tr("Acknowledge"));
    read_->setToolTip(tr("Takes this away once it was read; it moves and stops nothing"));
    connect(read_, &QAbstractButton::clicked, this, [this] {
        context_.machine.forget_refused_order(place_);
        hide();
    });
    lay_out(shape);
    hide();
}

void OrderCard::lay_out(Shape shape) {
    auto* grid = new QGridLayout{this};
    grid->setContentsMargins(kSmallGap, kSmallGap, kSmallGap, kSmallGap);
    grid->setSpacing(kSmallGap);
    grid->setColumnStretch(1, 1);
    grid->addWidget(icon_, 0, 0, Qt::AlignTop);
    grid->addWidget(why_, 0, 1);
    grid->addWidget(read_, 0, 3, Qt::AlignTop);
    if (shape == Shape::wide) {
        grid->addWidget(remedy_, 0, 2, Qt::AlignTop);
    } else {
        grid->addWidget(remedy_, 1, 1, 1, 3);
    }
}

void OrderCard::set_theme(const Tokens& tokens) {
    icon_->setPixmap(glyph_pixmap(Glyph::triangle, kOrderIconSide, tokens.warn));
}

void OrderCard::help() {
    const Help wanted = help_now(context_);
    if (wanted == Help::home_all) context_.machine.order(CommandKind::home, session::phrase("Home"));
    if (wanted == Help::reset_alarm)
        context_.machine.order(CommandKind::reset_alarm, session::phrase("Reset alarm"));
}

bool OrderCard::is_wanted() const {
    const auto& told = context_.machine.refused_order();
    return told && told->place == place_ && !context_.replay.is_open();
}

void OrderCard::show_refusal(const session::OrderRefusal& refusal) {
    const QString why = breakable(words(refusal.what));
    if (why_->text() != why) why_->setText(why);
    const bool has_help = refusal.help != Help::none;
    if (remedy_->isHidden() == has_help) remedy_->setVisible(has_help);
    const QString text = refusal.help == Help::reset_alarm ? tr("Reset alarm") : tr("Home all");
    if (remedy_->text() != text) remedy_->setText(text);
    remedy_->refresh(context_);
    setAccessibleName(why_->text());
}

bool OrderCard::refresh() {
    const bool is_there = is_wanted();
    if (is_there) show_refusal(*context_.machine.refused_order());
    if (isHidden() == is_there) setVisible(is_there);
    return is_there;
}

/// False: there is nothing to be told, or no window with pages.
bool OrderCard::comes_before_pages(const QWidget& user) {
    QWidget* const window = window_of(user);
    if (window == nullptr) return false;
    if (parentWidget() != window) setParent(window);
    if (!is_wanted()) return false;
    show_refusal(*context_.machine.refused_order());
    return true;
}

void OrderCard::show_at(QPoint at, QSize size) {
    const QRect pages = pages_of(*parentWidget());
    const int right = pages.right() + 1 - size.width();
    const int lowest = pages.bottom() + 1 - size.height();
    setGeometry(QRect{QPoint{std::clamp(at.x(), pages.left(), std::max(pages.left(), right)),
                             std::clamp(at.y(), pages.top(), std::max(pages.top(), lowest))},
                      size});
    if (isHidden()) show();
    raise();
}

void OrderCard::refresh_beside(const QWidget& panel, const QWidget& button) {
    if (!comes_before_pages(panel)) return hide();
    QWidget* const ground = parentWidget();
    const QRect pages = pages_of(*ground);
    const int width = std::min(kWidthBeside, pages.width());
    const QSize size{width, heightForWidth(width)};
    if (panel.isVisible() && panel.window() == ground) {
        const int middle = panel.mapTo(ground, panel.rect().center()).x();
        const int x = middle < pages.center().x() ? pages.left() : pages.right() + 1 - width;
        return show_at({x, button.mapTo(ground, QPoint{}).y()}, size);
    }
    QPoint at{pages.left(), pages.center().y() - size.height() / 2};
    // Its own frame may stand there.
    const QRect there{ground->mapToGlobal(at), size};
    if (panel.window() != ground && panel.window()->geometry().intersects(there))
        at.setX(pages.right() + 1 - width);
    show_at(at, size);
}

void OrderCard::refresh_above(const QWidget& user) {
    if (!user.isVisible() || !comes_before_pages(user)) return hide();
    const QRect pages = pages_of(*parentWidget());
    show_at(pages.topLeft(), {pages.width(), heightForWidth(pages.width())});
}

}  // namespace psicarve::ui
