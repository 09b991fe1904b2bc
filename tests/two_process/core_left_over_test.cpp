// SPDX-License-Identifier: GPL-3.0-or-later
// What a core of another layout version left in shared memory, and a core of this one.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "tests/two_process/child_process.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

using test::ChildProcess;
using testing::HasSubstr;
using testing::StartsWith;

class LeftOver : public CoreRig {
protected:
    /// A process that makes the segment, marks it as another version's and stays; also as its core.
    ChildProcess other_program(bool is_core) {
        return ChildProcess{[this, is_core](const ChildProcess::Signal& done) {
            SegmentOptions options;
            options.name = segment_name_;
            auto segment = Segment::create_or_attach(options);
            ASSERT_TRUE(segment.has_value()) << segment.error().message;
            ASSERT_TRUE(!is_core || segment->claim_core().has_value());
            segment->header().layout_version = 2;
            segment->header().abi_hash += 1;
            done.raise();
            ::pause();
        }};
    }
    /// What a core says that is started there and refused.
    std::string refusal() {
        CoreProcess core{{"--segment", segment_name_, "--clock", "virtual"}, file("refused.err")};
        EXPECT_EQ(core.wait_for_exit(), 4);
        return text_of(file("refused.err"));
    }
    void expect_replaced_with_one_line() {
        CoreProcess core{{"--segment", segment_name_, "--clock", "virtual"}, file("core.err")};
        const auto serves = [&] {
            const auto segment = Segment::attach(segment_name_);
            return segment && segment->core_pid() == static_cast<std::uint32_t>(core.pid());
        };
        ASSERT_TRUE(eventually(serves)) << text_of(file("core.err"));
        const std::string said = text_of(file("core.err"));
        EXPECT_THAT(said, StartsWith("psicarve-rtcore: segment " + segment_name_ +
                                     ": has layout version 2, this program knows "));
        EXPECT_THAT(said, HasSubstr("made anew"));
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    }
};

TEST_F(LeftOver, ACoreReplacesWhatADeadCoreOfAnotherVersionLeft) {
    {
        ChildProcess old = other_program(true);
        ASSERT_TRUE(old.wait_for_signal());
        old.kill();
    }
    EXPECT_EQ(Segment::attach(segment_name_).error().code, ErrorCode::bad_input);
    EXPECT_TRUE(Segment::is_left_over(segment_name_));
    expect_replaced_with_one_line();
}

TEST_F(LeftOver, ALivingCoreOfAnotherVersionIsNamedAndLeftAlone) {
    ChildProcess old = other_program(true);
    ASSERT_TRUE(old.wait_for_signal());
    const std::string pid = "(pid " + std::to_string(old.pid()) + ")";
    EXPECT_FALSE(Segment::is_left_over(segment_name_));
    EXPECT_THAT(refusal(), HasSubstr("has layout version 2"));
    EXPECT_THAT(refusal(), HasSubstr("a core serves it already " + pid));
    EXPECT_THAT(refusal(), HasSubstr("another --segment"));
    old.stop();  // one that hangs is alive, too
    EXPECT_THAT(refusal(), HasSubstr("a core serves it already " + pid));
    old.kill();
    expect_replaced_with_one_line();
}

TEST_F(LeftOver, ALivingProgramOfAnotherVersionIsNamedAndLeftAlone) {
    ChildProcess old = other_program(false);
    ASSERT_TRUE(old.wait_for_signal());
    EXPECT_THAT(refusal(),
                HasSubstr("the program that made it still runs (pid " + std::to_string(old.pid()) + ")"));
    old.kill();
    expect_replaced_with_one_line();
}

TEST_F(LeftOver, OnlyACoreReplacesIt) {
    {
        ChildProcess old = other_program(true);
        ASSERT_TRUE(old.wait_for_signal());
        old.kill();
    }
    SegmentOptions options;
    options.name = segment_name_;
    const auto made = Segment::create_or_attach(options);
    ASSERT_FALSE(made.has_value());
    EXPECT_EQ(made.error().code, ErrorCode::bad_input);
    EXPECT_THAT(made.error().message, HasSubstr("start psicarve-rtcore, which replaces it"));
    EXPECT_TRUE(Segment::is_left_over(segment_name_));
}

}  // namespace
}  // namespace psicarve::two_process
