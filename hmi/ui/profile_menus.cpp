// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/profile_menus.hpp"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QMenu>

#include <chrono>

#include "hmi/profile/profile_draft.hpp"

namespace psicarve::ui {
namespace {

using profile::ProfileDraft;
using session::FilePresence;

struct ProfileMenus {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ProfilePage)
};

QDateTime time_of(std::filesystem::file_time_type written) {
    const auto time = std::chrono::file_clock::to_sys(written);
    return QDateTime::fromMSecsSinceEpoch(
        std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count());
}

}  // namespace

void fill_profile_menu(QMenu& menu, const QStringList& recent, const FilePresence& presence,
                       const std::function<void()>& choose, const std::function<void(const QString&)>& open,
                       const std::function<void()>& open_built_in) {
    menu.clear();
    QAction* const other = menu.addAction(ProfileMenus::tr("Choose a file..."));
    other->setObjectName("profile_choose_file");
    QObject::connect(other, &QAction::triggered, choose);
    menu.addSeparator();
    for (const QString& path : recent) {
        if (presence.seen(path.toStdString()).state == FilePresence::State::gone) continue;
        QAction* const action = menu.addAction(QFileInfo{path}.fileName());
        action->setObjectName("profile_recent_file");
        action->setToolTip(path);
        QObject::connect(action, &QAction::triggered, [open, path] { open(path); });
    }
    menu.addSeparator();
    QAction* const built_in = menu.addAction(ProfileMenus::tr("Built-in profile"));
    built_in->setObjectName("profile_built_in");
    QObject::connect(built_in, &QAction::triggered, open_built_in);
}

void fill_backup_menu(QMenu& menu, const std::string& path, const FilePresence& presence,
                      const std::function<void(const std::string&)>& take) {
    menu.clear();
    for (const std::string& backup : ProfileDraft::backups_of(path)) {
        const FilePresence::Seen seen = presence.seen(backup);
        if (seen.state != FilePresence::State::there) continue;
        const QString time = time_of(seen.written).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
        const QString name = QFileInfo{QString::fromStdString(backup)}.fileName();
        QAction* const action = menu.addAction(QStringLiteral("%1  %2").arg(time, name));
        action->setObjectName("profile_backup");
        QObject::connect(action, &QAction::triggered, [take, backup] { take(backup); });
    }
}

}  // namespace psicarve::ui
