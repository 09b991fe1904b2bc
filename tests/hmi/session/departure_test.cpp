// SPDX-License-Identifier: GPL-3.0-or-later
// How a program ends whose disks do not answer.
#include "hmi/session/departure.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>
#include <utility>

namespace psicarve::session {
namespace {

using std::chrono::seconds;
using Step = Departure::Step;

class Departing : public ::testing::Test {
protected:
    Step look(seconds after, const std::vector<SaveUnderWay>& saves) {
        return sut_.look(begin_ + after, saves);
    }

    const Departure::Clock::time_point begin_{};
    Departure sut_{begin_};
    const SaveUnderWay job_{1, "a.job", 0};
};

TEST_F(Departing, DoesNotWaitForWhatNobodyKeeps) {
    EXPECT_EQ(look(seconds{0}, {}), Step::wait) << "what ends by itself may";
    EXPECT_EQ(look(Departure::kLeave, {}), Step::leave);
}

TEST_F(Departing, WaitsForASaveAsLongAsItGoesOn) {
    SaveUnderWay save = job_;
    seconds now{0};
    int told = 0;
    for (; now < seconds{3600}; now += seconds{29}) {
        ++save.progress;
        const Step step = look(now, {save});
        told += step == Step::tell ? 1 : 0;
        ASSERT_TRUE(step == Step::wait || step == Step::tell) << now.count() << " s";
    }
    EXPECT_EQ(told, 1);
    EXPECT_EQ(look(now, {}), Step::wait);
    EXPECT_EQ(look(now + Departure::kLeave, {}), Step::leave);
}

TEST_F(Departing, GivesUpASaveWhoseDiskDoesNotAnswer) {
    EXPECT_EQ(look(seconds{0}, {job_}), Step::wait);
    EXPECT_EQ(look(Departure::kTell, {job_}), Step::tell);
    EXPECT_EQ(look(Departure::kGiveUp - seconds{1}, {job_}), Step::wait);
    EXPECT_EQ(look(Departure::kGiveUp, {job_}), Step::give_up);
}

TEST_F(Departing, TakesTheEndOfOneSaveForProgressOfTheNext) {
    const SaveUnderWay next{2, "b.snap", 0};
    EXPECT_EQ(look(seconds{0}, {job_, next}), Step::wait);
    EXPECT_EQ(look(seconds{20}, {next}), Step::tell);
    EXPECT_EQ(look(seconds{49}, {next}), Step::wait);
    EXPECT_EQ(look(seconds{50}, {next}), Step::give_up);
}

/// A task that stands still until it is told to go on.
class Gate {
public:
    void enter() {
        begun_.set_value();
        open_.get_future().wait();
    }
    void await_begun() { begun_.get_future().wait(); }
    void open() { open_.set_value(); }

private:
    std::promise<void> begun_;
    std::promise<void> open_;
};

TEST(PendingSaves, KnowsWhatWaitsAndWhatRunsUntilItIsDoneOrDropped) {
    PendingSaves sut;
    Gate gate;
    BackgroundQueue queue;
    queue.post(sut.noted("first", [&]() -> BackgroundQueue::Finish {
        gate.enter();
        return {};
    }));
    queue.post(sut.noted("second", []() -> BackgroundQueue::Finish { return {}; }));
    gate.await_begun();
    EXPECT_EQ(paths_of(sut.under_way()), "first, second");
    queue.drop_waiting();
    EXPECT_EQ(paths_of(sut.under_way()), "first");
    gate.open();
    queue.finish();
    EXPECT_TRUE(sut.under_way().empty());
    {
        const auto entry = sut.begin("third");
        EXPECT_EQ(paths_of(sut.under_way()), "third");
    }
    EXPECT_TRUE(sut.under_way().empty());
}

TEST(PendingSaves, SeesWhetherSomebodyWorksOnASave) {
    PendingSaves sut;
    std::atomic<bool> works{true};
    Gate gate;
    BackgroundQueue queue;
    queue.post(sut.noted("busy", [&]() -> BackgroundQueue::Finish {
        while (works) std::this_thread::yield();
        gate.enter();
        return {};
    }));
    const auto progress = [&sut] { return sut.under_way().at(0).progress; };
    const auto before = progress();
    while (progress() == before) std::this_thread::yield();  // for ever if it is not seen
    works = false;
    gate.await_begun();
    // On its way to sleep it may still need a little.
    auto asleep = progress();
    for (int same = 0; same < 1000; ++same) {
        if (progress() != std::exchange(asleep, progress())) same = 0;
    }
    EXPECT_EQ(progress(), asleep) << "a disk that does not answer is no progress";
    gate.open();
    queue.finish();
}

TEST(DepartureWatch, LetsAProgramGoThatEndsByItself) {
    bool is_left = false;
    {
        const DepartureWatch sut{PendingSaves{}, [&](bool) { is_left = true; }};
    }
    EXPECT_FALSE(is_left);
}

TEST(DepartureWatch, EndsAProgramThatWaitsForARead) {
    std::promise<bool> left;
    const DepartureWatch sut{PendingSaves{}, [&](bool is_lost) { left.set_value(is_lost); }};
    EXPECT_FALSE(left.get_future().get()) << "nothing is lost";
}

}  // namespace
}  // namespace psicarve::session
