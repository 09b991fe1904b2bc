// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/robust_mutex.hpp"

#include <gtest/gtest.h>

#include <boost/interprocess/sync/scoped_lock.hpp>
#include <cstring>
#include <memory>
#include <string>
#include <thread>

#include "shared/computer/process_identity.hpp"

namespace psicarve {
namespace {

using std::chrono::milliseconds;

class RobustMutexTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(RobustMutex::initialise(*storage_).has_value()); }
    std::unique_ptr<MutexStorage> storage_ = std::make_unique<MutexStorage>();
};

TEST_F(RobustMutexTest, ScopedLockOfBoostAcceptsIt) {
    RobustMutex sut{*storage_};
    {
        const boost::interprocess::scoped_lock<RobustMutex> lock{sut};
        EXPECT_EQ(sut.holder_pid(), own_pid());
    }
    EXPECT_EQ(sut.holder_pid(), 0U);
}

TEST_F(RobustMutexTest, SecondThreadWaitsNoLongerThanItsLimitAndNamesTheHolder) {
    RobustMutex sut{*storage_};
    ASSERT_TRUE(sut.lock_within(milliseconds{1000}).has_value());

    Result<void> result;
    bool did_try_lock = true;
    std::thread{[&] {
        RobustMutex other{*storage_};
        did_try_lock = other.try_lock();
        result = other.lock_within(milliseconds{20});
    }}.join();
    sut.unlock();

    EXPECT_FALSE(did_try_lock);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::timed_out);
    EXPECT_NE(result.error().message.find("process " + std::to_string(own_pid())), std::string::npos);
}

TEST_F(RobustMutexTest, LockingTwiceIsAnErrorAndNoDeadlock) {
    RobustMutex sut{*storage_};
    ASSERT_TRUE(sut.lock_within(milliseconds{1000}).has_value());

    const Result<void> second = sut.lock_within(milliseconds{1000});
    sut.unlock();

    EXPECT_FALSE(second.has_value());
}

TEST_F(RobustMutexTest, ThreadThatEndsWhileHoldingItDoesNotLockTheOthersOut) {
    std::thread{[&] {
        EXPECT_TRUE(RobustMutex{*storage_}.lock_within(milliseconds{1000}).has_value());
    }}.join();

    RobustMutex sut{*storage_};
    ASSERT_TRUE(sut.lock_within(milliseconds{1000}).has_value());
    EXPECT_TRUE(sut.recovered());
    sut.unlock();

    ASSERT_TRUE(sut.lock_within(milliseconds{1000}).has_value());
    EXPECT_FALSE(sut.recovered());
    sut.unlock();
}

TEST_F(RobustMutexTest, GarbageInItsPlaceIsRefused) {
    for (const int fill : {0x00, 0xFF, 0x5A}) {
        std::memset(static_cast<void*>(&storage_->native), fill, sizeof(storage_->native));

        const Result<void> result = RobustMutex{*storage_}.lock_within(milliseconds{10});

        ASSERT_FALSE(result.has_value());
        EXPECT_EQ(result.error().code, ErrorCode::bad_input);
    }
}

TEST_F(RobustMutexTest, LockWordNamingAThreadThatNeverWasIsRefused) {
    storage_->native.__data.__lock = 0x3FFFFFF1;

    const Result<void> result = RobustMutex{*storage_}.lock_within(milliseconds{10});

    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::bad_input);
}

TEST_F(RobustMutexTest, CountsExactlyWhatManyThreadsDoUnderIt) {
    int guarded = 0;
    const auto work = [&] {
        for (int round = 0; round < 2000; ++round) {
            RobustMutex mutex{*storage_};
            const boost::interprocess::scoped_lock<RobustMutex> lock{mutex};
            ++guarded;
        }
    };
    std::thread first{work};
    std::thread second{work};
    first.join();
    second.join();

    EXPECT_EQ(guarded, 4000);
}

}  // namespace
}  // namespace psicarve
