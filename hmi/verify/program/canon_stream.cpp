// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/program/canon_stream.hpp"

#include <string>
#include <utility>

#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/problem.hpp"
#include "hmi/gcode/program_check.hpp"

namespace psicarve::verify {
namespace {

constexpr std::size_t kRecordsAtOnce = 1024;

Error error_of(const gcode::Problem& problem) {
    return bad_input("line " + std::to_string(problem.line) + ": " + gcode::what_text(problem));
}

}  // namespace

class CanonStream::Sink : public gcode::CanonSink {
public:
    Sink(CanonStream& stream, const Profile& profile, gcode::ProblemList& problems)
        : stream_(stream), machine_(profile, problems) {}

    void take(const gcode::CanonRecord& record) override {
        machine_.take(record);
        records_.push_back(record);
        if (records_.size() >= kRecordsAtOnce) flush();
    }
    bool wants_more() const noexcept override { return is_wanted_; }
    void flush() { is_wanted_ = stream_.put(records_); }

private:
    CanonStream& stream_;
    gcode::MachineCheck machine_;
    std::vector<gcode::CanonRecord> records_;
    bool is_wanted_ = true;
};

CanonStream::CanonStream(const Opener& open, const gcode::InterpreterOptions& language,
                         const Profile& profile) {
    thread_ = std::thread{[this, open, language, profile] { read(open, language, profile); }};
}

CanonStream::~CanonStream() {
    {
        const std::lock_guard lock{mutex_};
        is_given_up_ = true;
    }
    was_changed_.notify_all();
    thread_.join();
}

void CanonStream::read(const Opener& open, const gcode::InterpreterOptions& language,
                       const Profile& profile) {
    gcode::ProblemList problems;
    Sink sink{*this, profile, problems};
    auto bytes = open();
    std::optional<Error> failure;
    if (bytes) {
        gcode::LineSource lines{std::move(bytes).value()};
        const auto facts = gcode::interpret_program(lines, language, sink, problems);
        if (!facts) failure = facts.error();
        if (facts && problems.error_count() > 0) failure = error_of(problems.errors().front());
    } else {
        failure = bytes.error();
    }
    sink.flush();
    {
        const std::lock_guard lock{mutex_};
        failure_ = std::move(failure);
        is_over_ = true;
    }
    was_changed_.notify_all();
}

/// Waits until the last ones are taken. False: no more are taken.
bool CanonStream::put(std::vector<gcode::CanonRecord>& records) {
    std::unique_lock lock{mutex_};
    was_changed_.wait(lock, [this] { return waiting_.empty() || is_given_up_; });
    std::swap(waiting_, records);
    records.clear();
    const bool is_wanted = !is_given_up_;
    lock.unlock();
    was_changed_.notify_all();
    return is_wanted;
}

std::optional<Error> CanonStream::failure() const {
    const std::lock_guard lock{mutex_};
    return failure_;
}

std::optional<gcode::CanonRecord> CanonStream::next() {
    if (next_ == taken_.size()) {
        taken_.clear();
        next_ = 0;
        std::unique_lock lock{mutex_};
        was_changed_.wait(lock, [this] { return !waiting_.empty() || is_over_; });
        std::swap(taken_, waiting_);
        lock.unlock();
        was_changed_.notify_all();
        if (taken_.empty()) return std::nullopt;
    }
    return taken_[next_++];
}

}  // namespace psicarve::verify
