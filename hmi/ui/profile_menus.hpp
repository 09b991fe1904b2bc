// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <functional>
#include <string>

#include "hmi/session/file_presence.hpp"

class QMenu;

namespace psicarve::ui {

/// Other profiles: a file that is chosen, those that were opened last and are not known to be gone, the
/// built-in one.
void fill_profile_menu(QMenu& menu, const QStringList& recent, const session::FilePresence& presence,
                       const std::function<void()>& choose, const std::function<void(const QString&)>& open,
                       const std::function<void()>& open_built_in);

/// The states that a profile's file was in before, newest first, each with the time it was left at; `take`
/// gets the backup's path.
void fill_backup_menu(QMenu& menu, const std::string& path, const session::FilePresence& presence,
                      const std::function<void(const std::string&)>& take);

}  // namespace psicarve::ui
