// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace psicarve {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kJob = 0x1234;

std::string refusal(const std::optional<Checkpoint>& sut, std::uint64_t job = kJob,
                    std::uint32_t layers = 10) {
    const auto layer = layer_to_resume(sut, job, layers);
    return layer ? std::to_string(*layer) : layer.error().message;
}

TEST(Checkpoint, NamesTheLayerToGoOnWith) {
    EXPECT_EQ(refusal(checkpoint_at(kJob, 1, 10)), "1");
    EXPECT_EQ(refusal(checkpoint_at(kJob, 9, 10)), "9");
    EXPECT_EQ(refusal(checkpoint_at(kJob, 2, 10, 7)), "2") << "it may be another piece";
}

TEST(Checkpoint, SaysWhyThereIsNothingToResume) {
    EXPECT_THAT(refusal(Checkpoint{}), HasSubstr("nothing was carved"));
    EXPECT_THAT(refusal(std::nullopt), HasSubstr("damaged"));
    EXPECT_THAT(refusal(checkpoint_at(kJob, 0, 10)), HasSubstr("no layer was finished"));
    EXPECT_THAT(refusal(checkpoint_at(kJob, 0, 10)), testing::Not(HasSubstr("--from-layer")));
    EXPECT_THAT(refusal(checkpoint_at(kJob, 0, 10, 7)),
                HasSubstr("or --from-layer 7 for the piece of before"));
    EXPECT_THAT(refusal(checkpoint_at(kJob, 10, 10)), HasSubstr("carved to its end"));
    EXPECT_THAT(refusal(checkpoint_at(kJob, 3, 10), kJob + 1), HasSubstr("another job"));
    EXPECT_THAT(refusal(checkpoint_at(kJob, 3, 10), kJob, 11), HasSubstr("another job"));
}

TEST(Checkpoint, IsNoneWhenItsNumbersCannotBe) {
    EXPECT_FALSE(is_checkpoint(Checkpoint{}));
    EXPECT_FALSE(is_checkpoint(checkpoint_at(kJob, 11, 10)));
    EXPECT_FALSE(is_checkpoint(checkpoint_at(kJob, 0, 0)));
    EXPECT_FALSE(is_checkpoint(checkpoint_at(kJob, 0, 10, 10))) << "a whole piece is no way back";
    Checkpoint damaged = checkpoint_at(kJob, 3, 10);
    EXPECT_TRUE(is_checkpoint(damaged));
    damaged.next_layer = 4;
    EXPECT_FALSE(is_checkpoint(damaged));
    EXPECT_THAT(refusal(damaged), HasSubstr("damaged"));
}

}  // namespace
}  // namespace psicarve
