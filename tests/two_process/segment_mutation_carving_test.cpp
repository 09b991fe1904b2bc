// SPDX-License-Identifier: GPL-3.0-or-later
// Shared memory that anything may be written to while the core carves: it goes on as it would have, or stops
// on its path.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <array>
#include <cstdio>
#include <random>

#include "hmi/trace/trace_reader.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr int kCarvings = 25;
constexpr int kMutationsInACarving = 400;

/// A rising step edge: its axis, and which way.
struct Step {
    std::size_t axis;
    bool is_positive;
    friend bool operator==(const Step&, const Step&) = default;
};

class CarvingMutation : public CoreRig {
protected:
    JobTable job() const { return lobed_job(30, 201); }

    void begin_carving(const std::string& trace) {
        segment_.reset();
        [[maybe_unused]] const auto removed = Segment::remove(segment_name_);
        start_core({"--trace", trace});
        ASSERT_EQ(publish(job()), "");
        home();
        start_carving();
    }
    std::vector<Step> steps_of(const std::string& trace) const {
        std::vector<Step> steps;
        auto reader = verify::open_trace(trace);
        EXPECT_TRUE(reader) << trace;
        if (!reader) return steps;
        std::array<verify::TraceEvent, 4096> events{};
        SignalWord before = 0;
        for (;;) {
            const auto count = (*reader)->read(events);
            EXPECT_TRUE(count) << count.error().message;
            if (!count || *count == 0) return steps;
            for (std::size_t i = 0; i < *count; ++i) {
                if (events[i].kind != verify::TraceEvent::Kind::pins) continue;
                const SignalWord rising = events[i].levels & ~before & kStepMask;
                for (const Axis axis : kAllAxes) {
                    if ((rising & bit_of(step_of(axis))) != 0)
                        steps.push_back({index_of(axis), (events[i].levels & bit_of(dir_of(axis))) != 0});
                }
                before = events[i].levels;
            }
        }
    }
    /// Bits or bytes, anywhere in what has been written of the segment that has the name now; every other one
    /// where locks, counters and commands stand.
    void mutate(bool spares_control) {
        const int object = shm_open(segment_name_.c_str(), O_RDWR | O_CLOEXEC, 0);
        if (object < 0) return;
        struct stat facts {};
        EXPECT_EQ(fstat(object, &facts), 0);
        facts.st_size = std::max<off_t>(facts.st_size, 1);
        constexpr off_t kControlBytes = offsetof(SegmentHeader, status);
        const off_t from = spares_control ? std::min(kControlBytes, facts.st_size - 1) : 0;
        const bool is_control = !spares_control && random_() % 2 == 0;
        const off_t to = is_control ? std::min(kControlBytes, facts.st_size) : facts.st_size;
        const off_t wished = from + static_cast<off_t>(random_() % static_cast<std::uint64_t>(to - from));
        const off_t at = std::max(lseek(object, wished, SEEK_DATA), from);
        std::array<unsigned char, 16> bytes{};
        const std::size_t count = random_() % 3 == 0 ? 1 : 1 + random_() % bytes.size();
        const ssize_t read_bytes = pread(object, bytes.data(), count, at);
        for (ssize_t i = 0; i < read_bytes; ++i) {
            bytes[static_cast<std::size_t>(i)] ^=
                static_cast<unsigned char>(count == 1 ? 1U << random_() % 8 : random_());
        }
        if (read_bytes > 0) {
            EXPECT_EQ(pwrite(object, bytes.data(), static_cast<std::size_t>(read_bytes), at), read_bytes);
        }
        close(object);
    }
    /// A process that uses what is left gets an error that names the fault, or succeeds; none waits forever.
    void expect_named_refusal_or_none() {
        auto fresh = Segment::attach(segment_name_);
        if (!fresh) {
            EXPECT_NE(fresh.error().message, "");
            ++refusals_;
            return;
        }
        const auto published = publish_job(*fresh, job_blob_from_table(lobed_job(2, 9)), milliseconds{300});
        if (published) return;
        EXPECT_NE(published.error().message, "");
        ++refusals_;
    }
    /// Step by step what was to come, up to an end of its own; then heads that go out, and nothing else.
    void expect_own_way_and_retraction(const std::vector<Step>& wanted, const std::vector<Step>& made) {
        const auto [left, wanted_left] = std::ranges::mismatch(made, wanted);
        is_cut_short_ += wanted_left != wanted.end() ? 1 : 0;
        for (auto step = left; step != made.end(); ++step) {
            const bool is_head = step->axis == index_of(Axis::r1) || step->axis == index_of(Axis::r2);
            ASSERT_TRUE(is_head && step->is_positive)
                << "step " << step - made.begin() << " of " << made.size() << ": axis " << step->axis;
        }
    }

    std::mt19937 random_{52071};
    int refusals_ = 0;
    int is_cut_short_ = 0;
};

TEST_F(CarvingMutation, TenThousandChangeNoStepAndEndNothing) {
    begin_carving(file("undisturbed.trace"));
    ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    ASSERT_EQ(core_->wait_for_exit(), 0);
    const std::vector<Step> wanted = steps_of(file("undisturbed.trace"));
    ASSERT_GT(wanted.size(), 100'000U);
    for (int round = 0; round < kCarvings; ++round) {
        begin_carving(file("mutated.trace"));
        ASSERT_TRUE(eventually([&] { return status().points_done > 0; }));
        for (int i = 0; i < kMutationsInACarving; ++i) {
            // Every third round leaves it a segment to go on with.
            mutate(round % 3 == 0);
            if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::microseconds{200});
        }
        expect_named_refusal_or_none();
        ASSERT_EQ(waitpid(core_->pid(), nullptr, WNOHANG), 0) << "the core has ended in round " << round;
        core_->send_signal(SIGTERM);
        ASSERT_EQ(core_->wait_for_exit(), 0) << "round " << round << "\n" << text_of(file("core.err"));
        ASSERT_NO_FATAL_FAILURE(expect_own_way_and_retraction(wanted, steps_of(file("mutated.trace"))))
            << "round " << round;
    }
    EXPECT_GT(is_cut_short_, kCarvings / 2) << "they hit a core that carved";
    EXPECT_GT(refusals_, 0) << "nothing that matters was hit";
    std::printf("%d of %d carvings cut short, %d named refusals\n", is_cut_short_, kCarvings, refusals_);
}

}  // namespace
}  // namespace psicarve::two_process
