// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/job/loaded_job.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/shared/job_fixture.hpp"

namespace psicarve::supervisor {
namespace {

using testing::HasSubstr;

auto loaded(const BlankProfile& of_job, const BlankProfile& of_core) {
    Profile made_for;
    made_for.blank = of_job;
    Profile core;
    core.blank = of_core;
    return load_job(job_blob_from_table(small_job(made_for)), 1, core);
}

TEST(LoadedJob, WithABlankThatAHeadWouldStandInIsRefused) {
    const auto wide = loaded({61.0, 20.0}, {});
    ASSERT_FALSE(wide.has_value());
    EXPECT_THAT(wide.error().message,
                HasSubstr("the blank reaches out to 61.00 mm, but head r1 only to 60.00"));
    EXPECT_TRUE(loaded({60.0, 20.0}, {}).has_value());
    EXPECT_TRUE(loaded({50.0, 20.0}, {61.0, 20.0}).has_value())
        << "the core's own is not what it is made for";
}

TEST(LoadedJob, HasARemarkOfABlankThatIsNotTheCores) {
    EXPECT_TRUE(loaded({20.0, 20.0}, {20.0, 20.0}).value()->remark.is_none());
    EXPECT_TRUE(loaded({20.0, 20.0}, {}).value()->remark.is_none());
    EXPECT_EQ(loaded({20.0, 20.0}, {25.0, 20.0}).value()->remark.id, MessageId::blank_radius_in_the_way);
}

}  // namespace
}  // namespace psicarve::supervisor
