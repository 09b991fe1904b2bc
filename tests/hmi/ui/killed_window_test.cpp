// SPDX-License-Identifier: GPL-3.0-or-later
// The program itself: what it had on the desk when it was killed, beside others that run.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

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

class KilledWindow : public ::testing::Test {
protected:
    using Program = std::unique_ptr<psicarve::test::ChildProcess>;

    /// With a log of its own, and the settings of all.
    Program start(const std::string& name, const std::string& model = {}) {
        std::vector<std::string> words{in_build("bin/psicarve-hmi"), "--segment",
                                       "/psicarve-killed-" + std::to_string(::getpid())};
        if (!model.empty()) words.push_back(model);
        return std::make_unique<psicarve::test::ChildProcess>(
            words,
            std::vector<std::string>{"QT_QPA_PLATFORM=offscreen", "LC_ALL=C.UTF-8",
                                     "XDG_CONFIG_HOME=" + folder_.path("config"),
                                     "XDG_STATE_HOME=" + folder_.path(name)},
            folder_.path(name + ".errors"));
    }
    std::string log_of(const std::string& name) const {
        return text_of(folder_.path(name + "/psicarve/psicarve-hmi.log"));
    }
    bool has_record() const { return text_of(settings_).find("unfinished") != std::string::npos; }
    bool offers(const std::string& name) const {
        return log_of(name).find("Not published when a window ended: small.stl") != std::string::npos;
    }

    const psicarve::test::TemporaryFolder folder_;
    const std::string settings_ = folder_.path("config/psicarve/psicarve-hmi.ini");
};

TEST_F(KilledWindow, LeavesWhatOthersOfferOnlyOnceItIsGone) {
    const Program first = start("first", example("small.stl"));
    ASSERT_TRUE(eventually([this] { return has_record(); })) << text_of(settings_);
    // Beside it: its model is its own as long as it runs.
    const Program second = start("second", example("letter.stl"));
    ASSERT_TRUE(eventually([this] {
        return log_of("second").find("Opened letter.stl") != std::string::npos;
    })) << log_of("second");
    second->send_signal(SIGTERM);
    EXPECT_EQ(second->wait(), 0);
    EXPECT_FALSE(offers("second")) << log_of("second");
    EXPECT_TRUE(has_record()) << "a window that goes takes its own record alone";
    first->send_signal(SIGKILL);
    first->wait();
    const Program third = start("third");
    EXPECT_TRUE(eventually([this] { return offers("third"); })) << log_of("third");
    third->send_signal(SIGTERM);
    EXPECT_EQ(third->wait(), 0);
    EXPECT_TRUE(has_record()) << "nobody has declined it";
}

TEST_F(KilledWindow, LeavesNothingWhenItEndsInOrder) {
    const Program sut = start("sut", example("small.stl"));
    ASSERT_TRUE(eventually([this] { return has_record(); })) << text_of(settings_);
    sut->send_signal(SIGTERM);
    EXPECT_EQ(sut->wait(), 0);
    EXPECT_FALSE(has_record()) << text_of(settings_);
}

}  // namespace
}  // namespace psicarve::ui
