// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/trace/trace_outlet.hpp"

#include <algorithm>
#include <utility>

#include "rtcore/trace/binary_writer.hpp"
#include "rtcore/trace/vcd_writer.hpp"
#include "shared/trace/trace_output.hpp"

namespace psicarve::supervisor {

Result<void> TraceOutlet::open(const std::vector<std::string>& paths, const trace::TraceStart& start) {
    period_ns_ = start.period_ns;
    for (const std::string& path : paths) {
        auto writer = trace::open_trace(path, start);
        if (!writer) return writer.error();
        files_.push_back(File{path, std::make_unique<trace::TraceThread>(std::move(*writer))});
    }
    return {};
}

void TraceOutlet::set_recording_taker(RecordingTaker taker) {
    drop_recording();
    recording_taker_ = std::move(taker);
}

bool TraceOutlet::has_room() const noexcept {
    return when_full_ == WhenFull::loses || std::ranges::all_of(files_, [](const File& file) {
               return file.thread->room() > 0 && file.thread->takes_job();
           });
}

void TraceOutlet::drain(trace::TraceRing& ring) {
    bool has_news = false;
    while (const trace::TraceEntry* entry = has_room() ? ring.front() : nullptr) {
        add(*entry);
        ring.pop();
        has_news = true;
    }
    if (!has_news) return;
    has_unflushed_ = true;
    for (const File& file : files_) file.thread->wake();
}

void TraceOutlet::add_job(std::uint32_t generation) {
    // If another job is set, it is not the one that the pins carve now.
    if (!job_ || static_cast<std::uint32_t>(job_->generation) != generation) return;
    for (File& file : files_) {
        if (file.carried_checksum == job_->checksum) continue;
        if (file.thread->put_job(*job_)) {
            file.carried_checksum = job_->checksum;
            continue;
        }
        errors_.push_back("trace " + file.path + ": it is read or written too slowly to carry its job, too");
    }
}

void TraceOutlet::add(const trace::TraceEntry& entry) {
    using Kind = trace::TraceEntry::Kind;
    if (entry.kind == Kind::begin_binary || entry.kind == Kind::begin_vcd) return begin_recording(entry);
    if (entry.kind == Kind::end) return end_recording(entry.tick);
    if (entry.kind == Kind::job) return add_job(entry.token);
    for (File& file : files_) {
        if (!file.thread->put(entry)) lose(file, entry);
    }
    if (!recording_) return;
    trace::TraceEntry shifted = entry;
    shifted.tick -= recording_->first_tick;
    recording_->writer->add(shifted);
}

void TraceOutlet::lose(File& file, const trace::TraceEntry& entry) {
    ++lost_;
    if (file.lost++ > 0) return;
    errors_.push_back("trace " + file.path +
                      ": it is read or written more slowly than pins change; from tick " +
                      std::to_string(entry.tick) + " on changes are missing in it");
}

void TraceOutlet::begin_recording(const trace::TraceEntry& entry) {
    drop_recording();
    if (!recording_taker_) return;
    const trace::TraceStart start{period_ns_, entry.levels, entry.position_pulses, entry.crossed_pulses};
    TraceOutput out{[this, token = entry.token](std::span<const std::uint8_t> bytes) {
        if (recording_) recording_taker_(token, bytes);  // else it was dropped
    }};
    std::unique_ptr<trace::TraceWriter> writer;
    if (entry.kind == trace::TraceEntry::Kind::begin_vcd) {
        writer = std::make_unique<trace::VcdWriter>(std::move(out), start);
    } else {
        writer = std::make_unique<trace::BinaryWriter>(std::move(out), start);
    }
    recording_ = Recording{entry.token, entry.tick, std::move(writer)};
}

void TraceOutlet::end_recording(std::uint64_t tick) {
    if (!recording_) return;
    recording_->writer->finish(tick - recording_->first_tick);
    recording_taker_(recording_->token, {});
    recording_.reset();
}

void TraceOutlet::flush() {
    if (!std::exchange(has_unflushed_, false)) return;
    for (const File& file : files_) file.thread->flush();
    if (recording_) recording_->writer->flush();
}

void TraceOutlet::finish(std::uint64_t end_tick, std::uint64_t lost_before) {
    for (const File& file : files_) {
        const std::uint64_t lost = file.lost + lost_before;
        file.thread->finish(end_tick, lost == 0);
        if (lost > 0) {
            errors_.push_back("trace " + file.path + ": " + std::to_string(lost) +
                              " pin changes are missing in it; it is not complete");
        }
    }
    end_recording(end_tick);
}

bool TraceOutlet::wait_until_finished(std::chrono::milliseconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    return std::ranges::all_of(files_, [&](const File& file) {
        const auto left = end - std::chrono::steady_clock::now();
        return file.thread->wait_until_finished(std::chrono::ceil<std::chrono::milliseconds>(left));
    });
}

std::size_t TraceOutlet::left() const noexcept {
    std::size_t sum = 0;
    for (const File& file : files_) sum += file.thread->left();
    return sum;
}

std::uint64_t TraceOutlet::written_bytes() const noexcept {
    std::uint64_t sum = 0;
    for (const File& file : files_) sum += file.thread->written_bytes();
    return sum;
}

void TraceOutlet::give_up() {
    for (const File& file : files_) {
        if (file.thread->wait_until_finished(std::chrono::milliseconds{0})) continue;
        errors_.push_back("trace " + file.path +
                          ": nobody takes what is written any more; it ends there and is not complete");
    }
}

std::vector<std::string> TraceOutlet::take_errors() {
    for (const File& file : files_) {
        if (const auto error = file.thread->take_error()) errors_.push_back(error->message);
    }
    return std::exchange(errors_, {});
}

}  // namespace psicarve::supervisor
