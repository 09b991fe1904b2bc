// SPDX-License-Identifier: GPL-3.0-or-later
// Where the window stands and what becomes of it when it goes.
#include <QApplication>
#include <QScreen>
#include <QTimer>

#include <algorithm>
#include <array>

#include "hmi/ui/main_window.hpp"
#include "hmi/ui/model_page.hpp"
#include "hmi/ui/option_keeper.hpp"
#include "hmi/ui/page_tabs.hpp"
#include "hmi/ui/place_keeper.hpp"
#include "hmi/ui/side_panels.hpp"

namespace psicarve::ui {
namespace {

// In the order of the tabs.
constexpr std::array<const char*, 8> kPageNames{"model",    "layers",   "carving", "ports",
                                                "realtime", "messages", "profile", "program"};

}  // namespace

void MainWindow::take_place() {
    const FirstPlace first = first_place(screen()->availableSize());
    resize(first.size);
    const bool has_place = restoreGeometry(settings_.geometry());
    if (!has_place && first.is_maximised) setWindowState(Qt::WindowMaximized);
}

/// By settings that came after the first frame.
void MainWindow::show_kept_place() {
    restoreGeometry(settings_.geometry());
    if (wants_last_page_ && pages_->currentIndex() == 0) go_to_last_page();
}

void MainWindow::go_to_last_page() {
    wants_last_page_ = !context_.settings->is_read();
    const QString page = settings_.page();
    const auto found = std::find_if(kPageNames.begin(), kPageNames.end(),
                                    [&page](const char* name) { return page == QLatin1StringView{name}; });
    if (found != kPageNames.end()) pages_->setCurrentIndex(static_cast<int>(found - kPageNames.begin()));
}

/// Whatever ends the program.
void MainWindow::keep_place() {
    place_keeper_ = std::make_unique<PlaceKeeper>([this] { write_place(); });
    place_keeper_->watch(*this);
    for (std::size_t i = 0; i < SidePanels::kCount; ++i) {
        if (sides_->is_floating(i)) place_keeper_->watch(sides_->frame(i));
    }
    connect(pages_, &QTabWidget::currentChanged, place_keeper_.get(), [this] { place_keeper_->keep_soon(); });
    option_keeper_ = std::make_unique<OptionKeeper>(*this, settings_, [this] {
        if (place_keeper_) place_keeper_->keep_soon();
    });
}

void MainWindow::write_place() {
    if (option_keeper_) option_keeper_->write();
    if (!context_.settings->is_read()) return;  // the operator has not chosen this place
    settings_.set_geometry(saveGeometry());
    const auto page = static_cast<std::size_t>(pages_->currentIndex());
    if (page < kPageNames.size()) settings_.set_page(kPageNames[page]);
    keep_panel_places();
}

void MainWindow::leave() {
    let_go();
    context_.open_job.cancel();
    write_place();
    pages_->model().forget_work();
    place_keeper_.reset();
    // The window is closed: what is to be kept is handed on now.
    context_.pins.end();
    context_.keeper.poll(context_.log);
    context_.settings->poll();
    timer_.stop();
}

/// The core may take its time, or hang: the window goes on meanwhile, and stays when it was not heard.
void MainWindow::close_once_held() {
    context_.log.add(session::Severity::info,
                     session::phrase("Hold asked for: the window closes once the core has taken it"));
    context_.machine.order_and_tell(CommandKind::hold, [this](bool was_taken) {
        // What has come to rest meanwhile needs no hold.
        closes_held_ = was_taken || (context_.machine.view().is_heard() && !is_under_way());
        if (closes_held_) return QTimer::singleShot(0, this, [this] { close(); });
        context_.log.add(session::Severity::warning,
                         session::phrase("The window stays open: the core has not taken the hold"),
                         session::phrase("Use the switch on the machine to stop it"));
    });
}

}  // namespace psicarve::ui
