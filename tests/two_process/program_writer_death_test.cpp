// SPDX-License-Identifier: GPL-3.0-or-later
// Writers that are killed or stopped while a real core runs their program, and words of the ring that are
// overwritten meanwhile: the machine stays on the program's way, and comes to rest on it.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "tests/thoroughness.hpp"
#include "tests/two_process/program_proof_rig.hpp"

namespace psicarve::test {
namespace {

class WriterDeath : public ProgramProof {
protected:
    /// Writes forth and back along a straight way, R1 and Y out, R2 in, a pulse each at a time, and psi with
    /// them.
    auto writing() const {
        return [this](const ChildProcess::Signal& begun) {
            Segment segment = Segment::attach(segment_).value();
            ProgramWriter writer = ProgramWriter::claim(segment).value();
            ASSERT_TRUE(writer.begin(milliseconds{60'000}).has_value());
            begun.raise();
            for (std::uint64_t i = 1; writer.put(numbered_record(i)) == ProgramPut::done;) ++i;
            ::pause();
        };
    }
    void go_to_begin() {
        const Outcome moved = run({"move", "r1=20", "r2=30", "y=10", "psi=0"});
        ASSERT_EQ(moved.exit_code, 0) << moved.error;
    }
    /// Off the straight way by so many pulses, at most of any axis.
    static std::int64_t off_way_pulses(const CoreStatus& now) {
        const auto& at = now.position_pulses;
        const std::int64_t done = at[index_of(Axis::r1)] - 8'000;
        const std::int64_t psi = std::llround(static_cast<double>(done) * 0.0025 / 360.0 * 6'400.0);
        return std::max({std::abs(at[index_of(Axis::r2)] - 12'000 + done),
                         std::abs(at[index_of(Axis::y)] - 4'000 - done),
                         std::abs(at[index_of(Axis::psi)] % 6'400 - psi)});
    }
    std::uint64_t records_taken() const { return program_report(*segment_view_).progress.taken; }
    /// The last record that a writer put whole, as the ring itself has it; the writer is dead.
    MotionRecord last_put() {
        const RecordRing ring = segment_view_->record_ring();
        const std::uint64_t last = ring.ends->written.load() - 1;
        std::array<std::uint64_t, sizeof(MotionRecord) / sizeof(std::uint64_t)> words{};
        for (std::size_t i = 0; i < words.size(); ++i)
            words[i] = ring.records[last % ring.capacity].words[i].load();
        MotionRecord record{};
        std::memcpy(static_cast<void*>(&record), words.data(), sizeof record);
        return record;
    }
    /// R1 of each record that waits: 20 to 30 mm, whose number has a bit that is a millimetre.
    void move_queued_r1_by_a_millimetre() {
        const RecordRing ring = segment_view_->record_ring();
        for (std::uint64_t i = 0; i < ring.capacity; ++i)
            ring.records[i].words[offsetof(MotionRecord, target) / sizeof(std::uint64_t)].fetch_xor(
                std::uint64_t{1} << 48U);
    }
    bool rests_in_program() {
        return eventually([&] {
            EXPECT_LE(off_way_pulses(status()), 2);
            const MachineState now = state();
            return now == MachineState::held || now == MachineState::ready;
        });
    }

    static constexpr std::uint64_t kManyRecords = 1'000;
    std::mt19937 random_{40977};
};

TEST_F(WriterDeath, AtAnyInstantLeavesTheMachineAtTheLastRecordThatItPut) {
    const int deaths = is_long_run() ? 300 : kIsSanitized ? 4 : 12;
    start_homed({"--program-ring", "64"});
    for (int death = 0; death < deaths; ++death) {
        ASSERT_NO_FATAL_FAILURE(go_to_begin());
        ChildProcess writer{writing()};
        ASSERT_TRUE(writer.wait_for_signal());
        ASSERT_TRUE(eventually([&] { return program_report(*segment_view_).running != 0; }));
        ASSERT_TRUE(run_numbered(program_report(*segment_view_).running));
        // Once the ring has gone round many times, else at any instant.
        ASSERT_TRUE(eventually([&] { return death > 0 || records_taken() > kManyRecords; }));
        std::this_thread::sleep_for(std::chrono::microseconds{random_() % 20'000});
        if (death % 2 == 1) {
            writer.stop();
            std::this_thread::sleep_for(std::chrono::microseconds{random_() % 5'000});
            EXPECT_NE(program_status().hold, ProgramHold::feeder_lost) << "stopped is not dead";
        }
        writer.kill();
        ASSERT_TRUE(rests_in_program()) << death;
        EXPECT_EQ(program_status().hold, ProgramHold::feeder_lost) << death;
        const std::uint64_t taken = records_taken();
        EXPECT_TRUE(death > 0 || taken > kManyRecords);
        EXPECT_EQ(last_put().program, program_status().program) << death;
        EXPECT_EQ(taken, last_put().sequence) << "what it put is run, " << death;
        const CoreStatus now = status();
        EXPECT_EQ(now.position_pulses[0], 8'000 + static_cast<std::int64_t>(taken % 4'000)) << death;
        EXPECT_EQ(off_way_pulses(now), 0) << death;
        request_stop(*segment_view_);
        ASSERT_TRUE(eventually([&] { return state() == MachineState::ready; }));
    }
}

TEST_F(WriterDeath, IsNotWorseThanARingThatIsOverwritten) {
    const int rounds = is_long_run() ? 150 : kIsSanitized ? 3 : 6;
    constexpr int kMutationsInARound = 20;
    int refused = 0;
    for (int round = 0; round < rounds; ++round) {
        if (round % 10 == 0) {
            if (core_) end_core();
            (void)Segment::remove(segment_);
            start_homed({"--program-ring", "64"});
        }
        ASSERT_NO_FATAL_FAILURE(go_to_begin());
        ChildProcess writer{writing()};
        ASSERT_TRUE(writer.wait_for_signal());
        ASSERT_TRUE(eventually([&] { return program_report(*segment_view_).running != 0; }));
        ASSERT_TRUE(run_numbered(program_report(*segment_view_).running));
        ASSERT_TRUE(eventually([&] { return program_status().line > 1; }));
        // A place that the machine could go to, a millimetre beside the way, is one that its check alone
        // tells. While the core sleeps all of the ring waits for it.
        const bool is_beside = round % 3 == 2;
        if (is_beside) {
            core_->send(SIGSTOP);
            EXPECT_TRUE(eventually([&] {
                const ProgramReport report = program_report(*segment_view_);
                return report.queued == report.ring_records;
            }));
            move_queued_r1_by_a_millimetre();
            core_->send(SIGCONT);
        }
        for (int i = 0; i < kMutationsInARound && !is_beside; ++i) {
            const RecordRing ring = segment_view_->record_ring();
            auto* bytes = reinterpret_cast<unsigned char*>(ring.records);
            std::size_t most = ring.capacity * sizeof(RingRecord);
            if (random_() % 3 == 0) {
                bytes = reinterpret_cast<unsigned char*>(ring.ends);
                most = sizeof(RingEnds);
            }
            bytes[random_() % most] ^= static_cast<unsigned char>(1 + random_() % 255);
            EXPECT_LE(off_way_pulses(status()), 2) << round;
            std::this_thread::sleep_for(std::chrono::microseconds{random_() % 300});
        }
        writer.kill();
        ASSERT_TRUE(rests_in_program()) << round;
        const ProgramHold hold = program_status().hold;
        EXPECT_TRUE(hold == ProgramHold::refused || hold == ProgramHold::feeder_lost) << round;
        EXPECT_TRUE(!is_beside || hold == ProgramHold::refused) << round;
        refused += hold == ProgramHold::refused ? 1 : 0;
        EXPECT_EQ(off_way_pulses(status()), 0) << round;
        request_stop(*segment_view_);
        ASSERT_TRUE(eventually([&] { return state() == MachineState::ready; }));
        EXPECT_FALSE(core_->has_ended()) << round;
    }
    // How many records go by between two mutations is the computer's load.
    EXPECT_GT(refused, 0) << "they hit words that count";
}

}  // namespace
}  // namespace psicarve::test
