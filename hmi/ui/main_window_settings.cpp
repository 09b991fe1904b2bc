// SPDX-License-Identifier: GPL-3.0-or-later
// What the window begins with: its settings, and what the command line names.
#include <QDir>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/ui/first_touch.hpp"
#include "hmi/ui/main_window.hpp"
#include "hmi/ui/option_keeper.hpp"
#include "hmi/ui/page_tabs.hpp"
#include "hmi/ui/position_panel.hpp"
#include "hmi/ui/profile_page.hpp"

namespace psicarve::ui {

/// They came later than the first frame: from a disk that slept, say. Nothing moves below a hand by then.
void MainWindow::take_settings() {
    show_theme();
    if (!first_touch_ || !first_touch_->has_come()) {
        show_kept_place();
        show_kept_panels();
    }
    first_touch_.reset();
    if (option_keeper_) option_keeper_->fill_in_late();
    position_->take_zeros();
    look_for_recent();
    pages_->profile().look_for_files();
}

void MainWindow::begin_with(const QString& profile, const QString& path) {
    if (profile.isEmpty()) return path.isEmpty() ? go_to_last_page() : open(path);
    arrival_.fetch(profile.toStdString(),
                   [this, profile, path](const Result<Profile>& read) { take_profile(read, profile, path); });
}

/// A table becomes a job by the machine's profile: without the one that was asked for nothing is opened.
void MainWindow::take_profile(const Result<Profile>& read, const QString& profile, const QString& path) {
    if (!read) {
        context_.open_job.refuse(profile.toStdString(), session::error_phrase(read.error()));
        if (path.isEmpty()) return;
        return context_.log.add(
            session::Severity::warning,
            session::phrase("Not opened, as the machine's profile was not: %1", path.toStdString()));
    }
    context_.machine.set_profile(*read);
    pages_->profile().open(profile);
    if (!path.isEmpty()) open(path);
}

/// Of the file that was opened last, or the nearest above it that is there: without waiting for its disk.
QString MainWindow::last_folder() {
    const QString wanted = settings_.last_folder();
    context_.presence.look_above(wanted.toStdString());  // for the next time
    const std::string there = context_.presence.nearest_folder(wanted.toStdString());
    return there.empty() ? QDir::homePath() : QString::fromStdString(there);
}

}  // namespace psicarve::ui
