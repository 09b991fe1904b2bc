// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/tab_badge.hpp"

#include <QCoreApplication>
#include <QLabel>
#include <QTabBar>

#include "hmi/ui/frames.hpp"

namespace psicarve::ui {

void set_tab_badge(QTabBar& bar, int tab, std::size_t count, BadgeTone tone) {
    auto* badge = qobject_cast<QLabel*>(bar.tabButton(tab, QTabBar::RightSide));
    if (count == 0) {
        if (badge == nullptr) return;
        bar.setTabButton(tab, QTabBar::RightSide, nullptr);
        badge->deleteLater();
        return bar.setAccessibleTabName(tab, bar.tabText(tab));
    }
    const QString text = QString::number(count);
    if (badge == nullptr) {
        badge = new QLabel;
        badge->setObjectName(QStringLiteral("tab_badge_%1").arg(tab));
        badge->setAlignment(Qt::AlignCenter);
        badge->setAttribute(Qt::WA_TransparentForMouseEvents);  // the tab is pressed, not the number
    }
    set_styled(badge, "badge", tone == BadgeTone::alarm ? "alarm" : "warning");
    if (badge->text() == text && bar.tabButton(tab, QTabBar::RightSide) == badge) return;
    badge->setText(text);
    badge->ensurePolished();
    badge->adjustSize();
    bar.setTabButton(tab, QTabBar::RightSide, badge);
    badge->show();  // the bar hides what stood there before, though it is the same
    const QString told = QCoreApplication::translate("psicarve::ui::MainWindow", "%1: %2 to look at");
    bar.setAccessibleTabName(tab, told.arg(bar.tabText(tab), text));
}

}  // namespace psicarve::ui
