// SPDX-License-Identifier: GPL-3.0-or-later
// As fit_test.cpp: what is open, filled in and listed.
#include "tests/hmi/ui/fit_rig.hpp"

namespace psicarve::ui {
namespace {

TEST_P(Fit, WithASlicedModel) {
    open_small();
    std::filesystem::copy_file(example("figurine.stl"), file(kLongName));
    window_->open(QString::fromStdString(file(kLongName)));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    expect_pages_and_panels_fit("sliced");
}

TEST_P(Fit, WithUnfinishedWork) {
    const QVariantMap left{{"host", QSysInfo::machineHostName()},
                           {"pid", 0},
                           {"start", "another start"},
                           {"path", QString::fromStdString(file(kLongName))},
                           {"sliced", true},
                           {"fields", QVariantMap{{"layers", 1200}, {"points", 2400}}}};
    test::KeptStore{}.store.set(WorkKeeper::kKey, QVariantMap{{"gone", left}});
    open_small();
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("unfinished_work").isVisible(); }));
    expect_fit("unfinished");
    ASSERT_TRUE(click("work_forget"));
}

TEST_P(Fit, WithADrawingAndAPicture) {
    open_small();
    open_example("flower.svg");
    expect_fit("drawing");
    QImage picture{64, 64, QImage::Format_Grayscale8};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) picture.setPixel(x, y, qRgb(4 * x, 4 * x, 4 * x));
    const QString path = QString::fromStdString(file("relief.png"));
    ASSERT_TRUE(picture.save(path));
    window_->open(path);
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("relief_gamma").isVisible(); }));
    expect_fit("picture");
}

TEST_P(Fit, WithAllPartsOfTheProfile) {
    open_on_screen();
    part<QTabWidget>("tabs").setCurrentIndex(6);
    auto& groups = part<QListWidget>("profile_groups");
    on_each_screen([&] {
        part<QLineEdit>("profile_find").clear();
        for (int i = 0; i < groups.count(); ++i) {
            groups.setCurrentRow(i);
            look_here("profile_" + QString::number(i));
        }
        button("profile_compare").click();
        look_here("profile_compared");
        button("profile_compare").click();
        part<QLineEdit>("profile_find").setText("_");  // every key, named with its table
        look_here("profile_found");
    });
}

TEST_P(Fit, WithKeysAndOutputsArmedAndAMeasurementShown) {
    open_small();
    ASSERT_TRUE(click("show_measurement"));
    part<QTabWidget>("tabs").setCurrentIndex(4);
    expect_fit("measurement");
    ASSERT_TRUE(click("check_computer"));
    expect_fit("computer");
    part<QTabWidget>("tabs").setCurrentIndex(3);
    // Whoever has a hand on something is let go of where the window is arranged anew.
    const QString to_arm_wiring = button("arm_wiring").text();
    on_each_screen([&] {
        settle();
        if (button("arm_wiring").text() == to_arm_wiring) {
            ASSERT_TRUE(click("arm_wiring"));
        }
        ASSERT_TRUE(comes_true([&] { return button("arm_wiring").text() != to_arm_wiring; }));
        look_here("wiring");
    });
    if (button("arm_wiring").text() != to_arm_wiring) {
        ASSERT_TRUE(click("arm_wiring"));
    }
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    const QString to_arm_keys = button("arm_keys").text();
    on_each_screen([&] {
        settle();
        if (button("arm_keys").text() == to_arm_keys) {
            ASSERT_TRUE(click("arm_keys"));
        }
        ASSERT_TRUE(comes_true([&] { return button("arm_keys").text() != to_arm_keys; }));
        look_at_panels_here("armed");
        look_here("armed");
    });
}

TEST_P(Fit, InTheListOfKeys) {
    open_on_screen();
    on_each_screen([&] {
        QApplication::processEvents();
        KeysDialog sut{window_.get()};
        sut.show();
        QApplication::processEvents();
        EXPECT_LE(sut.width(), size().width());
        EXPECT_LE(sut.height(), size().height());
        for (const std::string& misfit : test::misfits(sut))
            ADD_FAILURE() << size().width() << ": " << misfit;
        test::keep_picture(sut, QString{"fit_%1_%2_keys"}.arg(code(), QString::number(size().width())));
    });
    const KeysDialog sut{window_.get()};
    const auto words_of = [&sut](const char* list) {
        QStringList all;
        for (const QLabel* label : sut.findChild<QWidget*>(list)->findChildren<QLabel*>())
            all += label->text();
        return all;
    };
    EXPECT_EQ(words_of("keys_always").size(), 2 * 15);
    const QString jog = words_of("keys_jog").join(' ');
    for (const char* key : {"PgUp", "PgDn", "Ctrl", "Shift", "Ψ", "R1", "R2"})
        EXPECT_TRUE(jog.contains(QString::fromUtf8(key))) << key;
}

}  // namespace
}  // namespace psicarve::ui
