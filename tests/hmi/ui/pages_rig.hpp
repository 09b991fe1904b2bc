// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTabWidget>

#include <string>

#include "hmi/ui/profile_page.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui::test {

/// A window whose pages are chosen, and the profile on its page.
class PagesRig : public WindowRig {
protected:
    void show_page(const char* name) {
        auto* const tabs = window_->findChild<QTabWidget*>();
        for (int i = 0; i < tabs->count(); ++i) {
            if (tabs->widget(i)->isAncestorOf(window_->findChild<QWidget*>(name))) tabs->setCurrentIndex(i);
        }
        QApplication::processEvents();
        window_->refresh();
    }
    QString text_of(const char* label) { return window_->findChild<QLabel*>(label)->text(); }
    ProfilePage& profile() {
        return *static_cast<ProfilePage*>(window_->findChild<QWidget*>("profile_page"));
    }
    /// Until its values are shown.
    ::testing::AssertionResult opens(const std::string& path) {
        profile().open(QString::fromStdString(path));
        if (comes_true([&] { return profile().draft().path() == path; }))
            return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure() << path << all_messages().toStdString();
    }
    QLineEdit& field(const char* key) {
        auto* const row = window_->findChild<QWidget*>(QString{"row_"} + key);
        EXPECT_NE(row, nullptr) << key;
        return *row->findChild<QLineEdit*>();
    }
    void edit(const char* key, const QString& text) {
        QLineEdit& line = field(key);
        line.setText(text);
        Q_EMIT line.textEdited(text);
    }
    QMenu& opened_menu(const char* name) {
        auto* const menu = window_->findChild<QMenu*>(name);
        Q_EMIT menu->aboutToShow();
        return *menu;
    }
    QStringList entries_of(const char* menu) {
        QStringList entries;
        for (const QAction* action : opened_menu(menu).actions()) {
            if (!action->isSeparator()) entries += action->text();
        }
        return entries;
    }
    bool choose(const char* menu, const QString& entry) {
        for (QAction* action : opened_menu(menu).actions()) {
            if (action->text() != entry) continue;
            action->trigger();
            return true;
        }
        return false;
    }
    void choose_group(int row) { window_->findChild<QListWidget*>("profile_groups")->setCurrentRow(row); }
};

}  // namespace psicarve::ui::test
