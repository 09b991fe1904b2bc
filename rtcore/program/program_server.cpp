// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/program/program_server.hpp"

#include <cstring>
#include <mutex>
#include <utility>

#include "rtcore/program/record_intake.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::program {
namespace {

bool is_same(const ProgramStatus& a, const ProgramStatus& b) noexcept {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

/// The intake, and the segment that it reads. The planner may go on asking for steps of a program that is
/// over; by then the ring may be another one's.
class ProgramServer::Source final : public plan::StepSource {
public:
    Source(std::shared_ptr<Segment> segment, const ProgramFeed& feed, const Profile& profile)
        : segment_(std::move(segment)), intake_(feed, profile, {}) {}

    void begin(const plan::Pulses4& start_pulses) override {
        const std::lock_guard<std::mutex> lock(mutex_);
        intake_.begin(start_pulses);
    }
    plan::Supply next(plan::ProgramStep& step) override {
        const std::lock_guard<std::mutex> lock(mutex_);
        return is_closed_ ? plan::Supply::lost : intake_.next(step);
    }
    /// From here on the ring is not touched.
    void close() {
        const std::lock_guard<std::mutex> lock(mutex_);
        is_closed_ = true;
    }

private:
    std::mutex mutex_;  ///< never held for longer than one record takes
    std::shared_ptr<Segment> segment_;
    RecordIntake intake_;
    bool is_closed_ = false;
};

void ProgramServer::serve(const std::shared_ptr<Segment>& segment, const ProgramStatus& status) {
    if (segment != segment_) turn_to(segment);
    // Before its end is told: who sees the end finds the last line.
    tell(status);
    const bool runs = status.is_running != 0 && feed_ && status.program == feed_->program();
    // Whatever was answered, or was not: the tick knows.
    if (runs) phase_ = Phase::running;
    const bool is_unwanted =
        phase_ == Phase::given && (!feed_->has_writer() || desk_->asks_again(feed_->claim()));
    if ((phase_ == Phase::running && !runs) || is_unwanted) end_program();
    if (phase_ == Phase::idle) give_number();
}

void ProgramServer::turn_to(const std::shared_ptr<Segment>& segment) {
    if (phase_ != Phase::idle) end_program();
    segment_ = segment;
    desk_.emplace(*segment_, last_program_);
    told_ = {};
}

void ProgramServer::end_program() {
    if (source_ != nullptr) source_->close();
    source_.reset();
    desk_->end();
    feed_.reset();
    phase_ = Phase::idle;
}

void ProgramServer::give_number() {
    auto feed = desk_->open();
    if (!feed) return;
    last_program_ = desk_->last_program();
    feed_.emplace(*feed);
    phase_ = Phase::given;
}

void ProgramServer::tell(const ProgramStatus& status) {
    if (is_same(status, told_)) return;
    told_ = status;
    desk_->tell(status);
}

Result<std::shared_ptr<plan::StepSource>> ProgramServer::open(std::uint64_t program) {
    if (phase_ != Phase::given || program == 0 || feed_->program() != program)
        return error_from(ErrorCode::machine_refused,
                          message_of(MessageId::no_such_program, count_argument(program)));
    phase_ = Phase::asked;
    source_ = std::make_shared<Source>(segment_, *feed_, profile_);
    return std::shared_ptr<plan::StepSource>{source_};
}

void ProgramServer::note_answer(std::uint64_t program, bool is_done) noexcept {
    if (phase_ != Phase::asked || feed_->program() != program) return;
    if (is_done) {
        phase_ = Phase::running;
        return;
    }
    // Nothing was taken of it: it may be asked for again.
    source_->close();
    source_.reset();
    phase_ = Phase::given;
}

}  // namespace psicarve::program
