// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QString>

#include <memory>

#include "hmi/ui/main_window.hpp"
#include "hmi/ui/settings.hpp"
#include "hmi/ui/settings_store.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::ui::test {

struct KeptStore {
    KeptStore() { store.await_read(two_process::kLimit); }
    SettingsStore store;
};
/// As the file has them; what is changed is in it when this goes.
class KeptSettings : private KeptStore, public WindowSettings {
public:
    KeptSettings() : WindowSettings(store) {}
};

/// Draws a widget, and keeps the picture in the build folder, to be looked at, where PSICARVE_PICTURES asks
/// for it or the test has failed: to write one takes longer than most of what a test does.
void keep_picture(QWidget& widget, const QString& name);

/// A window on a segment of its own, without a screen, with settings of its own.
class WindowRig : public two_process::CoreRig {
protected:
    WindowRig();
    ~WindowRig() override;

    /// $PSICARVE_STATE is file(""), for as long as there is a window, which looks there again and again.
    /// Before one is opened.
    void keep_state_in_own_folder();
    /// Its settings are read.
    void open_window();
    static std::unique_ptr<SettingsStore> kept_settings();
    /// The events of a running window, until the condition holds.
    template <typename Condition>
    bool comes_true(Condition condition, two_process::milliseconds limit = two_process::kLimit) {
        return eventually(
            [&] {
                QApplication::processEvents();
                window_->refresh();
                return condition();
            },
            limit);
    }
    ::testing::AssertionResult comes_to(MachineState state);
    ::testing::AssertionResult comes_to(session::OpenJobState state);
    QAbstractButton& button(const char* name);
    /// Waits until it can be pressed, presses it, by the mouse where it is seen, and says why it could not
    /// be.
    ::testing::AssertionResult click(const char* name);
    /// The same, where that asks something that another button answers.
    ::testing::AssertionResult click_and_answer(const char* name, const char* answer);
    QString all_messages() const;
    const session::MachineView& machine_view() { return window_->context().machine.view(); }
    /// A widget of the window or of its dialogs.
    template <typename T>
    T& part(const char* name) {
        auto* const found = window_->findChild<T*>(name);
        if (found == nullptr) throw std::runtime_error{std::string{"no "} + name};
        return *found;
    }
    /// From a file, by the window's own way.
    void publish_job(const JobTable& table);
    /// Publishes it, homes, starts.
    void carve_job(const JobTable& table);
    /// keep_picture() of the window.
    void take_picture(const QString& name);

    std::unique_ptr<MainWindow> window_;

private:
    bool keeps_state_ = false;
};

}  // namespace psicarve::ui::test
