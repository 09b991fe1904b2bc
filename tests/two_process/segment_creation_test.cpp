// SPDX-License-Identifier: GPL-3.0-or-later
// Several processes that make, take over and share one segment.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "shared/segment/robust_mutex.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/segment_object.hpp"
#include "tests/shared/segment_fixture.hpp"
#include "tests/two_process/child_process.hpp"

namespace {

/// What posix_fallocate may still give away in this process.
std::int64_t g_room_bytes = std::numeric_limits<std::int64_t>::max();

}  // namespace

/// Stands before the C library's for this program.
extern "C" int posix_fallocate(int file, off_t offset, off_t bytes) {
    if (bytes > g_room_bytes) return ENOSPC;
    g_room_bytes -= bytes;
    return ::fallocate(file, 0, offset, bytes) == 0 ? 0 : errno;
}

namespace psicarve {
namespace {

using std::chrono::milliseconds;
using test::ChildProcess;
using testing::HasSubstr;

constexpr milliseconds kLong{60'000};

class SegmentCreation : public testing::Test {
protected:
    Result<Segment> create() const { return Segment::create_or_attach(name_.options()); }
    test::SegmentName name_;
};

TEST_F(SegmentCreation, ACoreThatBeginsMakesAnOverwrittenMutexAnew) {
    auto segment = create();
    ASSERT_TRUE(segment) << segment.error().message;
    for (const int fill : {0x00, 0xFF, 0x5A}) {
        std::memset(static_cast<void*>(&segment->header().mutex.native), fill, sizeof(pthread_mutex_t));
        const auto refused = RobustMutex{segment->header().mutex}.lock_within(milliseconds{10});
        ASSERT_FALSE(refused);
        EXPECT_THAT(refused.error().message, HasSubstr("end the core and start it again"));
        {
            auto core = create();
            ASSERT_TRUE(core && core->claim_core());
            core->release_core();
        }
        RobustMutex sut{segment->header().mutex};
        ASSERT_TRUE(sut.lock_within(milliseconds{1000})) << fill;
        sut.unlock();
    }
}

TEST_F(SegmentCreation, ACoreThatBeginsLeavesAMutexThatIsHeld) {
    auto segment = create();
    ASSERT_TRUE(segment) << segment.error().message;
    ChildProcess holder{[&](ChildProcess::Signal holds) {
        RobustMutex mutex{segment->header().mutex};
        if (mutex.try_lock()) holds.raise();
        pause();
    }};
    ASSERT_TRUE(holder.wait_for_signal());
    auto core = create();
    ASSERT_TRUE(core && core->claim_core());
    const auto late = RobustMutex{segment->header().mutex}.lock_within(milliseconds{10});
    ASSERT_FALSE(late);
    EXPECT_EQ(late.error().code, ErrorCode::timed_out);
    core->release_core();
}

TEST_F(SegmentCreation, ProcessesThatComeAtOnceShareOneObject) {
    constexpr int kProcesses = 6;
    for (int round = 0; round < 20; ++round) {
        std::vector<std::unique_ptr<ChildProcess>> children;
        for (int index = 0; index < kProcesses; ++index) {
            children.push_back(std::make_unique<ChildProcess>([this](const ChildProcess::Signal&) {
                auto segment = create();
                ASSERT_TRUE(segment.has_value()) << segment.error().message;
                segment->header().stop_requests.fetch_add(1);
                EXPECT_TRUE(segment->is_still_linked());
            }));
        }
        for (auto& child : children) EXPECT_TRUE(child->ends_well());

        EXPECT_EQ(create().value().header().stop_requests.load(), std::uint32_t{kProcesses});
        ASSERT_TRUE(Segment::remove(name_.get()).has_value());
    }
}

TEST_F(SegmentCreation, CreatorKilledAtAnyInstantIsFollowedByAnother) {
    std::mt19937 random{20240611};
    std::uniform_int_distribution<useconds_t> life_us{0, 2000};
    for (int round = 0; round < 200; ++round) {
        ChildProcess creator{[this](const ChildProcess::Signal& began) {
            began.raise();
            for (;;) {
                (void)create().has_value();
                (void)Segment::remove(name_.get()).has_value();
            }
        }};
        ASSERT_TRUE(creator.wait_for_signal());
        ::usleep(life_us(random));
        creator.kill();

        const auto segment = create();
        ASSERT_TRUE(segment.has_value()) << round << ": " << segment.error().message;
        ASSERT_TRUE(segment->is_still_linked());
    }
}

TEST_F(SegmentCreation, ObjectWhoseCreatorIsStillAtWorkIsWaitedFor) {
    ChildProcess creator{[this](const ChildProcess::Signal& began) {
        auto object = SegmentObject::create(name_.get(), "");
        ASSERT_TRUE((*object)->try_lock(LockByte::creator));
        began.raise();
        ::pause();
    }};
    ASSERT_TRUE(creator.wait_for_signal());
    ChildProcess second{[this](const ChildProcess::Signal& began) {
        began.raise();
        EXPECT_TRUE(create().has_value());
    }};
    ASSERT_TRUE(second.wait_for_signal());
    ::usleep(20'000);
    EXPECT_EQ(SegmentObject::open(name_.get(), "").value()->size_bytes(), 0);

    creator.kill();

    EXPECT_TRUE(second.ends_well());
}

TEST_F(SegmentCreation, PublishersOfSeveralProcessesTakeTurns) {
    constexpr int kProcesses = 3;
    constexpr int kJobs = 40;
    const Segment segment = create().value();
    std::vector<std::unique_ptr<ChildProcess>> children;
    for (int index = 0; index < kProcesses; ++index) {
        children.push_back(std::make_unique<ChildProcess>([this, index](const ChildProcess::Signal&) {
            Segment own = create().value();
            for (int job = 0; job < kJobs; ++job) {
                EXPECT_TRUE(publish_job(own, test::make_job(index * kJobs + job, 60, 60), kLong).has_value());
            }
        }));
    }
    for (auto& child : children) EXPECT_TRUE(child->ends_well());

    EXPECT_EQ(published_generation(segment), std::uint64_t{kProcesses} * kJobs);
}

/// Runs in a child: gives it a small /dev/shm of its own; where the system does not let it mount one, the
/// calls that take memory for the object find as little room there.
void get_small_shm(std::int64_t bytes) {
    const std::string size_option = "size=" + std::to_string(bytes);
    const bool is_done = ::unshare(CLONE_NEWNS) == 0 &&
                         ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                         ::mount("tmpfs", "/dev/shm", "tmpfs", 0, size_option.c_str()) == 0;
    if (!is_done) g_room_bytes = bytes;
}

constexpr std::int64_t kMib = 1 << 20;

TEST_F(SegmentCreation, FullSharedMemoryIsAnErrorMessageAndLeavesNoObject) {
    ChildProcess child{[this](const ChildProcess::Signal&) {
        get_small_shm(1 * kMib);
        const auto made = create();
        ASSERT_FALSE(made.has_value());
        EXPECT_EQ(made.error().code, ErrorCode::out_of_room);
        EXPECT_THAT(made.error().message, HasSubstr("/dev/shm is full"));
        EXPECT_LT(::shm_open(name_.get().c_str(), O_RDONLY, 0), 0);
    }};
    EXPECT_TRUE(child.ends_well());
}

TEST_F(SegmentCreation, FullSharedMemoryWhilePublishingKeepsTheOldJob) {
    ChildProcess child{[this](const ChildProcess::Signal&) {
        get_small_shm(8 * kMib);
        Segment segment = create().value();
        ASSERT_TRUE(publish_job(segment, test::make_job(1, 500, 500)).has_value());

        const auto published = publish_job(segment, test::make_job(2, 500, 500));

        ASSERT_FALSE(published.has_value());
        EXPECT_EQ(published.error().code, ErrorCode::out_of_room);
        EXPECT_EQ(take_published_job(segment, 0).value().value().blob, test::make_job(1, 500, 500));
        EXPECT_TRUE(publish_job(segment, test::make_job(3, 50, 50)).has_value());
    }};
    EXPECT_TRUE(child.ends_well());
}

}  // namespace
}  // namespace psicarve
