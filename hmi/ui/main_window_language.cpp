// SPDX-License-Identifier: GPL-3.0-or-later
// Another language: all views are made anew, what they show goes on below them.
#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>

#include <chrono>

#include "hmi/ui/compare_tool.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/main_window.hpp"
#include "hmi/ui/model_page.hpp"
#include "hmi/ui/option_keeper.hpp"
#include "hmi/ui/page_tabs.hpp"
#include "hmi/ui/place_keeper.hpp"

namespace psicarve::ui {

void MainWindow::choose_language(std::optional<Language> choice) {
    settings_.set_language(choice);
    constexpr std::chrono::milliseconds kTry{20};
    language_timer_.start(kTry);  // not while a menu of the window is on its way out
}

/// No question is open, no button held, no file waited for.
bool MainWindow::may_change_language() const {
    return context_.settings->is_read() && open_dialog() == nullptr &&
           QApplication::activePopupWidget() == nullptr && QApplication::mouseButtons() == Qt::NoButton &&
           !arrival_.is_awaited() && !context_.profile_desk.lock() && pages_->is_quiet() &&
           !compare_->is_comparing();
}

void MainWindow::change_language() {
    if (!may_change_language()) return;
    language_timer_.stop();
    const Language language = settings_.language().value_or(desktop_language());
    if (language == used_language()) return;
    let_go();
    write_place();
    const ModelPage::Work work = pages_->model().work();
    const int page = pages_->currentIndex();
    setUpdatesEnabled(false);
    take_down();
    use_language(language);
    build(Begin::with_work_that_comes);
    show_room(room_in(size()));
    pages_->setCurrentIndex(page);
    pages_->model().take_work(work);
    if (status_line_.shown()) show_last_message();
    refresh();
    setUpdatesEnabled(true);
}

void MainWindow::take_down() {
    pages_->model().forget_work();
    option_keeper_.reset();
    place_keeper_.reset();
    float_actions_.clear();
    replay_actions_.clear();
    sides_.reset();
    delete takeCentralWidget();
    setMenuBar(new QMenuBar);
    delete menu_;
    delete compare_;
    const QList<QObject*> own = children();
    for (QObject* child : own) {
        if (qobject_cast<QAction*>(child) != nullptr || qobject_cast<QActionGroup*>(child) != nullptr)
            delete child;
    }
    shown_replay_ = 0;
}

}  // namespace psicarve::ui
