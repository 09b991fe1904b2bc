// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/ui/window_rig.hpp"

#include <QDir>
#include <QPixmap>
#include <QSettings>
#include <QTest>
#include <QTimer>

#include "hmi/ui/words.hpp"
#include "tests/hmi/ui/press_log.hpp"
#include "tests/hmi/ui/press_table.hpp"
#include "tests/places.hpp"

namespace psicarve::ui::test {
namespace {

/// One application for all tests of the program, as Qt wants it.
class ApplicationEnvironment : public ::testing::Environment {
public:
    void SetUp() override {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application_ = std::make_unique<QApplication>(argument_count_, arguments_);
        QApplication::setStyle("Fusion");
    }
    void TearDown() override { application_.reset(); }

private:
    int argument_count_ = 1;
    char name_[8] = "hmi";
    char* arguments_[2] = {name_, nullptr};
    std::unique_ptr<QApplication> application_;
};
[[maybe_unused]] const auto* const kEnvironment =
    ::testing::AddGlobalTestEnvironment(new ApplicationEnvironment);  // GoogleTest owns it

}  // namespace

WindowRig::WindowRig() {
    qputenv("XDG_STATE_HOME", QByteArray::fromStdString(file("state")));
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, QString::fromStdString(file("settings")));
    PressLog::instance().forget();
}

WindowRig::~WindowRig() {
    if (!HasFailure()) expect_pressed_as_in_table(PressLog::instance());
    window_.reset();  // its threads read the environment
    if (keeps_state_) setenv("PSICARVE_STATE", "", 1);
    use_language(Language::english);  // a window may have chosen another one
}

void WindowRig::keep_state_in_own_folder() {
    setenv("PSICARVE_STATE", file("").c_str(), 1);
    keeps_state_ = true;
}

std::unique_ptr<SettingsStore> WindowRig::kept_settings() {
    auto settings = std::make_unique<SettingsStore>();
    settings->await_read(two_process::kLimit);
    return settings;
}

void WindowRig::open_window() {
    window_.reset();
    session::SessionOptions options{segment_name_, {}, {}};
    options.hand_limit = kLongestJogLease;  // however slow a sanitizer on a busy computer
    KeptSettings{}.set_theme(ThemeChoice::light);
    window_ = std::make_unique<MainWindow>(options, Drawing::painter, kept_settings());
    PressLog::instance().hear_first();
    window_->resize(1280, 720);  // the platform's screen is smaller
    window_->show();
}

::testing::AssertionResult WindowRig::comes_to(MachineState state) {
    const auto& view = window_->context().machine.view();
    if (comes_true([&] { return view.is_heard() && view.state() == state; }))
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "state is " << name_of(view.state()) << all_messages().toStdString();
}

::testing::AssertionResult WindowRig::comes_to(session::OpenJobState state) {
    if (comes_true([&] { return window_->context().open_job.view().state == state; }))
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "desk: " << static_cast<int>(window_->context().open_job.view().state)
           << all_messages().toStdString();
}

QAbstractButton& WindowRig::button(const char* name) {
    auto* const found = window_->findChild<QAbstractButton*>(name);
    if (found == nullptr) throw std::runtime_error{std::string{"no button "} + name};
    return *found;
}

::testing::AssertionResult WindowRig::click(const char* name) {
    if (!comes_true([&] { return button(name).isEnabled(); }))
        return ::testing::AssertionFailure() << name << ": " << button(name).toolTip().toStdString();
    QAbstractButton& wanted = button(name);
    const QPoint at = wanted.rect().center();
    // Pages that are not shown have no mouse on them.
    if (!wanted.isVisible() || !wanted.visibleRegion().contains(at)) {
        wanted.click();
        return ::testing::AssertionSuccess();
    }
    QWidget* const under = wanted.window()->childAt(wanted.mapTo(wanted.window(), at));
    const bool is_hit = under == &wanted || wanted.isAncestorOf(under);
    if (!is_hit) return ::testing::AssertionFailure() << name << " lies under something";
    QTest::mouseClick(&wanted, Qt::LeftButton, Qt::NoModifier, at);
    return ::testing::AssertionSuccess();
}

::testing::AssertionResult WindowRig::click_and_answer(const char* name, const char* answer) {
    bool is_answered = false;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, window_.get(), [&] {
        auto* const found = window_->findChild<QAbstractButton*>(answer);
        if (found == nullptr || !found->isVisible()) return;
        is_answered = true;
        found->click();
    });
    look.start(0);
    if (auto clicked = click(name); !clicked) return clicked;
    if (is_answered) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << name << " has not asked";
}

QString WindowRig::all_messages() const {
    QString text;
    for (const session::Message& message : window_->context().log.messages())
        text += "\n  " + words(message.what);
    return text;
}

void WindowRig::publish_job(const JobTable& table) {
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(table);
    ASSERT_TRUE(save_snapshot(snapshot, file("run.job")));
    window_->open(QString::fromStdString(file("run.job")));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    window_->context().open_job.publish();
    ASSERT_TRUE(comes_to(session::OpenJobState::published));
}

void WindowRig::carve_job(const JobTable& table) {
    publish_job(table);
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(MachineState::carving));
}

void WindowRig::take_picture(const QString& name) {
    // What was written anew takes its room with the second look.
    for (int look = 0; look < 2; ++look) QApplication::processEvents();
    keep_picture(*window_, name);
}

void keep_picture(QWidget& widget, const QString& name) {
    const QPixmap picture = widget.grab();  // drawn in every run
    if (!qEnvironmentVariableIsSet("PSICARVE_PICTURES") && !::testing::Test::HasFailure()) return;
    const QString folder = QString::fromStdString(in_build("screenshots"));
    QDir{}.mkpath(folder);
    picture.save(folder + "/" + name + ".png");
}

}  // namespace psicarve::ui::test
