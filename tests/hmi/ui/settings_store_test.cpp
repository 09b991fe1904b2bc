// SPDX-License-Identifier: GPL-3.0-or-later
// Settings on a disk that takes its time: nobody waits for it, and nothing is lost by it.
#include <gtest/gtest.h>

#include <QAbstractSlider>
#include <QButtonGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <future>

#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

using std::chrono::milliseconds;

/// A file whose disk sleeps until it is woken.
class SleepingFile {
public:
    explicit SleepingFile(QVariantMap values = {}) : values_(std::move(values)) {}
    ~SleepingFile() { wake(); }
    void wake() {
        if (!is_awake_.exchange(true)) woken_.set_value();
    }
    SettingsFile file() {
        const auto awake = awake_;
        return {"sleeping.ini",
                [this, awake] {
                    awake.wait();
                    return values_;
                },
                [this, awake](const std::vector<SettingsChange>& changes) -> Result<void> {
                    awake.wait();
                    ++writes_;
                    for (const SettingsChange& change : changes) {
                        const QVariant made = change.make(values_.value(change.key));
                        values_[change.key] = made;
                        if (!made.isValid()) values_.remove(change.key);
                    }
                    return {};
                }};
    }
    /// Once the store is gone.
    const QVariantMap& values() const { return values_; }
    int writes() const { return writes_; }

private:
    std::promise<void> woken_;
    std::shared_future<void> awake_ = woken_.get_future().share();
    std::atomic<bool> is_awake_{false};
    QVariantMap values_;
    std::atomic<int> writes_{0};
};

TEST(SettingsOnASleepingDisk, AreNotWaitedForAndAllWrittenInTheEnd) {
    SleepingFile file;
    {
        SettingsStore sut{file.file()};
        EXPECT_FALSE(sut.await_read(milliseconds{1}));
        for (int i = 0; i < 100; ++i) {
            sut.set("window/page", i);
            sut.poll();
            EXPECT_EQ(sut.value("window/page").toInt(), i) << "holds at once";
        }
        EXPECT_LE(sut.saves().under_way().size(), 2U) << "one of all of them would do";
        file.wake();
    }
    EXPECT_EQ(file.values().value("window/page").toInt(), 99);
    EXPECT_LE(file.writes(), 3);
}

TEST(SettingsOnASleepingDisk, ThatComeLateKeepWhatWasChangedSince) {
    SleepingFile file{
        {{"window/theme", "dark"}, {"window/page", "ports"}, {"files/recent", QStringList{"/old"}}}};
    {
        SettingsStore sut{file.file()};
        bool is_told = false;
        sut.set_on_read([&] { is_told = true; });
        sut.set("window/page", "model");
        WindowSettings{sut}.add_recent_file("/new");
        sut.poll();
        EXPECT_FALSE(is_told);
        file.wake();
        ASSERT_TRUE(sut.await_read(two_process::kLimit));
        EXPECT_EQ(sut.value("window/theme").toString(), "dark");
        EXPECT_EQ(sut.value("window/page").toString(), "model");
        EXPECT_EQ(WindowSettings{sut}.recent_files(), (QStringList{"/new", "/old"}));
    }
    EXPECT_EQ(file.values().value("window/page").toString(), "model");
    EXPECT_EQ(file.values().value("files/recent").toStringList(), (QStringList{"/new", "/old"}));
}

class SettingsInTheirFile : public test::WindowRig {};

TEST_F(SettingsInTheirFile, OfTwoWindowsDoNotForgetEachOthersFiles) {
    const auto one = kept_settings();
    const auto two = kept_settings();
    WindowSettings{*one}.add_recent_file("/one");
    one->poll();
    ASSERT_TRUE(eventually([&] { return test::KeptSettings{}.recent_files() == QStringList{"/one"}; }));
    WindowSettings{*two}.add_recent_file("/two");
    two->poll();
    EXPECT_TRUE(eventually([&] {
        return test::KeptSettings{}.recent_files() == (QStringList{"/two", "/one"});
    }));
}

TEST_F(SettingsInTheirFile, ThatCannotBeWrittenAreNotTakenForKept) {
    const SettingsChange change{"window/page", [](const QVariant&) { return QVariant{"ports"}; }};
    EXPECT_TRUE(settings_file().write({change}));
    std::filesystem::remove_all(this->file("settings"));
    std::ofstream{this->file("settings")} << "a file, no folder";
    const auto written = settings_file().write({change});
    ASSERT_FALSE(written);
    EXPECT_TRUE(written.error().message.ends_with("/psicarve-hmi.ini: cannot be written"))
        << written.error().message;
}

TEST_F(SettingsInTheirFile, ThatCannotBeWrittenAreToldOfOnce) {
    std::atomic<int> writes{0};
    const SettingsFile full{"full.ini", [] { return QVariantMap{}; },
                            [&](const std::vector<SettingsChange>&) -> Result<void> {
                                ++writes;
                                return Error{ErrorCode::out_of_room, "/full.ini: cannot be written"};
                            }};
    window_ = std::make_unique<MainWindow>(session::SessionOptions{segment_name_, {}, {}}, Drawing::painter,
                                           std::make_unique<SettingsStore>(full));
    const char* const words = "Settings are not kept: /full.ini: cannot be written";
    window_->set_theme(ThemeChoice::dark);
    ASSERT_TRUE(comes_true([&] { return all_messages().contains(words); }));
    const int before = writes;
    window_->set_theme(ThemeChoice::light);
    ASSERT_TRUE(comes_true([&] { return writes > before && window_->context().saves.under_way().empty(); }));
    window_->refresh();
    EXPECT_EQ(all_messages().count(words), 1) << all_messages().toStdString();
    window_.reset();
}

class WindowOnASleepingDisk : public test::WindowRig {
protected:
    void open_on(SleepingFile& file) {
        window_ =
            std::make_unique<MainWindow>(session::SessionOptions{segment_name_, {}, {}}, Drawing::painter,
                                         std::make_unique<SettingsStore>(file.file()));
        window_->show();
        window_->begin_with({}, {});
    }
    QTabWidget& tabs() { return part<QTabWidget>("tabs"); }
    double number(const char* name) { return part<QDoubleSpinBox>(name).value(); }
    /// Fields have taken what came late.
    ::testing::AssertionResult wakes(SleepingFile& file) {
        file.wake();
        if (comes_true([&] { return part<QSpinBox>("layers").value() == kLateLayers; }))
            return ::testing::AssertionSuccess();
        return ::testing::AssertionFailure() << "layers " << part<QSpinBox>("layers").value();
    }
    void close() {
        window_->leave();
        window_.reset();
    }

    static constexpr int kLateLayers = 321;
};

TEST_F(WindowOnASleepingDisk, IsThereAtOnceAndTakesItsPlaceAndThemeLater) {
    open_window();
    window_->resize(1190, 701);
    const QByteArray place = window_->saveGeometry();
    SleepingFile file{{{"window/theme", "dark"},
                       {"window/page", "ports"},
                       {"window/geometry", place},
                       {"window/floats_jog", true},
                       {"files/recent", QStringList{QString::fromStdString(this->file("run.job"))}}}};
    open_on(file);
    EXPECT_TRUE(window_->isVisible());
    EXPECT_EQ(tabs().currentIndex(), 0);
    for (int look = 0; look < 30; ++look) {
        QApplication::processEvents();
        window_->refresh();
    }
    file.wake();
    ASSERT_TRUE(comes_true([&] { return tabs().currentIndex() == 3; }));
    EXPECT_EQ(window_->styleSheet(), style_sheet(tokens_of(Theme::dark)));
    EXPECT_EQ(window_->size(), QSize(1190, 701));
    EXPECT_TRUE(window_->findChild<QMenu*>("panels")->actions()[1]->isChecked());
    window_.reset();
    EXPECT_EQ(file.values().value("window/page").toString(), "ports");
}

/// What somebody aims at stays where it is.
TEST_F(WindowOnASleepingDisk, MovesNothingBelowAHandThatHasClicked) {
    open_window();
    window_->resize(1190, 701);
    SleepingFile file{{{"window/theme", "dark"},
                       {"window/page", "ports"},
                       {"window/geometry", window_->saveGeometry()},
                       {"window/floats_jog", true},
                       {"options/layers", kLateLayers}}};
    open_on(file);
    const QSize size = window_->size();
    ASSERT_NE(size, QSize(1190, 701));
    QTest::mouseClick(&part<QWidget>("strip"), Qt::LeftButton);
    ASSERT_TRUE(wakes(file));
    EXPECT_EQ(window_->styleSheet(), style_sheet(tokens_of(Theme::dark)));
    EXPECT_EQ(window_->size(), size);
    EXPECT_EQ(tabs().currentIndex(), 0);
    EXPECT_FALSE(window_->findChild<QMenu*>("panels")->actions()[1]->isChecked());
    close();
    EXPECT_EQ(file.values().value("window/page").toString(), "model") << "it was looked at";
    EXPECT_TRUE(file.values().value("window/floats_jog").toBool()) << "the next time";
}

/// A title bar is the desktop's: of its clicks nothing comes to the window, but it moves and moves.
TEST_F(WindowOnASleepingDisk, StaysWhereItIsBeingDrawnTo) {
    open_window();
    window_->resize(1190, 701);
    SleepingFile file{{{"window/page", "ports"},
                       {"window/geometry", window_->saveGeometry()},
                       {"options/layers", kLateLayers}}};
    open_on(file);
    QPoint at = window_->pos();
    for (int step = 0; step < 12; ++step) {
        window_->move(at += QPoint{3, 2});
        QApplication::processEvents();
    }
    const QSize size = window_->size();
    ASSERT_NE(size, QSize(1190, 701));
    ASSERT_TRUE(wakes(file));
    EXPECT_EQ(window_->pos(), at);
    EXPECT_EQ(window_->size(), size);
    EXPECT_EQ(tabs().currentIndex(), 0);
}

TEST_F(WindowOnASleepingDisk, LeavesThePlaceThatNobodyHasSeen) {
    SleepingFile file{{{"window/geometry", QByteArray{"a place"}}, {"window/page", "ports"}}};
    open_on(file);
    window_->set_theme(ThemeChoice::dark);
    part<QSpinBox>("points").setValue(77);
    window_->leave();
    ASSERT_TRUE(eventually([&] { return window_->context().saves.under_way().size() == 1; }));
    EXPECT_EQ(window_->context().saves.under_way()[0].path, "sleeping.ini")
        << "whoever ends the program knows";
    file.wake();
    window_.reset();
    EXPECT_EQ(file.values().value("window/theme").toString(), "dark");
    EXPECT_EQ(file.values().value("window/geometry").toByteArray(), "a place");
    EXPECT_EQ(file.values().value("window/page").toString(), "ports");
    EXPECT_EQ(file.values().value("options/points").toInt(), 77) << "somebody has chosen that";
}

TEST_F(WindowOnASleepingDisk, FillsInFieldsThatFillInEachOther) {
    SleepingFile file{{{"options/layers", kLateLayers},
                       {"options/roughing", "1"},
                       {"options/stepdown", 2.5},
                       {"options/allowance", 0.75},
                       {"options/stepover", 1.5}}};
    open_on(file);
    ASSERT_TRUE(wakes(file));
    EXPECT_EQ(part<QComboBox>("roughing").currentIndex(), 1);
    EXPECT_DOUBLE_EQ(number("stepdown"), 2.5);
    EXPECT_DOUBLE_EQ(number("allowance"), 0.75);
    EXPECT_DOUBLE_EQ(number("stepover"), 1.5);
    close();
    EXPECT_EQ(file.values().value("options/roughing").toString(), "1");
    EXPECT_DOUBLE_EQ(file.values().value("options/stepdown").toDouble(), 2.5);
    EXPECT_DOUBLE_EQ(file.values().value("options/allowance").toDouble(), 0.75);
    EXPECT_DOUBLE_EQ(file.values().value("options/stepover").toDouble(), 1.5);
}

TEST_F(WindowOnASleepingDisk, LeavesWhatWasTypedMeanwhile) {
    SleepingFile file{{{"options/layers", kLateLayers},
                       {"options/roughing", "1"},
                       {"options/stepdown", 2.5},
                       {"options/allowance", 0.75}}};
    open_on(file);
    part<QDoubleSpinBox>("stepdown").setValue(4.0);
    ASSERT_TRUE(wakes(file));
    EXPECT_EQ(part<QComboBox>("roughing").currentIndex(), 1);
    EXPECT_DOUBLE_EQ(number("stepdown"), 4.0);
    EXPECT_DOUBLE_EQ(number("allowance"), 0.75);
    close();
    EXPECT_DOUBLE_EQ(file.values().value("options/stepdown").toDouble(), 4.0);
    EXPECT_DOUBLE_EQ(file.values().value("options/allowance").toDouble(), 0.75);
}

/// A key may be pressed, and a test be about to begin.
TEST_F(WindowOnASleepingDisk, ChangesNothingLateThatDrivesTheMachine) {
    const QVariantMap kept{{"options/layers", kLateLayers},     {"options/jog_linear_step", 1'000},
                           {"options/jog_angular_step", 9'000}, {"options/jog_linear_speed", 33},
                           {"options/jog_angular_speed", 22},   {"options/test_rate", 20},
                           {"options/test_pulses", 20}};
    SleepingFile file{kept};
    open_on(file);
    const auto values = [&] {
        return std::vector<int>{part<QButtonGroup>("jog_linear_step").checkedId(),
                                part<QButtonGroup>("jog_angular_step").checkedId(),
                                part<QAbstractSlider>("jog_linear_speed").value(),
                                part<QAbstractSlider>("jog_angular_speed").value(),
                                part<QSpinBox>("test_rate").value(),
                                part<QSpinBox>("test_pulses").value()};
    };
    const auto usual = values();
    ASSERT_TRUE(wakes(file));
    EXPECT_EQ(values(), usual);
    close();
    for (const auto& [key, value] : kept.asKeyValueRange()) {
        EXPECT_EQ(file.values().value(key), value) << key.toStdString();
    }
}

}  // namespace
}  // namespace psicarve::ui
