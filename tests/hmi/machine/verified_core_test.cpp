// SPDX-License-Identifier: GPL-3.0-or-later
// A busy computer: the verification of a core's pins is slower than the core, which then waits for it.
#include "hmi/machine/verified_core.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <string>
#include <thread>

#include "hmi/machine/job_run.hpp"
#include "hmi/machine/recorded_pins.hpp"
#include "tests/places.hpp"
#include "tests/shared/job_fixture.hpp"

namespace psicarve::machine {
namespace {

// Longer than a core waits at its end for a reader that stands still, and than the command to end is waited
// for; shorter than we wait for ourselves.
constexpr std::chrono::seconds kStandstill{6};

class VerifiedCoreTest : public ::testing::Test {
protected:
    VerifiedCoreTest() {
        static std::atomic<int> count{0};
        launch_.segment_name =
            "/psicarve-verified-test-" + std::to_string(getpid()) + "-" + std::to_string(++count);
        launch_.is_private = true;
        const char* path = std::getenv("PATH");
        setenv("PATH", (in_build("bin:") + (path != nullptr ? path : "")).c_str(), 1);
    }

    CoreLaunch launch_;
    Profile profile_;
};

TEST_F(VerifiedCoreTest, IsWaitedForAsLongAsItsPinsAreFollowed) {
    // A trace longer than what the verifier's buffer and the pipe hold.
    const auto blob = job_blob_from_table(small_job(profile_, 160, 9));
    const auto job = JobView::check(blob);
    ASSERT_TRUE(job);
    std::atomic<bool> is_carved{false};
    std::atomic<bool> has_stood{false};
    // So slow that the pipe is full when the job is done.
    const auto stands_still = [&, calls = 0](const auto&, bool) mutable {
        if (has_stood) return;
        if (!is_carved && ++calls % 1000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds{20});
        if (!is_carved) return;
        std::this_thread::sleep_for(kStandstill);
        has_stood = true;
    };
    auto sut = VerifiedCore::start(launch_, *job, profile_, stands_still);
    ASSERT_TRUE(sut) << sut.error().message;
    const JobRun run = run_job(sut->link(), blob, {});
    is_carved = true;
    ASSERT_FALSE(run.failure) << run.failure->message;
    const auto report = sut->finish();
    ASSERT_TRUE(report) << report.error().message << '\n' << sut->core().messages();
    EXPECT_TRUE(report->ok);
    EXPECT_TRUE(has_stood);
    EXPECT_EQ(sut->core().messages(), "");
}

TEST_F(VerifiedCoreTest, ARunningCoreRecordsOnWhileItsPinsAreFollowedSlowly) {
    // A trace longer than what the ring holds as well.
    const auto blob = job_blob_from_table(small_job(profile_, 320, 9));
    const auto job = JobView::check(blob);
    ASSERT_TRUE(job);
    auto core = CoreProcess::start(launch_);
    ASSERT_TRUE(core) << core.error().message;
    auto link = MachineLink::attach(launch_.segment_name);
    ASSERT_TRUE(link);
    std::atomic<bool> has_stood{false};
    const auto stands_still = [&](const auto&, bool) {
        if (!has_stood.exchange(true)) std::this_thread::sleep_for(kStandstill);
    };
    auto sut = RecordedPins::start(*link, *job, profile_, "", stands_still);
    ASSERT_TRUE(sut) << sut.error().message;
    const JobRun run = run_job(*link, blob, {});
    ASSERT_FALSE(run.failure) << run.failure->message;
    const auto report = (*sut)->finish();
    ASSERT_TRUE(report) << report.error().message;
    EXPECT_TRUE(report->ok);
}

}  // namespace
}  // namespace psicarve::machine
