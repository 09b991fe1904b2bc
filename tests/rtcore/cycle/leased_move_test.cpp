// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/leased_move.hpp"

#include <gtest/gtest.h>

#include "shared/machine/jog_lease_word.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::uint32_t kHand = 77;

Request leased_by(std::uint32_t token) {
    Request request{};
    request.lease_token = token;
    request.lease_ticks = 100;
    return request;
}

TEST(LeasedMove, GoesOnWhileItsLeaseIsRenewed) {
    LeasedMove sut;
    sut.begin(leased_by(kHand), jog_lease_word(kHand, 1), 1000);
    EXPECT_TRUE(sut.has_lease());
    EXPECT_TRUE(sut.is_of(kHand));
    EXPECT_FALSE(sut.is_of(kHand + 1));
    EXPECT_EQ(sut.due_end(jog_lease_word(kHand, 1), 1099), MoveEnd::none);
    EXPECT_EQ(sut.due_end(jog_lease_word(kHand, 2), 1099), MoveEnd::none);
    EXPECT_EQ(sut.due_end(jog_lease_word(kHand, 2), 1198), MoveEnd::none);
    EXPECT_EQ(sut.due_end(jog_lease_word(kHand, 2), 1199), MoveEnd::lease_gone);
    EXPECT_EQ(sut.due_end(jog_lease_word(kHand, 0), 1150), MoveEnd::released);
}

TEST(LeasedMove, NeedsNoLeaseWithoutAToken) {
    LeasedMove sut;
    sut.begin(leased_by(0), 0, 1000);
    EXPECT_FALSE(sut.has_lease());
}

TEST(LeasedMove, RemembersHowItEndedUntilTheNextBegins) {
    LeasedMove sut;
    sut.begin(leased_by(kHand), 0, 1000);
    EXPECT_EQ(sut.ended(), MoveEnd::none);
    sut.end(MoveEnd::released);
    EXPECT_FALSE(sut.has_lease());
    EXPECT_EQ(sut.ended(), MoveEnd::released);
    sut.begin(leased_by(kHand), 0, 2000);
    EXPECT_EQ(sut.ended(), MoveEnd::none);
}

TEST(LeasedMove, KeepsItsEndWhenOnlyItsLeaseIsForgotten) {
    LeasedMove sut;
    sut.begin(leased_by(kHand), 0, 1000);
    sut.forget_lease();
    EXPECT_FALSE(sut.has_lease());
    sut.end(MoveEnd::reached);
    sut.forget_lease();
    EXPECT_EQ(sut.ended(), MoveEnd::reached);
}

}  // namespace
}  // namespace psicarve::cycle
