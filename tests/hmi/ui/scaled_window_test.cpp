// SPDX-License-Identifier: GPL-3.0-or-later
// On a screen with more pixels than the window counts (QT_SCALE_FACTOR, from tests/hmi/ui/CMakeLists.txt):
// nothing is cut off.
#include <gtest/gtest.h>

#include <QTabWidget>

#include "tests/hmi/ui/fit_audit.hpp"
#include "tests/hmi/ui/window_rig.hpp"
#include "tests/places.hpp"

namespace psicarve::ui {
namespace {

class ScaledWindow : public test::WindowRig {
protected:
    double ratio() { return window_->devicePixelRatioF(); }
    void expect_fit(const QString& where) {
        for (int look = 0; look < 3; ++look) {
            window_->refresh();
            QApplication::processEvents();
        }
        for (const std::string& misfit : test::misfits(*window_))
            ADD_FAILURE() << where.toStdString() << ": " << misfit;
        take_picture(QString{"scaled_%1_%2"}.arg(qRound(100.0 * ratio())).arg(where));
    }
};

TEST_F(ScaledWindow, CutsNothingOff) {
    const double wanted = qEnvironmentVariable("QT_SCALE_FACTOR", "1").toDouble();
    start_core();
    open_window();
    ASSERT_DOUBLE_EQ(ratio(), wanted);
    window_->resize(wanted < 2.0 ? QSize{1280, 690} : QSize{960, 515});
    window_->open(QString::fromStdString(example("figurine.stl")));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    expect_fit("model");
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::lobed_job(40, 61)));
    auto& tabs = part<QTabWidget>("tabs");
    for (int i = 0; i < tabs.count(); ++i) {
        tabs.setCurrentIndex(i);
        expect_fit(QString::number(i + 1));
    }
    window_->set_theme(ThemeChoice::dark);
    tabs.setCurrentIndex(2);
    expect_fit("dark");
}

}  // namespace
}  // namespace psicarve::ui
