// SPDX-License-Identifier: GPL-3.0-or-later
// The supervisor hears stop and emergency stop: it waits for no mutex that a thread of low priority may hold.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "rtcore/plan/job_estimator.hpp"
#include "rtcore/process/side_thread.hpp"
#include "rtcore/trace/trace_thread.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/rtcore/plan/table_blocks.hpp"
#include "tests/rtcore/tick_counters.hpp"

namespace psicarve::rtcore {
namespace {

using tick_counters::count_into;
using tick_counters::Counts;

constexpr int kRounds = 2000;

TEST(WaitsForNobody, WhoGivesASideThreadSomethingToDo) {
    Counts counts;
    const auto done = std::make_shared<std::atomic<int>>(0);
    {
        SideThread sut{SideThread::Priority::low, kRounds};
        count_into(counts, [&] {
            for (int i = 0; i < kRounds; ++i) static_cast<void>(sut.do_later([done] { ++*done; }));
        });
    }
    EXPECT_EQ(done->load(), kRounds);
    EXPECT_EQ(counts.waits, 0U);
}

TEST(WaitsForNobody, WhoAsksForTheTimeOfAJobThatIsBeingPlanned) {
    Counts counts;
    plan::JobEstimator sut{Profile{}};
    const auto job = plan::test::job_of(cycle::random_job(20, 100, 11));
    for (int jobs = 0; jobs < 3; ++jobs) {
        count_into(counts, [&] {
            sut.begin(job);
            static_cast<void>(sut.estimate());
        });
        while (sut.estimate() == nullptr) {
            count_into(counts, [&] {
                static_cast<void>(sut.left(1, 20 * 100));
                static_cast<void>(sut.estimate());
            });
        }
    }
    EXPECT_EQ(counts.waits, 0U);
    EXPECT_GT(counts.locks, 0U) << "it is tried";
}

/// Counts what it is given; fails at the third.
class CountingWriter final : public trace::TraceWriter {
public:
    explicit CountingWriter(std::shared_ptr<std::atomic<int>> added) : added_(std::move(added)) {}
    void add(const trace::TraceEntry& /*entry*/) noexcept override { ++*added_; }
    void add_job(const trace::TracedJob&) noexcept override {}
    void flush() noexcept override {}
    void finish(std::uint64_t /*end_tick*/) noexcept override {}
    WrittenBytes written_bytes() const noexcept override { return bytes_; }
    std::optional<Error> take_error() override {
        if (has_told_ || added_->load() < 3) return std::nullopt;
        has_told_ = true;
        return Error{ErrorCode::bad_input, "disk full"};
    }

private:
    std::shared_ptr<std::atomic<int>> added_;
    std::shared_ptr<std::atomic<std::uint64_t>> bytes_ = std::make_shared<std::atomic<std::uint64_t>>(0);
    bool has_told_ = false;
};

TEST(WaitsForNobody, WhoHandsEntriesToATrace) {
    Counts counts;
    const auto added = std::make_shared<std::atomic<int>>(0);
    int errors = 0;
    trace::TraceThread sut{std::make_unique<CountingWriter>(added)};
    for (int i = 0; i < kRounds; ++i) {
        count_into(counts, [&] {
            EXPECT_TRUE(sut.put({}));
            sut.wake();
            if (i % 10 == 0) sut.flush();
        });
        if (i % 100 == 0) std::this_thread::yield();
        if (sut.take_error()) ++errors;
    }
    count_into(counts, [&] { sut.finish(1000, true); });
    ASSERT_TRUE(sut.wait_until_finished(std::chrono::minutes{2}));
    if (sut.take_error()) ++errors;
    EXPECT_EQ(added->load(), kRounds);
    EXPECT_EQ(errors, 1) << "told once";
    EXPECT_EQ(counts.waits, 0U);
}

}  // namespace
}  // namespace psicarve::rtcore
