// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/compare_tool.hpp"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QWidget>

#include <chrono>
#include <utility>

#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/differences_dialog.hpp"

namespace psicarve::ui {
namespace {

constexpr std::chrono::milliseconds kLook{50};

}  // namespace

CompareTool::CompareTool(session::MessageLog& log, std::function<QString()> folder, QMenu& menu,
                         QWidget* window)
    : QObject(window),
      window_(window),
      folder_(std::move(folder)),
      action_(menu.addAction(tr("Compare two snapshots…"))),
      compare_(log) {
    setObjectName("compare_tool");
    action_->setObjectName("compare_action");
    connect(action_, &QAction::triggered, this, [this] { choose(); });
    connect(&timer_, &QTimer::timeout, this, [this] { look(); });
}

/// Jobs are snapshots, too.
void CompareTool::choose() {
    const QString filter = tr("Snapshots and jobs (*.snap *.job *.psi);;All files (*)");
    const QString a = ask_for_file(window_, tr("First snapshot or job"),
                                   last_folder_.isEmpty() ? folder_() : last_folder_, filter);
    if (a.isEmpty()) return;
    last_folder_ = QFileInfo{a}.absolutePath();
    const QString b = ask_for_file(window_, tr("Second snapshot or job"), last_folder_, filter);
    if (!b.isEmpty()) compare(a.toStdString(), b.toStdString());
}

void CompareTool::compare(const std::string& path_a, const std::string& path_b) {
    compare_.compare(path_a, path_b);
    action_->setEnabled(false);
    timer_.start(kLook);
}

void CompareTool::look() {
    compare_.poll();
    if (compare_.is_comparing()) return;
    timer_.stop();
    action_->setEnabled(true);
    const auto done = compare_.take();
    if (!done) return;
    auto* differences = new DifferencesDialog{done, window_};
    differences->show();
}

}  // namespace psicarve::ui
