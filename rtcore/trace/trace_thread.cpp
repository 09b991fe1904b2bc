// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/trace/trace_thread.hpp"

#include <utility>

#include "rtcore/process/handler_stack.hpp"
#include "rtcore/process/side_thread.hpp"

namespace psicarve::trace {
namespace {

constexpr std::chrono::seconds kPatience{2};
constexpr std::chrono::hours kUntilSomethingHappens{24};

}  // namespace

TraceThread::TraceThread(std::unique_ptr<TraceWriter> writer)
    : shared_(std::make_shared<Shared>()), written_bytes_(writer->written_bytes()) {
    shared_->writer = std::move(writer);
    thread_ = std::thread{[shared = shared_] { run(*shared); }};
}

TraceThread::~TraceThread() {
    const bool has_been_waited_for = shared_->must_finish.load();
    shared_->must_drop.store(!has_been_waited_for);
    shared_->must_finish.store(true);
    event_signal(shared_->told);
    if (wait_until_finished(has_been_waited_for ? std::chrono::seconds{0} : kPatience)) {
        thread_.join();
    } else {
        thread_.detach();
    }
}

bool TraceThread::put_job(const TracedJob& job) noexcept {
    JobPlace& place = shared_->jobs[next_job_place_];
    if (room() == 0 || !takes_job()) return false;
    place.job = job;
    place.is_full.store(true);
    TraceEntry entry{};
    entry.kind = TraceEntry::Kind::job;
    entry.token = next_job_place_;
    next_job_place_ = (next_job_place_ + 1) % kJobPlaces;
    return put(entry);
}

void TraceThread::wake() {
    event_signal(shared_->told);
}

void TraceThread::flush() {
    shared_->must_flush.store(true);
    event_signal(shared_->told);
}

void TraceThread::finish(std::uint64_t end_tick, bool is_whole) {
    shared_->end_tick = end_tick;
    shared_->is_whole = is_whole;
    shared_->must_finish.store(true);
    event_signal(shared_->told);
}

bool TraceThread::wait_until_finished(std::chrono::milliseconds limit) {
    const std::uint32_t seen = event_count(shared_->finished);
    if (!shared_->has_finished.load()) event_wait_past(shared_->finished, seen, limit);
    return shared_->has_finished.load();
}

std::optional<Error> TraceThread::take_error() {
    if (is_error_taken_ || !shared_->has_error.load()) return std::nullopt;
    is_error_taken_ = true;
    return shared_->error;
}

void TraceThread::note_error(Shared& shared) {
    auto error = shared.writer->take_error();
    if (!error || shared.has_error.load()) return;
    shared.error = std::move(error);
    shared.has_error.store(true);
}

void TraceThread::write(Shared& shared, const TraceEntry& entry) {
    if (entry.kind != TraceEntry::Kind::job) return shared.writer->add(entry);
    JobPlace& place = shared.jobs[entry.token];
    shared.writer->add_job(place.job);
    place.job = {};
    place.is_full.store(false);
}

void TraceThread::run(Shared& shared) {
    const rtcore::HandlerStack handler_stack;
    rtcore::lower_own_priority();
    TraceEntry entry{};
    for (;;) {
        const std::uint32_t seen = event_count(shared.told);
        if (shared.must_finish.load()) break;
        const bool must_flush = shared.must_flush.exchange(false);
        while (shared.ring.pop_into(entry)) write(shared, entry);
        if (must_flush) shared.writer->flush();
        note_error(shared);
        event_wait_past(shared.told, seen, kUntilSomethingHappens);
    }
    const bool must_drop = shared.must_drop.load();
    while (!must_drop && shared.ring.pop_into(entry)) write(shared, entry);
    if (shared.is_whole && !must_drop) shared.writer->finish(shared.end_tick);
    shared.writer->flush();
    note_error(shared);
    shared.writer.reset();
    shared.has_finished.store(true);
    event_signal(shared.finished);
}

}  // namespace psicarve::trace
