// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/refusal_message.hpp"

#include <gtest/gtest.h>

#include "shared/wording/wording.hpp"

namespace psicarve::supervisor {
namespace {

// The answer is put into words a moment after the tick has refused: the switch may be open by then.
TEST(RefusalMessage, NamesTheSwitchesThatAreStillTrippedOrSaysThatNoneIs) {
    cycle::Report answer{};
    answer.refusal = cycle::Refusal::still_tripped;
    cycle::Sample sample{};
    const auto said = [&] {
        return in_words(refusal_message(answer, CommandKind::reset_alarm, sample, Profile{}, {}));
    };
    EXPECT_EQ(said(), "a switch was tripped until just now; try again");
    sample.signals = bit_of(Signal::r2_limit);
    EXPECT_EQ(said(), "still tripped: r2_limit; release it or back off");
}

TEST(RefusalMessage, SaysThatAStopCameAfterTheCommand) {
    cycle::Report answer{};
    answer.refusal = cycle::Refusal::overtaken;
    EXPECT_EQ(in_words(refusal_message(answer, CommandKind::reset_alarm, {}, Profile{}, {})),
              "reset-alarm: a stop came after it; ask again");
}

}  // namespace
}  // namespace psicarve::supervisor
