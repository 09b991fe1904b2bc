// SPDX-License-Identifier: GPL-3.0-or-later
// Segments that have no user any more, or are damaged: who may take their name.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "shared/computer/process_identity.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/segment_object.hpp"
#include "tests/shared/segment_fixture.hpp"

namespace psicarve {
namespace {

class LeftBehindSegment : public testing::Test {
protected:
    template <typename T>
    void put(std::size_t offset, T value) const {
        const int file = ::shm_open(name_.get().c_str(), O_RDWR, 0600);
        EXPECT_EQ(::pwrite(file, &value, sizeof(value), static_cast<off_t>(offset)), ssize_t{sizeof(value)});
        ::close(file);
    }
    void cut_to(off_t bytes) const {
        const int file = ::shm_open(name_.get().c_str(), O_RDWR, 0600);
        EXPECT_EQ(::ftruncate(file, bytes), 0);
        ::close(file);
    }
    void make_by_a_process_that_is_dead() const {
        const pid_t maker = ::fork();
        if (maker == 0) ::_exit(Segment::create_or_attach(name_.options()) ? 0 : 1);
        int status = -1;
        ::waitpid(maker, &status, 0);
        EXPECT_EQ(status, 0);
    }
    test::SegmentName name_;
};

TEST_F(LeftBehindSegment, OfAnotherLayoutIsReplacedOnceNobodyUsesIt) {
    for (const bool is_version : {true, false}) {
        (void)Segment::remove(name_.get()).has_value();
        make_by_a_process_that_is_dead();
        if (is_version) {
            put(offsetof(SegmentHeader, layout_version), std::uint32_t{7777});
        } else {
            put(offsetof(SegmentHeader, abi_hash), segment_abi_hash() + 1);
        }
        {
            auto served = SegmentObject::open(name_.get(), "");
            ASSERT_TRUE(served && *served);
            ASSERT_TRUE((**served).try_lock(LockByte::core));
            const auto refused = Segment::create_or_attach(name_.options());
            ASSERT_FALSE(refused);
            EXPECT_THAT(refused.error().message, testing::HasSubstr("that use it"));
        }
        const auto attached = Segment::attach(name_.get());
        ASSERT_FALSE(attached);
        EXPECT_EQ(attached.error().code, ErrorCode::no_core) << attached.error().message;
        const auto made = Segment::create_or_attach(name_.options());
        ASSERT_TRUE(made) << made.error().message;
        EXPECT_EQ(made->header().creator.pid.load(), own_pid());
    }
}

TEST_F(LeftBehindSegment, WhoServedANameReplacesWhatIsDamagedAndNothingElse) {
    SegmentOptions options = name_.options();
    options.replaces_damaged = true;
    ASSERT_TRUE(Segment::create_or_attach(options));
    put(offsetof(SegmentHeader, layout_version), std::uint32_t{7777});
    EXPECT_FALSE(Segment::create_or_attach(options)) << "somebody living made it";
    put(offsetof(SegmentHeader, layout_version), kLayoutVersion);
    put(offsetof(SegmentHeader, magic), std::uint64_t{7777});
    EXPECT_TRUE(Segment::create_or_attach(options));
    cut_to(4096);
    EXPECT_TRUE(Segment::create_or_attach(options));
}

}  // namespace
}  // namespace psicarve
