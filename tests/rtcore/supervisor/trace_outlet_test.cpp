// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/trace/trace_outlet.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/rtcore/trace/trace_files.hpp"

namespace psicarve::supervisor {
namespace {

using trace::TraceEntry;
using trace::TraceRing;

constexpr std::chrono::minutes kLong{2};

TraceEntry entry(TraceEntry::Kind kind, std::uint64_t tick, std::uint32_t token) {
    TraceEntry made{};
    made.kind = kind;
    made.tick = tick;
    made.token = token;
    return made;
}

class Recording : public trace::TraceFolder {
protected:
    void open(const std::vector<std::string>& paths) {
        ASSERT_TRUE(sut_.open(paths, start_));
        sut_.set_recording_taker([this](std::uint32_t token, std::span<const std::uint8_t> bytes) {
            tokens_.push_back(token);
            taken_.append(bytes.begin(), bytes.end());
            has_ended_ = bytes.empty();
        });
    }
    void pass(const TraceEntry& one) {
        ring_->push(one);
        sut_.drain(*ring_);
    }
    /// What a trace file of the same story holds.
    std::string story_in_file(const std::string& name) {
        TraceOutlet outlet;
        EXPECT_TRUE(outlet.open({path(name)}, start_));
        trace::tell_short_story([&](const TraceEntry& one) {
            ring_->push(one);
            outlet.drain(*ring_);
        });
        outlet.finish(1000);
        EXPECT_TRUE(outlet.wait_until_finished(kLong));
        return content(path(name));
    }
    std::unique_ptr<TraceRing> ring_ = std::make_unique<TraceRing>();
    trace::TraceStart start_{50'000, 0, {}};
    std::vector<std::uint32_t> tokens_;
    std::string taken_;
    bool has_ended_ = false;
    TraceOutlet sut_;
};

TEST_F(Recording, IsTheTraceOfAFileThatBeganAtItsTick) {
    constexpr std::uint64_t kBegin = 123'456;
    for (const auto& [kind, name] : {std::pair{TraceEntry::Kind::begin_binary, "a.trace"},
                                     std::pair{TraceEntry::Kind::begin_vcd, "a.vcd"}}) {
        taken_.clear();
        has_ended_ = false;
        open({});
        pass(entry(kind, kBegin, 5));
        trace::tell_short_story([&](TraceEntry one) {
            one.tick += kBegin;
            pass(one);
        });
        EXPECT_FALSE(has_ended_);
        pass(entry(TraceEntry::Kind::end, kBegin + 1000, 5));
        EXPECT_TRUE(has_ended_);
        EXPECT_EQ(taken_, story_in_file(name)) << name;
        EXPECT_EQ(tokens_.back(), 5U);
    }
}

TEST_F(Recording, LeavesTraceFilesAsTheyWouldBeWithoutIt) {
    open({path("with.trace")});
    pass(entry(TraceEntry::Kind::begin_binary, 0, 5));
    trace::tell_short_story([&](const TraceEntry& one) { pass(one); });
    pass(entry(TraceEntry::Kind::end, 900, 5));
    sut_.finish(1000);
    EXPECT_TRUE(sut_.wait_until_finished(kLong));
    EXPECT_EQ(content(path("with.trace")), story_in_file("without.trace"));
}

TEST_F(Recording, EndsWithTheCore) {
    open({});
    pass(entry(TraceEntry::Kind::begin_binary, 0, 5));
    sut_.finish(10);
    EXPECT_TRUE(has_ended_);
}

TEST_F(Recording, ThatIsDroppedSaysNothingMore) {
    open({});
    pass(entry(TraceEntry::Kind::begin_binary, 0, 5));
    sut_.drop_recording();
    pass(entry(TraceEntry::Kind::end, 10, 5));
    sut_.finish(20);
    EXPECT_EQ(taken_, "");
    EXPECT_TRUE(tokens_.empty());
}

TEST_F(Recording, FilesCarryAJobWhereItBeginsAndNotTwice) {
    const std::vector<std::byte> blob(5000, std::byte{3});
    const auto job = [&](std::uint64_t checksum) { return trace::TracedJob{nullptr, blob, checksum, 2}; };
    open({path("a.trace"), path("a.vcd")});
    sut_.set_job(job(5));  // never begun
    ring_->push(trace::pins(3, 1));
    ring_->push(entry(TraceEntry::Kind::job, 3, 1));  // another generation's: it is not there any more
    ring_->push(entry(TraceEntry::Kind::job, 3, 2));
    sut_.set_job(job(6));
    sut_.drain(*ring_);
    pass(trace::pins(4, 0));
    sut_.set_job(job(6));  // published once more
    pass(entry(TraceEntry::Kind::job, 4, 2));
    sut_.finish(5);
    EXPECT_TRUE(sut_.wait_until_finished(kLong));
    EXPECT_TRUE(sut_.take_errors().empty());
    const std::string expected = std::string("\x0C\x01\0\0\x88\x27\x06\0\0\0\0\0\0\0", 14) +
                                 std::string(blob.size(), '\3') + "\x04\x01\x07";
    EXPECT_EQ(content(path("a.trace")).substr(64), expected);
    EXPECT_EQ(content(path("a.vcd")).find('\3'), std::string::npos);
}

/// A trace into a pipe that nobody reads, and one into a file beside it.
class StandingReader : public trace::TraceFolder {
protected:
    static constexpr std::size_t kMany = 5 * trace::kTraceRingEntries;  ///< more than rings, buffer and pipe

    explicit StandingReader() {
        EXPECT_EQ(pipe2(ends_, O_CLOEXEC | O_NONBLOCK), 0);
        EXPECT_EQ(fcntl(ends_[1], F_SETFL, 0), 0);
    }
    ~StandingReader() override { close(ends_[0]); }
    void open(TraceOutlet& sut) const {
        ASSERT_TRUE(sut.open({"fd:" + std::to_string(ends_[1]), path("file.trace")}, {50'000, 0, {}}));
    }
    /// So many as the outlet lets in: pulses, one a tick, far enough apart to need some room.
    std::size_t pass_many(TraceOutlet& sut) {
        std::size_t passed = 0;
        while (passed < kMany && ring_->push(trace::pins(300 * passed, passed % 2 == 0 ? 1 : 0))) {
            sut.drain(*ring_);
            ++passed;
        }
        return passed;
    }
    std::size_t bytes_in_pipe() {
        std::array<char, 65536> bytes{};
        std::size_t sum = 0;
        for (ssize_t got = 1; got > 0; sum += got > 0 ? static_cast<std::size_t>(got) : 0)
            got = read(ends_[0], bytes.data(), bytes.size());
        return sum;
    }
    std::unique_ptr<TraceRing> ring_ = std::make_unique<TraceRing>();
    int ends_[2]{-1, -1};
};

TEST_F(StandingReader, KeepsNobodyWaitingAndWhatIsLostIsCountedAndSaid) {
    TraceOutlet sut{TraceOutlet::WhenFull::loses};
    open(sut);
    EXPECT_EQ(pass_many(sut), kMany);
    EXPECT_GT(sut.lost(), 0U);
    sut.finish(300 * kMany);
    EXPECT_FALSE(sut.wait_until_finished(std::chrono::milliseconds{50}));
    sut.give_up();
    const auto said = sut.take_errors();
    ASSERT_GE(said.size(), 3U);
    for (const char* wanted : {"from tick", "are missing in it", "nobody takes what is written"}) {
        EXPECT_TRUE(std::ranges::any_of(said, [&](const std::string& line) {
            return line.find(wanted) != std::string::npos;
        })) << wanted;
    }
}

TEST_F(StandingReader, LetsNothingBeLostWhereTimeCanWait) {
    TraceOutlet sut{TraceOutlet::WhenFull::waits};
    open(sut);
    std::size_t passed = pass_many(sut);
    EXPECT_LT(passed, kMany) << "the tick's ring is full";
    std::size_t bytes = 0;
    while (passed < kMany) {
        bytes += bytes_in_pipe();
        sut.drain(*ring_);
        if (ring_->push(trace::pins(300 * passed, passed % 2 == 0 ? 1 : 0))) ++passed;
    }
    while (ring_->size() > 0) {
        bytes += bytes_in_pipe();
        sut.drain(*ring_);
    }
    sut.finish(300 * kMany);
    while (!sut.wait_until_finished(std::chrono::milliseconds{1})) bytes += bytes_in_pipe();
    bytes += bytes_in_pipe();
    EXPECT_EQ(sut.lost(), 0U);
    EXPECT_EQ(bytes, content(path("file.trace")).size());
    EXPECT_TRUE(sut.take_errors().empty());
}

}  // namespace
}  // namespace psicarve::supervisor
