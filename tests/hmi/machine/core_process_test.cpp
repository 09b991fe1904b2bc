// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/core_process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "hmi/machine/machine_link.hpp"
#include "tests/places.hpp"

namespace psicarve::machine {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds kLimit{60'000};

class CoreProcessTest : public ::testing::Test {
protected:
    CoreProcessTest() {
        static std::atomic<int> count{0};
        launch_.segment_name =
            "/psicarve-process-test-" + std::to_string(getpid()) + "-" + std::to_string(++count);
        launch_.is_private = true;
        // The core is looked for beside the running program, then in PATH; tests stand in another folder.
        const char* path = std::getenv("PATH");
        setenv("PATH", (in_build("bin:") + (path != nullptr ? path : "")).c_str(), 1);
    }

    CoreLaunch launch_;
};

TEST_F(CoreProcessTest, ServesItsSegmentUntilItsEndAndLeavesNone) {
    {
        auto sut = CoreProcess::start(launch_);
        ASSERT_TRUE(sut.has_value()) << sut.error().message;
        auto link = MachineLink::attach(launch_.segment_name);
        ASSERT_TRUE(link.has_value()) << link.error().message;
        EXPECT_EQ(link->core_pid(), static_cast<std::uint32_t>(sut->pid()));
        EXPECT_TRUE(link->status().has_value());
    }
    EXPECT_FALSE(MachineLink::attach(launch_.segment_name).has_value());
}

TEST_F(CoreProcessTest, HasAProcessGroupOfItsOwn) {
    auto sut = CoreProcess::start(launch_);
    ASSERT_TRUE(sut.has_value()) << sut.error().message;
    EXPECT_EQ(getpgid(sut->pid()), sut->pid());
}

TEST_F(CoreProcessTest, KeepsNoStateOfAPieceThatIsNobodys) {
    launch_.on_real_clock = true;  // a core that a user starts by hand would
    auto sut = CoreProcess::start(launch_);
    ASSERT_TRUE(sut.has_value()) << sut.error().message;
    std::ifstream file{"/proc/" + std::to_string(sut->pid()) + "/cmdline"};
    bool keeps_none = false;
    for (std::string word; std::getline(file, word, '\0');) keeps_none = keeps_none || word == "--no-state";
    EXPECT_TRUE(keeps_none);
}

TEST_F(CoreProcessTest, AFailedStartTellsWhatItSaid) {
    const std::string profile = testing::TempDir() + "bad-profile-" + std::to_string(getpid()) + ".toml";
    std::ofstream{profile} << "nonsense = 1\n";
    launch_.profile_path = profile;
    const auto sut = CoreProcess::start(launch_);
    std::filesystem::remove(profile);
    ASSERT_FALSE(sut.has_value());
    EXPECT_EQ(sut.error().code, ErrorCode::bad_input);
    EXPECT_NE(sut.error().message.find("nonsense"), std::string::npos) << sut.error().message;
}

TEST_F(CoreProcessTest, ASecondCoreIsRefusedWithTheFirstOnesPid) {
    auto first = CoreProcess::start(launch_);
    ASSERT_TRUE(first.has_value()) << first.error().message;
    CoreLaunch second = launch_;
    second.is_private = false;
    const auto sut = CoreProcess::start(second);
    ASSERT_FALSE(sut.has_value());
    EXPECT_NE(sut.error().message.find(std::to_string(first->pid())), std::string::npos)
        << sut.error().message;
}

TEST_F(CoreProcessTest, AKilledCoreIsNoticed) {
    auto sut = CoreProcess::start(launch_);
    ASSERT_TRUE(sut.has_value()) << sut.error().message;
    EXPECT_TRUE(sut->is_running());
    kill(sut->pid(), SIGKILL);
    EXPECT_EQ(sut->wait_exit(kLimit), 128 + SIGKILL);
    EXPECT_FALSE(sut->is_running());
}

}  // namespace
}  // namespace psicarve::machine
