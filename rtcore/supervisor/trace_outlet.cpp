// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/trace_outlet.hpp"

namespace psicarve::supervisor {

Result<void> TraceOutlet::open(const std::vector<std::string>& paths, const trace::TraceStart& start) {
    for (const std::string& path : paths) {
        auto writer = trace::open_trace(path, start);
        if (!writer) return writer.error();
        writers_.push_back(Named{path, std::move(*writer)});
    }
    return {};
}

void TraceOutlet::drain(trace::TraceRing& ring) {
    while (const trace::TraceEntry* entry = ring.front()) {
        for (const Named& named : writers_) named.writer->add(*entry);
        ring.pop();
    }
}

void TraceOutlet::flush() {
    for (const Named& named : writers_) named.writer->flush();
}

void TraceOutlet::finish(std::uint64_t end_tick) {
    for (const Named& named : writers_) named.writer->finish(end_tick);
}

std::vector<std::string> TraceOutlet::take_errors() {
    std::vector<std::string> lines;
    for (const Named& named : writers_) {
        if (const auto error = named.writer->take_error()) lines.push_back(error->message);
    }
    return lines;
}

}  // namespace psicarve::supervisor
