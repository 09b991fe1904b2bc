// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/record_feeder.hpp"

#include <poll.h>

#include <chrono>
#include <utility>

#include "hmi/gcode/judged_motion.hpp"

namespace psicarve::cli {
namespace {

/// Between two looks at whether it is still wanted.
constexpr std::chrono::milliseconds kLook{100};
/// Records that the core has taken and not carried out: its queue of blocks, of which a record is one at
/// least unless it leads nowhere, and what it plans at a time. With room to spare.
constexpr std::size_t kMostHeldByCore = 24'576;

Error given_up() {
    return Error{ErrorCode::cancelled, "the program was given up"};
}

}  // namespace

/// Into the ring, however long that takes.
class RecordFeeder::Sink : public gcode::RecordSink {
public:
    Sink(RecordFeeder& feeder, std::uint64_t most_records) : feeder_(feeder), most_records_(most_records) {}

    Result<void> take(const MotionRecord& record) override {
        if (feeder_.records_written_.load() == most_records_) return given_up();
        feeder_.trail_.note(record);
        for (;;) {
            const ProgramPut put = feeder_.writer_.put_for(record, kLook);
            if (put == ProgramPut::done) {
                feeder_.records_written_.fetch_add(1);
                return {};
            }
            if (put != ProgramPut::full) return feeder_.writer_.error_of(put);
            if (feeder_.is_given_up_.load()) return given_up();
        }
    }

private:
    RecordFeeder& feeder_;
    std::uint64_t most_records_;
};

RecordFeeder::RecordFeeder(Program program, const Profile& profile, ProgramWriter& writer)
    : writer_(writer),
      trail_(profile.gcode, program.language.start, program.ring_records + kMostHeldByCore),
      offsets_(program.language.offsets) {
    thread_ = std::thread{[this, profile, program = std::move(program)]() mutable {
        feed(std::move(program), profile);
        is_done_.store(true, std::memory_order_release);
    }};
}

RecordFeeder::~RecordFeeder() {
    give_up();
    wait();
}

void RecordFeeder::wait() {
    if (thread_.joinable()) thread_.join();
}

/// A terminal or a pipe may stay silent: then there must be a way out of the waiting.
gcode::ProgramBytes RecordFeeder::patient(gcode::ProgramBytes bytes, int awaited_fd) const {
    const auto wait = [this, read = std::move(bytes.read),
                       awaited_fd](std::span<char> room) -> Result<std::size_t> {
        pollfd awaited{awaited_fd, POLLIN, 0};
        while (!is_given_up_.load()) {
            if (awaited_fd < 0 || poll(&awaited, 1, static_cast<int>(kLook.count())) > 0) return read(room);
        }
        return given_up();
    };
    return {wait, std::move(bytes.seek)};
}

void RecordFeeder::feed(Program program, const Profile& profile) {
    Sink sink{*this, program.most_records};
    gcode::RecordMaker maker{profile, program.run, sink};
    gcode::JudgedMotion motion{profile, problems_, maker, offsets_, trail_};
    gcode::LineSource lines{patient(std::move(program.bytes), program.awaited_fd)};
    const auto facts = gcode::interpret_program(lines, program.language, motion, problems_);
    motion.end_block();
    if (!facts) failure_ = facts.error();
    if (facts) facts_ = *facts;
    if (facts && problems_.error_count() == 0 && maker.wants_more() && program.before_end)
        program.before_end(offsets_);
    trail_.begin_way(maker.record_count() + 1);
    // Where it breaks off the machine comes to rest in order, spindle off.
    if (const auto ended = maker.finish(); !ended && !failure_) failure_ = ended.error();
    writer_.close();
}

}  // namespace psicarve::cli
