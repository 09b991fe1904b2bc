// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/escape_key.hpp"

#include <gtest/gtest.h>

namespace psicarve::session {
namespace {

using S = MachineState;

MachineView sight_in(S state) {
    MachineView view;
    view.life = CoreLife::alive;
    view.status.emplace();
    view.status->state = state;
    return view;
}

TEST(EscapeOrder, HoldsWhatIsCarvedAndEndsOnlyWhatCannotBeHeld) {
    for (std::uint8_t number = 0; number < kMachineStateCount; ++number) {
        const auto state = static_cast<S>(number);
        const EscapeOrder order = escape_order(sight_in(state), false);
        if (state == S::carving) {
            EXPECT_EQ(order, EscapeOrder::hold);
        } else if (is_at_rest(state) || state == S::holding || state == S::stopping) {
            EXPECT_EQ(order, EscapeOrder::none) << name_of(state);
        } else {
            EXPECT_EQ(order, EscapeOrder::stop) << name_of(state);
        }
    }
}

TEST(EscapeOrder, HoldsAStartThatHasComeToTheFirstPoint) {
    EXPECT_EQ(escape_order(sight_in(S::waiting), true), EscapeOrder::hold);
    EXPECT_EQ(escape_order(sight_in(S::held), true), EscapeOrder::none);
    EXPECT_EQ(escape_order(sight_in(S::off), true), EscapeOrder::none);
}

TEST(EscapeOrder, IsNoneWithoutACoreThatIsHeard) {
    for (const CoreLife life : {CoreLife::none, CoreLife::silent}) {
        MachineView view = sight_in(S::carving);
        view.life = life;
        EXPECT_EQ(escape_order(view, false), EscapeOrder::none);
    }
    EXPECT_EQ(escape_order({}, true), EscapeOrder::none);
}

}  // namespace
}  // namespace psicarve::session
