// SPDX-License-Identifier: GPL-3.0-or-later
// What page Profile does with files, none of it in the thread that draws.
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include <utility>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/session/profile_changes.hpp"
#include "hmi/ui/calibration_dialog.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/differences_dialog.hpp"
#include "hmi/ui/profile_menus.hpp"
#include "hmi/ui/profile_page.hpp"
#include "hmi/ui/settings.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {

using session::Severity;

void ProfilePage::make_menus() {
    auto* profiles = new QMenu{this};
    profiles->setObjectName("profile_open_menu");
    profiles->setToolTipsVisible(true);
    open_->setMenu(profiles);
    connect(profiles, &QMenu::aboutToShow, this, [this, profiles] {
        fill_profile_menu(
            *profiles, WindowSettings{*context_.settings}.recent_profiles(), context_.presence,
            [this] { ask_open(); },
            [this](const QString& path) {
                if (may_lose_changes()) open(path);
            },
            [this] {
                if (!may_lose_changes() || is_kept(busy_text())) return;
                context_.profile_desk.show({});
                show_other();
            });
    });
    auto* backups = new QMenu{this};
    backups->setObjectName("profile_backups_menu");
    restore_->setMenu(backups);
    connect(backups, &QMenu::aboutToShow, this, [this, backups] {
        fill_backup_menu(*backups, draft().path(), context_.presence, [this](const std::string& backup) {
            if (is_kept(busy_text())) return;
            context_.profile_desk.take_backup(backup, [this](const Result<void>& taken) {
                if (!taken) report(taken);
                show_changed();
            });
            show_state();
        });
    });
}

bool ProfilePage::has_backup() const {
    return context_.presence.seen(profile::ProfileDraft::backup_path(draft().path())).state ==
           session::FilePresence::State::there;
}

/// By another thread: disks may sleep.
void ProfilePage::look_for_files() {
    std::vector<std::string> files;
    for (const QString& path : WindowSettings{*context_.settings}.recent_profiles())
        files.push_back(path.toStdString());
    if (!draft().path().empty()) {
        for (std::string& backup : profile::ProfileDraft::backups_of(draft().path()))
            files.push_back(std::move(backup));
    }
    context_.presence.look(std::move(files));
}

/// What keeps the page from anything that would get in the way of it.
std::optional<session::Phrase> ProfilePage::busy_lock() const {
    if (const auto busy = context_.profile_desk.lock()) return busy;
    return calibration_ != nullptr ? calibration_->file_lock() : std::nullopt;
}

QString ProfilePage::busy_text() const {
    const auto busy = busy_lock();
    return busy ? words(*busy) : QString{};
}

/// Whether something is in the way, which is said: it may have begun while a dialog was open.
bool ProfilePage::is_kept(const QString& reason) {
    if (!reason.isEmpty()) context_.log.add(Severity::warning, session::phrase("%1", reason.toStdString()));
    return !reason.isEmpty();
}

void ProfilePage::open(const QString& path) {
    if (is_kept(busy_text())) return;
    context_.profile_desk.open(path.toStdString(), [this, path](const Result<void>& opened) {
        if (opened) WindowSettings{*context_.settings}.add_recent_profile(path);
        show_opened(opened);
    });
    show_state();
}

/// By the calibration, which keeps this page's files alone while it has its own.
void ProfilePage::open_again() {
    context_.profile_desk.open_again([this](const Result<void>& opened) { show_opened(opened); });
    show_state();
}

void ProfilePage::show_opened(const Result<void>& opened) {
    if (opened) return show_other();
    context_.log.add(Severity::warning, session::error_phrase(opened.error()));
    show_state();
}

void ProfilePage::show_other() {
    look_for_files();
    show_rows();
}

void ProfilePage::report(const Result<void>& saved) {
    if (saved) {
        context_.log.add(Severity::info, session::phrase("Profile saved: %1", draft().path()));
    } else {
        context_.log.add(Severity::warning, session::joined(session::phrase("Profile not saved"),
                                                            session::error_phrase(saved.error())));
    }
    look_for_files();
    show_changed();
}

/// What becomes another is looked at before, and nothing else is saved: who has typed on, or opened another
/// file, while that was asked is asked anew.
void ProfilePage::ask_save() {
    while (draft().changed_count() > 0 && !is_kept(lock())) {
        const std::string path = draft().path();
        const auto changes = session::profile_changes(draft());
        if (!may_save(changes)) return;
        if (path == draft().path() && changes == session::profile_changes(draft())) return save();
    }
}

bool ProfilePage::may_save(const std::vector<session::DifferenceRow>& changes) {
    const QString name = QFileInfo{QString::fromStdString(draft().path())}.fileName();
    const std::size_t count = changes.size();
    DifferencesDialog question{{.title = tr("Save the profile"),
                                .text = count == 1 ? tr("%1: one value becomes another").arg(name)
                                                   : tr("%1: %2 values become others").arg(name).arg(count),
                                .before = tr("In the file"),
                                .after = tr("New"),
                                .accept = tr("Save")},
                               changes,
                               window()};
    return run_dialog(question) == QDialog::Accepted;
}

void ProfilePage::save() {
    if (is_kept(lock())) return;
    context_.profile_desk.save([this](const Result<void>& saved) { report(saved); });
    show_state();
}

void ProfilePage::save_as(const QString& path) {
    if (is_kept(lock())) return;
    context_.profile_desk.save_as(path.toStdString(), [this, path](const Result<void>& saved) {
        if (saved) WindowSettings{*context_.settings}.add_recent_profile(path);
        report(saved);
    });
    show_state();
}

void ProfilePage::calibrate() {
    if (!calibrate_->refresh(context_).isEmpty())
        return context_.log.add(Severity::warning, session::phrase("%1", calibrate_->reason().toStdString()));
    if (calibration_ == nullptr) {
        calibration_ = new CalibrationDialog{
            context_,
            {.lock = [this] { return context_.profile_desk.lock(); }, .written = [this] { open_again(); }},
            window()};
    }
    calibration_->open_for(draft().path());
    show_state();
}

bool ProfilePage::is_saving() const {
    return context_.profile_desk.is_saving() || (calibration_ != nullptr && calibration_->is_saving());
}

bool ProfilePage::may_lose_changes() {
    if (draft().changed_count() == 0 && !is_saving()) return true;
    // When a disk that does not answer will do so is not known.
    const QString question = is_saving() ? tr("The profile is still being saved. Lose what is not saved yet?")
                                         : tr("%1. Lose them?").arg(unsaved_text());
    QMessageBox box{QMessageBox::Question, tr("Profile"), question,
                    QMessageBox::Discard | QMessageBox::Cancel, window()};
    box.button(QMessageBox::Discard)->setObjectName("profile_discard");
    box.button(QMessageBox::Cancel)->setObjectName("profile_keep");
    box.setDefaultButton(QMessageBox::Cancel);
    return run_dialog(box) == QMessageBox::Discard;
}

void ProfilePage::ask_open() {
    if (!may_lose_changes()) return;
    const QString path = ask_for_file(this, tr("Open a machine profile"), {}, tr("Profiles (*.toml)"));
    if (!path.isEmpty()) open(path);
}

void ProfilePage::ask_save_as() {
    const QString path = ask_where_to_save(this, tr("Save the profile as"),
                                           QString::fromStdString(draft().path()), tr("Profiles (*.toml)"));
    if (!path.isEmpty()) save_as(path);
}

}  // namespace psicarve::ui
