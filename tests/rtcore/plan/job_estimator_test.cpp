// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/job_estimator.hpp"

#include <dirent.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "rtcore/plan/carving.hpp"
#include "tests/rtcore/plan/estimated_jobs.hpp"
#include "tests/shared/spiral_fixture.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::plan {
namespace {

// So long nothing takes that ends at all.
constexpr std::chrono::seconds kPatience{120};

double planned_seconds(const Profile& profile, const std::shared_ptr<const JobView>& job, LayerSpan layers) {
    const auto program = carving_of(machine_limits(profile), job, layers);
    cycle::MotionBlock block{};
    while (program->next(block)) {
    }
    return program->planned().seconds;
}

TEST(JobEstimate, CountsPointsEvenlyBetweenItsMarks) {
    JobEstimate sut;
    EXPECT_EQ(sut.seconds(), 0.0);
    sut.add({.points = 11, .seconds = 2.0});
    sut.add({.points = 31, .seconds = 12.0});
    EXPECT_EQ(sut.points(), 31U);
    EXPECT_DOUBLE_EQ(sut.seconds_to(0), 0.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(1), 0.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(6), 1.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(11), 2.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(21), 7.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(31), 12.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(99), 12.0);
    sut.add({.points = 31, .seconds = 13.0});
    EXPECT_DOUBLE_EQ(sut.seconds(), 13.0);
}

TEST(JobEstimate, TellsWhatIsPlannedAndSaysSo) {
    JobEstimate sut;
    sut.add({.points = 11, .seconds = 2.0});
    sut.add({.points = 41, .seconds = 20.5});
    EXPECT_DOUBLE_EQ(sut.left(11, 41).seconds, 18.5);
    EXPECT_DOUBLE_EQ(sut.left(6, 11).seconds, 1.0);
    EXPECT_DOUBLE_EQ(sut.left(41, 41).seconds, 0.0);
    EXPECT_TRUE(sut.left(11, 41).is_planned);
    EXPECT_LT(sut.left(11, 42).seconds, 0.0) << "there is no forecast";
    EXPECT_FALSE(sut.left(11, 42).is_planned);
}

TEST(JobEstimate, BetweenItsMarksPointsTakeTimeAsForecast) {
    JobEstimate sut;
    sut.forecast({10.0, 30.0, 60.0, 70.0}, 10);
    sut.add({.points = 30, .seconds = 120.0});
    EXPECT_DOUBLE_EQ(sut.seconds_to(1), 0.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(10), 20.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(20), 60.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(25), 90.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(30), 120.0);
    EXPECT_DOUBLE_EQ(sut.left(20, 30).seconds, 60.0) << "as was told before it was planned, only longer";
}

TEST(JobEstimate, PastWhatIsPlannedItGoesOnAsForecast) {
    JobEstimate sut;
    sut.forecast({10.0, 30.0, 60.0, 70.0}, 10);
    EXPECT_DOUBLE_EQ(sut.left(1, 40).seconds, 70.0);
    EXPECT_DOUBLE_EQ(sut.left(20, 40).seconds, 40.0);
    EXPECT_DOUBLE_EQ(sut.left(25, 30).seconds, 15.0);
    EXPECT_FALSE(sut.left(25, 30).is_planned);
    sut.add({.points = 20, .seconds = 36.0});
    EXPECT_DOUBLE_EQ(sut.left(1, 40).seconds, 36.0 + 40.0);
    EXPECT_FALSE(sut.left(1, 40).is_planned);
    EXPECT_TRUE(sut.left(1, 20).is_planned) << "of a run that ends there";
    // From a layer that is not planned yet.
    EXPECT_DOUBLE_EQ(sut.left(30, 40).seconds, 10.0);
    sut.add({.points = 35, .seconds = 500.0});
    EXPECT_DOUBLE_EQ(sut.left(1, 40).seconds, 505.0) << "never less than planned";
    sut.add({.points = 40, .seconds = 501.0});
    EXPECT_DOUBLE_EQ(sut.left(1, 40).seconds, 501.0);
    EXPECT_TRUE(sut.left(1, 40).is_planned);
    EXPECT_LT(sut.left(1, 41).seconds, 0.0) << "there are no more";
}

TEST(JobEstimator, FindsWhatThePlannerPlans) {
    for (const bool is_spiral : {false, true}) {
        for (const Profile& profile : {Profile{}, by_angle()}) {
            const JobTable table = rougher_and_rougher(7);
            const auto job = owned(is_spiral ? spiral_of(table) : table);
            JobEstimator sut{profile};
            EXPECT_EQ(sut.estimate(), nullptr);
            sut.begin(job);
            ASSERT_TRUE(sut.wait(kPatience));
            const auto estimate = sut.estimate();
            EXPECT_EQ(estimate->points(), 7U * 60U);
            EXPECT_DOUBLE_EQ(estimate->seconds(), planned_seconds(profile, job, {}));
            EXPECT_GT(estimate->seconds(), 0.0);
            EXPECT_EQ(estimate->is_reference(), profile.job.planner == psicarve::Planner::lookahead);
        }
    }
}

TEST(JobEstimator, TellsOneLayerFromAnother) {
    const auto job = owned(rougher_and_rougher(8));
    JobEstimator sut{Profile{}};
    sut.begin(job);
    ASSERT_TRUE(sut.wait(kPatience));
    const auto estimate = sut.estimate();
    const auto layer_seconds = [&](std::uint64_t layer) {
        return estimate->seconds_to((layer + 1) * 60) - estimate->seconds_to(layer * 60);
    };
    EXPECT_GT(layer_seconds(7), 1.5 * layer_seconds(1));
    EXPECT_NEAR(estimate->seconds_to(3 * 60), planned_seconds(Profile{}, job, {0, 3}),
                0.02 * estimate->seconds());
}

TEST(JobEstimator, KnowsWhatIsLeftOfARunThatEndsAnywhere) {
    const auto job = owned(rougher_and_rougher(8));
    JobEstimator sut{Profile{}};
    EXPECT_LT(sut.left(0, 8 * 60).seconds, 0.0);
    sut.begin(job);
    ASSERT_TRUE(sut.wait(kPatience));
    const auto all = sut.estimate();
    EXPECT_DOUBLE_EQ(sut.left(1, 8 * 60).seconds, all->seconds());
    EXPECT_TRUE(sut.left(1, 8 * 60).is_planned);
    EXPECT_DOUBLE_EQ(sut.left(8 * 60, 8 * 60).seconds, 0.0);
    EXPECT_DOUBLE_EQ(sut.left(60, 3 * 60).seconds, all->seconds_to(3 * 60) - all->seconds_to(60));
    EXPECT_LT(sut.left(0, 0).seconds, 0.0) << "nothing runs";
    sut.begin(job);
    EXPECT_LT(sut.left(60, 8 * 60).seconds, 0.0) << "forgotten";
}

TEST(JobEstimator, ForgetsTheJobBefore) {
    const auto first = owned(rougher_and_rougher(3));
    const auto second = owned(rougher_and_rougher(9));
    JobEstimator sut{Profile{}};
    sut.begin(first);
    sut.begin(second);
    ASSERT_TRUE(sut.wait(kPatience));
    EXPECT_EQ(sut.estimate()->points(), 9U * 60U);
    sut.begin(first);
    EXPECT_EQ(sut.estimate(), nullptr);
    ASSERT_TRUE(sut.wait(kPatience));
    EXPECT_EQ(sut.estimate()->points(), 3U * 60U);
}

TEST(JobEstimator, EndsInTheMiddle) {
    JobEstimator sut{Profile{}};
    sut.begin(owned(rougher_and_rougher(200)));
}

// -1: not asked yet; SS_ONSTACK: the handler ran on a stack of its own.
std::atomic<int> g_stack_flags{-1};

void note_stack(int /*signal_number*/) {
    stack_t stack{};
    sigaltstack(nullptr, &stack);
    g_stack_flags.store(stack.ss_flags);
}

std::set<pid_t> threads_of_this() {
    DIR* const threads = opendir("/proc/self/task");
    std::set<pid_t> found;
    while (const dirent* entry = readdir(threads)) {
        if (const auto thread = static_cast<pid_t>(std::atoi(entry->d_name)); thread > 0)
            found.insert(thread);
    }
    closedir(threads);
    return found;
}

TEST(JobEstimator, ItsThreadHandlesFatalSignalsOnAStackOfTheirOwn) {
    std::thread{[] {}}.join();  // a sanitizer that has a thread of its own has it from now on
    const std::set<pid_t> before_it = threads_of_this();
    JobEstimator sut{Profile{}};
    // By the time it has planned something it is what it will be.
    sut.begin(owned(rougher_and_rougher(2)));
    ASSERT_TRUE(sut.wait(kPatience));
    struct sigaction action {};
    action.sa_handler = note_stack;
    action.sa_flags = SA_ONSTACK;
    struct sigaction before {};
    sigaction(SIGUSR1, &action, &before);
    std::set<pid_t> its = threads_of_this();
    for (const pid_t thread : before_it) its.erase(thread);
    ASSERT_EQ(its.size(), 1U);
    // Where the thread is not yet back at its waiting, ThreadSanitizer keeps the signal and calls the handler
    // later, as any other function: a stack of its own is there (0, not SS_DISABLE) and not in use.
    const int most_tries = psicarve::test::kIsThreadSanitized ? 100 : 1;
    for (int tries = 0; tries < most_tries && (tries == 0 || g_stack_flags.load() == 0); ++tries) {
        g_stack_flags.store(-1);
        ASSERT_EQ(tgkill(getpid(), *its.begin(), SIGUSR1), 0);
        const auto deadline = std::chrono::steady_clock::now() + kPatience;
        while (g_stack_flags.load() == -1 && std::chrono::steady_clock::now() < deadline) {
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
    }
    sigaction(SIGUSR1, &before, nullptr);
    EXPECT_EQ(g_stack_flags.load(), SS_ONSTACK);
}

}  // namespace
}  // namespace psicarve::plan
