// SPDX-License-Identifier: GPL-3.0-or-later
// The job that a binary trace carries.
#include "hmi/trace/carried_job.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "shared/job/job.hpp"
#include "shared/trace/trace_format.hpp"
#include "tests/hmi/verify/trace_file_fixture.hpp"

namespace psicarve::verify {
namespace {

using testing::HasSubstr;

/// The trace with a job in the middle of it, at a record's begin, and its bytes before that.
class CarriedJob : public WholeTrace {
protected:
    CarriedJob() {
        const std::vector<TraceEvent> first(machine_.events.begin(), machine_.events.begin() + kBefore);
        before_ = as_binary(machine_.start, first);
        before_.pop_back();  // the end, a tick later
        const std::string whole = as_binary(machine_.start, machine_.events);
        std::array<std::uint8_t, kTraceRecordMaxBytes> room{};
        const auto* const end = encode_trace_job_head(room.data(), job_.blob.size(), job_checksum(job_.blob));
        head_.assign(reinterpret_cast<const char*>(room.data()), static_cast<std::size_t>(end - room.data()));
        blob_.assign(reinterpret_cast<const char*>(job_.blob.data()), job_.blob.size());
        after_ = whole.substr(before_.size());
    }
    std::string trace() const { return before_ + head_ + blob_ + after_; }
    Result<std::optional<std::vector<std::byte>>> job_in(const std::string& bytes) {
        std::ofstream(path_, std::ios::binary) << bytes;
        return first_carried_job(path_);
    }
    std::string problem_of(const std::string& bytes) {
        const auto job = job_in(bytes);
        return job ? std::string{} : job.error().message;
    }

    static constexpr std::ptrdiff_t kBefore = 101;
    std::string before_;
    std::string head_;
    std::string blob_;
    std::string after_;
};

TEST_F(CarriedJob, IsReadAndChangesNoEvent) {
    for (const std::size_t at_once : {1U, 64U, 100'000U}) expect_equal(read(trace(), at_once), machine_);
    const auto job = job_in(trace());
    ASSERT_TRUE(job && *job);
    EXPECT_EQ(**job, job_.blob);
    const auto none = job_in(as_binary(machine_.start, machine_.events));
    ASSERT_TRUE(none);
    EXPECT_FALSE(*none);
}

TEST_F(CarriedJob, ComesThroughAPipeInPieces) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const std::string bytes = trace();
    std::thread writer([&] {
        for (std::size_t at = 0; at < bytes.size(); at += 97) {
            const std::size_t length = std::min<std::size_t>(97, bytes.size() - at);
            ASSERT_EQ(::write(ends[1], bytes.data() + at, length), static_cast<ssize_t>(length));
        }
        ::close(ends[1]);
    });
    const ReadTrace read = read_all(open_trace_fd(ends[0], "pipe"));
    writer.join();
    expect_equal(read, machine_);
}

TEST_F(CarriedJob, ThatIsDamagedIsRefusedAndThePinsAreStillRead) {
    for (const std::size_t at : {std::size_t{0}, blob_.size() / 2, blob_.size() - 1}) {
        std::string bytes = trace();
        bytes[before_.size() + head_.size() + at] ^= 0x10;
        EXPECT_EQ(problem_of(bytes), path_ + ": the job that it carries is damaged");
        expect_equal(read(bytes), machine_);
    }
}

TEST_F(CarriedJob, CutOffIsRefusedWithItsLength) {
    const std::size_t job = before_.size();
    for (const std::size_t length : {job + 3, job + head_.size() - 1, job + head_.size(), job + 500}) {
        const std::string bytes = trace().substr(0, length);
        const std::string wanted = path_ + ": byte " + std::to_string(length) +
                                   ": the trace is cut off inside the job that it carries";
        EXPECT_EQ(problem_of(bytes), wanted);
        const ReadTrace trace = read(bytes);
        EXPECT_EQ(trace.error, wanted);
        EXPECT_EQ(trace.events.size(), static_cast<std::size_t>(kBefore)) << "what is before it is there";
    }
    // Behind the job all is as without one, and the job is whole.
    const std::string bytes = trace().substr(0, trace().size() - 1);
    EXPECT_EQ(problem_of(bytes), "");
    EXPECT_THAT(read(bytes).error, HasSubstr("it ends without its end record"));
}

TEST_F(CarriedJob, OfAnImpossibleLengthIsRefusedBeforeAnyRoomIsMadeForIt) {
    for (const std::uint64_t bytes : {std::uint64_t{0}, kMostTraceJobBytes + 1, ~std::uint64_t{0}}) {
        std::array<std::uint8_t, kTraceRecordMaxBytes> room{};
        const auto* const end = encode_trace_job_head(room.data(), bytes, 1);
        const std::string head(reinterpret_cast<const char*>(room.data()),
                               static_cast<std::size_t>(end - room.data()));
        EXPECT_THAT(problem_of(before_ + head + blob_), HasSubstr("of more than any job has")) << bytes;
    }
    // As long as may be, and not there.
    std::array<std::uint8_t, kTraceRecordMaxBytes> room{};
    const auto* const end = encode_trace_job_head(room.data(), kMostTraceJobBytes, 1);
    const std::string head(reinterpret_cast<const char*>(room.data()),
                           static_cast<std::size_t>(end - room.data()));
    EXPECT_THAT(problem_of(before_ + head + blob_), HasSubstr("cut off inside the job"));
}

TEST_F(CarriedJob, IsNoneInTheOlderForm) {
    std::string bytes = trace();
    bytes[8] = 1;
    EXPECT_THAT(read(bytes).error, HasSubstr("a change of no signal"));
    const auto job = job_in(bytes);
    ASSERT_TRUE(job);
    EXPECT_FALSE(*job);
    std::string older = as_binary(machine_.start, machine_.events);
    older[8] = 1;
    expect_equal(read(older), machine_);
}

TEST_F(CarriedJob, TellsWhichJobsMayBeItsOwn) {
    constexpr std::uint64_t kSecond = 77;
    std::array<std::uint8_t, kTraceRecordMaxBytes> room{};
    const auto* const end = encode_trace_job_head(room.data(), 3, kSecond);
    const std::string second =
        std::string(reinterpret_cast<const char*>(room.data()), static_cast<std::size_t>(end - room.data())) +
        "abc";
    std::ofstream(path_, std::ios::binary) << before_ + head_ + blob_ + head_ + blob_ + second + after_;
    EXPECT_TRUE(check_is_of_trace(path_, job_checksum(job_.blob), "a.job"));
    EXPECT_TRUE(check_is_of_trace(path_, kSecond, "b.job"));
    const auto other = check_is_of_trace(path_, 78, "c.job");
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().message,
              "c.job: is not the job that " + path_ + " carries; leave it out, or name the right one");
    auto reader = open_trace(path_);
    ASSERT_TRUE(reader);
    std::array<TraceEvent, 64> some{};
    while ((*reader)->read(some).value() > 0) {
    }
    EXPECT_EQ((*reader)->jobs_begun(), 2U) << "the first twice, and the second";
    // One that is not what its own checksum says is no other job.
    std::string damaged = trace();
    damaged[before_.size() + head_.size() - 1] ^= 1;
    std::ofstream(path_, std::ios::binary) << damaged;
    EXPECT_TRUE(check_is_of_trace(path_, job_checksum(job_.blob), "a.job"));
    // Any may be the job of one that carries none.
    std::ofstream(path_, std::ios::binary) << as_binary(machine_.start, machine_.events);
    EXPECT_TRUE(check_is_of_trace(path_, 78, "c.job"));
}

}  // namespace
}  // namespace psicarve::verify
