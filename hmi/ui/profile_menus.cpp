// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/profile_menus.hpp"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QMenu>

#include "hmi/profile/profile_draft.hpp"

namespace psicarve::ui {
namespace {

using profile::ProfileDraft;

struct ProfileMenus {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ProfilePage)
};

}  // namespace

void fill_profile_menu(QMenu& menu, const QStringList& recent, const std::function<void()>& choose,
                       const std::function<void(const QString&)>& open,
                       const std::function<void()>& open_built_in) {
    menu.clear();
    QObject::connect(menu.addAction(ProfileMenus::tr("Choose a file...")), &QAction::triggered, choose);
    menu.addSeparator();
    for (const QString& path : recent) {
        QAction* const action = menu.addAction(QFileInfo{path}.fileName());
        action->setToolTip(path);
        QObject::connect(action, &QAction::triggered, [open, path] { open(path); });
    }
    if (!recent.isEmpty()) menu.addSeparator();
    QObject::connect(menu.addAction(ProfileMenus::tr("Built-in profile")), &QAction::triggered,
                     open_built_in);
}

void fill_backup_menu(QMenu& menu, const std::string& path,
                      const std::function<void(const std::string&)>& take) {
    menu.clear();
    for (int age = 0; age <= ProfileDraft::kOlderBackups; ++age) {
        const std::string backup =
            age == 0 ? ProfileDraft::backup_path(path) : ProfileDraft::older_backup_path(path, age);
        const QFileInfo file{QString::fromStdString(backup)};
        if (!file.exists()) continue;
        const QString time = file.lastModified().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
        QAction* const action = menu.addAction(QStringLiteral("%1  %2").arg(time, file.fileName()));
        QObject::connect(action, &QAction::triggered, [take, backup] { take(backup); });
    }
}

}  // namespace psicarve::ui
