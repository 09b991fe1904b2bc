// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/file_presence.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

using State = FilePresence::State;

class Presence : public ::testing::Test {
protected:
    Presence() { std::ofstream{here_} << "solid"; }
    /// Until the last of what was asked for is known.
    ::testing::AssertionResult becomes(const std::string& path, State state) {
        for (int i = 0; i < 20'000; ++i) {
            sut_.poll();
            if (sut_.seen(path).state == state) return ::testing::AssertionSuccess();
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
        return ::testing::AssertionFailure() << path << " does not become so";
    }

    const psicarve::test::TemporaryFolder folder_;
    const std::string here_ = folder_.path("here.stl");
    const std::string gone_ = folder_.path("gone.stl");
    FilePresence sut_;
};

TEST_F(Presence, IsNotKnownBeforeSomebodyElseHasLooked) {
    sut_.look({here_, gone_});
    EXPECT_EQ(sut_.seen(here_).state, State::unknown) << "whoever asks does not look himself";
    ASSERT_TRUE(becomes(here_, State::there));
    EXPECT_EQ(sut_.seen(here_).written, std::filesystem::last_write_time(here_));
    EXPECT_EQ(sut_.seen(gone_).state, State::gone);
    EXPECT_EQ(sut_.seen(folder_.path("another")).state, State::unknown);
}

TEST_F(Presence, HoldsUntilTheNextLookIsOver) {
    sut_.look({here_});
    ASSERT_TRUE(becomes(here_, State::there));
    std::filesystem::remove(here_);
    sut_.look({gone_});
    ASSERT_TRUE(becomes(gone_, State::gone));
    EXPECT_EQ(sut_.seen(here_).state, State::there) << "nobody looked at it again";
    sut_.look({here_});
    EXPECT_EQ(sut_.seen(here_).state, State::there);
    ASSERT_TRUE(becomes(here_, State::gone));
}

TEST_F(Presence, FindsTheNearestFolderThatIsThere) {
    std::filesystem::create_directories(folder_.path("models/owls"));
    const std::string wanted = folder_.path("models/owls/small");
    EXPECT_EQ(sut_.nearest_folder(wanted), "") << "whoever asks does not look himself";
    sut_.look_above(wanted);
    ASSERT_TRUE(becomes(wanted, State::gone));
    EXPECT_EQ(sut_.nearest_folder(wanted), folder_.path("models/owls"));
    std::filesystem::remove(folder_.path("models/owls"));
    EXPECT_EQ(sut_.nearest_folder(wanted), folder_.path("models/owls")) << "until the next look";
    sut_.look_above(wanted);
    ASSERT_TRUE(becomes(folder_.path("models/owls"), State::gone));
    EXPECT_EQ(sut_.nearest_folder(wanted), folder_.path("models"));
    EXPECT_EQ(sut_.nearest_folder("relative"), "");
}

}  // namespace
}  // namespace psicarve::session
