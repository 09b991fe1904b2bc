// SPDX-License-Identifier: GPL-3.0-or-later
// The program on disks that do not answer: named pipes with nobody at their other end.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "tests/hmi/ui/program_watch.hpp"
#include "tests/hmi/x11/child_process.hpp"
#include "tests/places.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::ui {
namespace {

using test::eventually;
using test::text_of;

class Farewell : public ::testing::Test {
protected:
    /// Its first message is there before its window: OpenGL took a program down that is no more.
    void start() {
        leave_a_crash();
        run();
    }
    void leave_a_crash() const {
        std::filesystem::create_directories(folder_.path("state/psicarve"));
        const int gone = psicarve::test::ChildProcess{{"true"}, {}, "/dev/null"}.pid();
        std::ofstream{trial_} << gone << '\n';
    }
    void run() {
        program_ = std::make_unique<psicarve::test::ChildProcess>(
            std::vector<std::string>{in_build("bin/psicarve-hmi"), "--segment",
                                     "/psicarve-farewell-" + std::to_string(::getpid())},
            std::vector<std::string>{"QT_QPA_PLATFORM=offscreen", "XDG_CONFIG_HOME=" + folder_.path("config"),
                                     "XDG_STATE_HOME=" + folder_.path("state")},
            errors_);
    }
    const psicarve::test::TemporaryFolder folder_;
    const std::string settings_ = folder_.path("config/psicarve/psicarve-hmi.ini");
    const std::string log_ = folder_.path("state/psicarve/psicarve-hmi.log");
    const std::string trial_ = folder_.path("state/psicarve/opengl-is-tried");
    const std::string errors_ = folder_.path("errors");
    std::unique_ptr<psicarve::test::ChildProcess> program_;
};

TEST_F(Farewell, IsNotDelayedByAFileThatIsNeverRead) {
    std::filesystem::create_directories(folder_.path("config/psicarve"));
    ASSERT_EQ(::mkfifo(settings_.c_str(), 0600), 0);
    start();
    ASSERT_TRUE(eventually([this] { return text_of(log_).find("OpenGL") != std::string::npos; }))
        << "it waits for its settings";
    program_->send_signal(SIGTERM);
    EXPECT_EQ(program_->wait(), 0);
    EXPECT_EQ(text_of(errors_).find("saved"), std::string::npos) << text_of(errors_);
}

TEST_F(Farewell, IsNotDelayedByATrialOfOpenGlThatIsNeverRead) {
    std::filesystem::create_directories(folder_.path("state/psicarve"));
    ASSERT_EQ(::mkfifo(trial_.c_str(), 0600), 0);
    run();
    // It keeps its place soon after it is shown.
    ASSERT_TRUE(eventually([this] { return std::filesystem::exists(settings_); }))
        << "it waits for the trial";
    program_->send_signal(SIGTERM);
    EXPECT_EQ(program_->wait(), 0);
    EXPECT_TRUE(std::filesystem::is_fifo(trial_));
    EXPECT_EQ(text_of(errors_).find("saved"), std::string::npos) << text_of(errors_);
}

TEST_F(Farewell, TellsOfACrashThatItReadsLate) {
    std::filesystem::create_directories(folder_.path("state/psicarve"));
    ASSERT_EQ(::mkfifo(trial_.c_str(), 0600), 0);
    run();
    ASSERT_TRUE(eventually([this] { return std::filesystem::exists(settings_); }));
    EXPECT_EQ(text_of(log_).find("OpenGL"), std::string::npos);
    std::ofstream{trial_} << psicarve::test::ChildProcess{{"true"}, {}, "/dev/null"}.pid() << '\n';
    EXPECT_TRUE(eventually([this] { return text_of(log_).find("OpenGL") != std::string::npos; }));
    program_->send_signal(SIGTERM);
    EXPECT_EQ(program_->wait(), 0);
}

TEST_F(Farewell, WaitsForWhatIsBeingSavedAndSaysSo) {
    std::filesystem::create_directories(folder_.path("state/psicarve"));
    ASSERT_EQ(::mkfifo(log_.c_str(), 0600), 0);
    start();
    // It keeps its place soon after it is shown.
    ASSERT_TRUE(eventually([this] { return std::filesystem::exists(settings_); }));
    program_->send_signal(SIGTERM);
    ASSERT_TRUE(
        eventually([this] { return text_of(errors_).find("still being saved") != std::string::npos; }));
    EXPECT_NE(text_of(errors_).find(log_), std::string::npos) << text_of(errors_);
    const std::string lines = text_of(log_);  // the disk wakes up
    EXPECT_EQ(program_->wait(), 0);
    EXPECT_NE(lines.find("OpenGL"), std::string::npos) << lines;
}

}  // namespace
}  // namespace psicarve::ui
