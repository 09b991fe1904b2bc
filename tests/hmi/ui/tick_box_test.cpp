// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/tick_box.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>

#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {
namespace {

class TickBoxIn : public ::testing::TestWithParam<Theme> {
protected:
    /// How many pixels of the box have that colour.
    int pixels_of(const QColor& colour) {
        const QImage image = sut_.grab().toImage();
        const QRect box = sut_.box();
        int count = 0;
        for (int y = box.top(); y <= box.bottom(); ++y)
            for (int x = box.left(); x <= box.right(); ++x)
                count += image.pixelColor(x, y).rgb() == colour.rgb() ? 1 : 0;
        return count;
    }
    const Tokens& tokens_ = tokens_of(GetParam());
    TickBox sut_{"Dry run"};
};

TEST_P(TickBoxIn, HasTheColoursOfItsTheme) {
    sut_.setStyleSheet(style_sheet(tokens_));
    const int all = sut_.box().width() * sut_.box().height();
    EXPECT_GT(pixels_of(tokens_.field), all / 2);
    sut_.setChecked(true);
    EXPECT_GT(pixels_of(tokens_.sel), all / 3);
    EXPECT_GT(pixels_of(tokens_.text), 10) << "the tick, and the edge";
    sut_.setEnabled(false);
    EXPECT_GT(pixels_of(tokens_.panel), all / 3);
}

INSTANTIATE_TEST_SUITE_P(Themes, TickBoxIn, ::testing::Values(Theme::light, Theme::dark),
                         [](const auto& named) { return named.param == Theme::light ? "light" : "dark"; });

}  // namespace
}  // namespace psicarve::ui
