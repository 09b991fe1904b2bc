// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/gl_trial.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::ui {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kAsLongAsItTakes{120'000};
constexpr milliseconds kMoment{10};

class GlTrials : public ::testing::Test {
protected:
    std::optional<bool> has_crashed() const { return GlTrial{state_}.has_crashed_before(kAsLongAsItTakes); }
    static long number_in(const std::string& path) {
        long number = 0;
        std::ifstream{path} >> number;
        return number;
    }
    const psicarve::test::TemporaryFolder folder_;
    const std::string state_ = folder_.path("state");
    const std::string marker_ = state_ + "/opengl-is-tried";
};

TEST_F(GlTrials, RememberAProgramThatDidNotGetThrough) {
    EXPECT_EQ(has_crashed(), false);
    GlTrial sut{state_};
    EXPECT_TRUE(sut.begin(kAsLongAsItTakes));
    EXPECT_EQ(number_in(marker_), ::getpid()) << "there before OpenGL is tried";
    EXPECT_EQ(has_crashed(), false) << "it is us, and we live";
    const pid_t crashed = ::fork();
    if (crashed == 0) ::_exit(0);
    int end = 0;
    ASSERT_EQ(::waitpid(crashed, &end, 0), crashed);
    std::ofstream{marker_} << crashed << '\n';
    EXPECT_EQ(has_crashed(), true);
    EXPECT_EQ(has_crashed(), true) << "until it is tried again";
    { GlTrial{state_}.end(); }
    EXPECT_EQ(has_crashed(), false);
    EXPECT_FALSE(std::filesystem::exists(marker_));
    // Nowhere to remember.
    EXPECT_TRUE(GlTrial{""}.begin(kAsLongAsItTakes));
    EXPECT_EQ(GlTrial{""}.has_crashed_before(kAsLongAsItTakes), false);
}

TEST_F(GlTrials, AreNotBegunWhereTheyCannotBeRemembered) {
    std::ofstream{state_} << "a file, no folder";
    EXPECT_FALSE(GlTrial{state_}.begin(kAsLongAsItTakes));
}

// A named pipe with nobody at its other end is a disk that does not answer.
TEST_F(GlTrials, GoOnWithoutADiskThatDoesNotAnswer) {
    std::filesystem::create_directories(state_);
    ASSERT_EQ(::mkfifo(marker_.c_str(), 0600), 0);
    {
        GlTrial sut{state_};
        EXPECT_FALSE(sut.begin(kMoment));
        EXPECT_EQ(number_in(marker_), ::getpid());  // it wakes up
    }
    EXPECT_FALSE(std::filesystem::exists(marker_)) << "what came too late is taken back";
    ASSERT_EQ(::mkfifo(marker_.c_str(), 0600), 0);
    GlTrial sut{state_};
    EXPECT_EQ(sut.has_crashed_before(kMoment), std::nullopt);
    EXPECT_EQ(sut.has_crashed_before(kMoment), std::nullopt);
    std::ofstream{marker_} << ::getpid() << '\n';
    EXPECT_EQ(sut.has_crashed_before(kAsLongAsItTakes), false);
}

}  // namespace
}  // namespace psicarve::ui
