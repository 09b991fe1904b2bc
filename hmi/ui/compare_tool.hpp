// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <QTimer>

#include <functional>

#include "hmi/session/snapshot_compare.hpp"

class QAction;
class QMenu;
class QWidget;

namespace psicarve::ui {

/// The menu entry that compares two snapshots or jobs, and shows what came of it.
class CompareTool : public QObject {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::CompareTool)
public:
    /// Files are first looked for in what `folder` says then. The window owns it.
    CompareTool(session::MessageLog& log, std::function<QString()> folder, QMenu& menu, QWidget* window);

    bool is_comparing() const noexcept { return compare_.is_comparing(); }
    void compare(const std::string& path_a, const std::string& path_b);

private:
    void choose();
    void look();

    QWidget* window_;
    std::function<QString()> folder_;
    QString last_folder_;  ///< empty: none was chosen yet
    QAction* action_;
    QTimer timer_;
    session::SnapshotCompare compare_;
};

}  // namespace psicarve::ui
