// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/connector_view.hpp"

#include <gtest/gtest.h>

#include <QImage>

#include "hmi/profile/pin_rows.hpp"
#include "tests/hmi/ui/window_rig.hpp"

namespace psicarve::ui {
namespace {

class Connector : public test::WindowRig {
protected:
    Connector() {
        sut_.resize(700, sut_.height());
        sut_.set_theme(tokens_of(Theme::light));
        sut_.show_rows(session::pin_rows(Profile{}));
    }
    int alarm_pixels() {
        const QImage picture = sut_.grab().toImage();
        const QRgb alarm = tokens_of(Theme::light).alarm.rgb();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) count += picture.pixel(x, y) == alarm ? 1 : 0;
        }
        return count;
    }
    ConnectorView sut_;
};

TEST_F(Connector, RingsThePinOfASwitchThatStopsTheMachine) {
    EXPECT_EQ(alarm_pixels(), 0);
    sut_.show_levels(bit_of(Signal::psi_index) | bit_of(Signal::spindle));
    EXPECT_EQ(alarm_pixels(), 0) << "the index stops nothing";
    sut_.show_levels(bit_of(Signal::r2_limit));
    const int one = alarm_pixels();
    EXPECT_GT(one, 50);
    test::keep_picture(sut_, "connector_light");
    sut_.show_levels(bit_of(Signal::r2_limit) | bit_of(Signal::y_limit));
    EXPECT_GT(alarm_pixels(), one + 50);
}

}  // namespace
}  // namespace psicarve::ui
