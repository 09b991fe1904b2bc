// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/ui/hands_rig.hpp"

#include <QAction>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QTest>
#include <QTimer>

#include "hmi/ui/dialogs.hpp"

namespace psicarve::ui::test {

void HandsRig::open_in_front() {
    open_window();
    bring_to_front();
}

/// There is nobody who does when a dialog goes.
void HandsRig::bring_to_front() {
    window_->activateWindow();
    ASSERT_TRUE(comes_true([&] { return window_->isActiveWindow(); }));
}

void HandsRig::press_key(Qt::Key key, Qt::KeyboardModifiers with) {
    bring_to_front();
    QWidget* const focus = QApplication::focusWidget();
    QTest::keyClick(focus != nullptr ? focus : window_.get(), key, with);
}

QAction& HandsRig::entry(const char* name) {
    auto* const found = window_->findChild<QAction*>(name);
    if (found == nullptr) throw std::runtime_error{std::string{"no entry "} + name};
    return *found;
}

::testing::AssertionResult HandsRig::choose_entry(const char* name) {
    window_->refresh();
    QAction& action = entry(name);
    if (!action.isEnabled()) return ::testing::AssertionFailure() << name << " is locked";
    QMenu* menu = nullptr;
    for (QObject* each : action.associatedObjects()) {
        if (auto* const found = qobject_cast<QMenu*>(each)) menu = found;
    }
    if (menu == nullptr) return ::testing::AssertionFailure() << name << " is in no menu";
    menu->popup(window_->mapToGlobal(QPoint{20, 60}));
    if (!comes_true([&] { return menu->isVisible(); }))
        return ::testing::AssertionFailure() << name << ": its menu does not open";
    QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(&action).center());
    return ::testing::AssertionSuccess();
}

bool HandsRig::answered(const std::function<void()>& open, const std::vector<Answer>& answers) {
    std::size_t given = 0;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, window_.get(), [&] {
        QDialog* const dialog = open_dialog();
        if (dialog == nullptr || !dialog->isVisible() || given == answers.size()) return;
        answers[given++](*dialog);
        if (open_dialog() == dialog && dialog->isVisible()) dialog->reject();  // it would be waited for
    });
    look.start(0);
    open();
    return given == answers.size();
}

bool HandsRig::named_files(const std::function<void()>& open, const std::vector<std::string>& paths) {
    std::vector<Answer> answers;
    for (const std::string& path : paths) {
        answers.push_back([path](QDialog& dialog) {
            if (path.empty()) return dialog.reject();
            auto* const name = dialog.findChild<QLineEdit*>("fileNameEdit");
            ASSERT_NE(name, nullptr);
            name->setText(QString::fromStdString(path));
            dialog.accept();
        });
    }
    return answered(open, answers);
}

}  // namespace psicarve::ui::test
