// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/layer_cursor.hpp"

#include <gtest/gtest.h>

namespace psicarve::session {
namespace {

class LayerCursorTest : public ::testing::Test {
protected:
    LayerCursorTest() { sut_.begin(100, 50); }
    LayerCursor sut_;
};

TEST_F(LayerCursorTest, FollowsTheMachineUntilSomethingIsChosen) {
    sut_.note_machine(TablePlace{7, 3});
    EXPECT_EQ(sut_.place(), (TablePlace{7, 3}));
    sut_.choose_point(20);
    sut_.note_machine(TablePlace{8, 4});
    EXPECT_EQ(sut_.place(), (TablePlace{7, 20}));
    EXPECT_FALSE(sut_.follows());
    sut_.follow(true);
    sut_.note_machine(TablePlace{9, 5});
    EXPECT_EQ(sut_.place(), (TablePlace{9, 5}));
    sut_.choose_layer(30);
    sut_.note_machine(TablePlace{10, 6});
    EXPECT_EQ(sut_.place(), (TablePlace{30, 5}));
}

TEST_F(LayerCursorTest, FollowsTheNextRunWhateverWasChosenBefore) {
    sut_.choose_layer(60);
    EXPECT_TRUE(sut_.follows()) << "there is nothing to follow yet";
    sut_.note_machine(TablePlace{0, 1});
    sut_.choose_layer(60);
    sut_.note_machine({});
    EXPECT_EQ(sut_.place().layer, 60U) << "what was chosen stays in sight";
    sut_.note_machine(TablePlace{1, 2});
    EXPECT_EQ(sut_.place(), (TablePlace{1, 2}));
}

TEST_F(LayerCursorTest, StaysWithinTheJob) {
    sut_.choose_layer(99);
    sut_.choose_point(49);
    sut_.begin(10, 5);
    EXPECT_EQ(sut_.place(), (TablePlace{9, 4}));
    sut_.choose_layer(10);
    sut_.note_machine(TablePlace{12, 70});
    EXPECT_EQ(sut_.place(), (TablePlace{9, 4}));
}

}  // namespace
}  // namespace psicarve::session
