// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/order_card.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>

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

Help help_now(const Bench& bench) {
    const auto& told = bench.machine.refused_order();
    return told ? told->help : Help::none;
}

std::optional<session::Phrase> help_lock(const Bench& bench) {
    const auto action =
        help_now(bench) == Help::reset_alarm ? session::Action::reset_alarm : session::Action::home;
    return session::lock_of(action, bench.machine.sight(), bench.desk.sight());
}

}  // namespace

OrderCard::OrderCard(Bench& bench, session::OrderPlace place, const QString& name, Shape shape,
                     QWidget* parent)
    : QFrame(parent),
      bench_(bench),
      place_(place),
      icon_(new QLabel),
      why_(plain_label()),
      remedy_(new ActionButton{help_lock, QString{}, [this] { help(); }}),
      read_(new QPushButton{QStringLiteral("\u2715")}) {
    setObjectName("refused_" + name);
    setProperty("notice", true);
    why_->setObjectName(objectName() + "_why");
    why_->setWordWrap(true);
    remedy_->setObjectName(objectName() + "_remedy");
    remedy_->setProperty("small", true);
    read_->setObjectName(objectName() + "_read");
    read_->setProperty("small", true);
    read_->setFocusPolicy(Qt::TabFocus);
    read_->setFixedWidth(kReadWidth);
    read_->setAccessibleName(tr("Acknowledge"));
    read_->setToolTip(tr("Takes this away once it was read; it moves and stops nothing"));
    connect(read_, &QAbstractButton::clicked, this, [this] {
        bench_.machine.forget_refused_order(place_);
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
    const Help wanted = help_now(bench_);
    if (wanted == Help::home_all) bench_.machine.order(CommandKind::home, session::phrase("Home"));
    if (wanted == Help::reset_alarm)
        bench_.machine.order(CommandKind::reset_alarm, session::phrase("Reset alarm"));
}

bool OrderCard::is_wanted() const {
    const auto& told = bench_.machine.refused_order();
    return told && told->place == place_ && !bench_.replay.is_open();
}

void OrderCard::show_refusal(const session::OrderRefusal& refusal) {
    const QString why = breakable(words(refusal.what));
    if (why_->text() != why) why_->setText(why);
    const bool has_help = refusal.help != Help::none;
    if (remedy_->isHidden() == has_help) remedy_->setVisible(has_help);
    const QString text = refusal.help == Help::reset_alarm ? tr("Reset alarm") : tr("Home all");
    if (remedy_->text() != text) remedy_->setText(text);
    remedy_->refresh(bench_);
    setAccessibleName(why_->text());
}

bool OrderCard::refresh() {
    const bool is_there = is_wanted();
    if (is_there) show_refusal(*bench_.machine.refused_order());
    if (isHidden() == is_there) setVisible(is_there);
    return is_there;
}

void OrderCard::refresh_beside(QWidget& panel, const QWidget& button) {
    auto* const window = qobject_cast<QMainWindow*>(panel.window());
    QWidget* const ground = window != nullptr ? window : &panel;  // a frame goes before its panel does
    if (parentWidget() != ground) setParent(ground);
    if (!is_wanted() || !panel.isVisible()) return hide();
    show_refusal(*bench_.machine.refused_order());
    const int width = std::min(kWidthBeside, ground->width() - 2 * kGap);
    const int height = heightForWidth(width);
    const int lowest = ground->height() - height - kGap;
    QPoint at{kGap, lowest};
    if (window != nullptr) {
        const int right = panel.mapTo(ground, QPoint{panel.width() + kGap, 0}).x();
        const int left = panel.mapTo(ground, QPoint{-kGap - width, 0}).x();
        at = {right + width <= ground->width() ? right : left, button.mapTo(ground, QPoint{}).y()};
    }
    setGeometry(std::max(0, at.x()), std::clamp(at.y(), 0, std::max(0, lowest)), width, height);
    if (isHidden()) show();
    raise();
}

}  // namespace psicarve::ui
