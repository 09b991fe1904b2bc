// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/trace_outlet.hpp"

#include <utility>

#include "rtcore/trace/binary_writer.hpp"
#include "rtcore/trace/vcd_writer.hpp"
#include "shared/trace_output.hpp"

namespace psicarve::supervisor {

Result<void> TraceOutlet::open(const std::vector<std::string>& paths, const trace::TraceStart& start) {
    period_ns_ = start.period_ns;
    for (const std::string& path : paths) {
        auto writer = trace::open_trace(path, start);
        if (!writer) return writer.error();
        writers_.push_back(Named{path, std::move(*writer)});
    }
    return {};
}

void TraceOutlet::set_recording_taker(RecordingTaker taker) {
    drop_recording();
    recording_taker_ = std::move(taker);
}

void TraceOutlet::drain(trace::TraceRing& ring) {
    while (const trace::TraceEntry* entry = ring.front()) {
        add(*entry);
        ring.pop();
    }
}

void TraceOutlet::add(const trace::TraceEntry& entry) {
    using Kind = trace::TraceEntry::Kind;
    if (entry.kind == Kind::begin_binary || entry.kind == Kind::begin_vcd) return begin_recording(entry);
    if (entry.kind == Kind::end) return end_recording(entry.tick);
    for (const Named& named : writers_) named.writer->add(entry);
    if (!recording_) return;
    trace::TraceEntry shifted = entry;
    shifted.tick -= recording_->first_tick;
    recording_->writer->add(shifted);
}

void TraceOutlet::begin_recording(const trace::TraceEntry& entry) {
    drop_recording();
    if (!recording_taker_) return;
    const trace::TraceStart start{period_ns_, entry.levels, entry.position_pulses};
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
    for (const Named& named : writers_) named.writer->flush();
    if (recording_) recording_->writer->flush();
}

void TraceOutlet::finish(std::uint64_t end_tick) {
    for (const Named& named : writers_) named.writer->finish(end_tick);
    end_recording(end_tick);
}

std::vector<std::string> TraceOutlet::take_errors() {
    std::vector<std::string> lines;
    for (const Named& named : writers_) {
        if (const auto error = named.writer->take_error()) lines.push_back(error->message);
    }
    return lines;
}

}  // namespace psicarve::supervisor
