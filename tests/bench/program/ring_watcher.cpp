// SPDX-License-Identifier: GPL-3.0-or-later
// Watches the ring of the program that a core runs, 500 times a second, until it is told to end (SIGTERM),
// the program is over, or the core ends. Beside bench_starvation.py.
//
//   ring_watcher SEGMENT
//
// Prints one JSON object: how many looks there were, the least records that waited for the core once the ring
// had been full (while its writer had more), lines and starvations of the program, and of the core over the
// same time its ticks and those missed.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <utility>

#include "shared/segment/segment.hpp"
#include "shared/segment/segment_program.hpp"
#include "shared/segment/shared_record.hpp"

namespace {

volatile std::sig_atomic_t is_over = 0;

struct Watched {
    unsigned long looks = 0;
    std::uint32_t least = 0;
    bool was_full = false;
    std::uint64_t first_sequence = 0;
    psicarve::ProgramReport last{};
};

void look(Watched& watched, const psicarve::ProgramReport& report) {
    if (report.status.is_running == 0 || report.writer_pid == 0) return;
    if (!watched.was_full && report.queued == report.ring_records) {
        watched.was_full = true;
        watched.least = report.queued;
        watched.first_sequence = report.status.sequence;
    }
    watched.least = std::min(watched.least, report.queued);
    watched.last = report;
    ++watched.looks;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace psicarve;
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s SEGMENT\n", argv[0]);
        return 2;
    }
    const auto segment = Segment::attach(argv[1]);
    if (!segment) {
        std::fprintf(stderr, "%s\n", segment.error().message.c_str());
        return 5;
    }
    std::signal(SIGTERM, [](int) { is_over = 1; });
    constexpr std::chrono::milliseconds kLook{2};
    const auto first = read_record(segment->header().status);
    Watched watched;
    while (is_over == 0 && segment->core_pid() != 0) {
        const ProgramReport report = program_report(*segment);
        if (watched.looks > 0 && report.status.is_running == 0) break;
        look(watched, report);
        std::this_thread::sleep_for(kLook);
    }
    const auto last = read_record(segment->header().status);
    if (!first || !last || !watched.was_full) {
        std::fprintf(stderr, "%s: the ring was never full\n", argv[0]);
        return 1;
    }
    const auto& [status, ring] = std::pair{watched.last.status, watched.last.ring_records};
    std::printf(
        "{\"looks\": %lu, \"least\": %u, \"ring\": %u, \"records\": %llu, \"starvations\": %llu, \"ticks\": "
        "%llu, "
        "\"missed\": %llu}\n",
        watched.looks, watched.least, ring,
        static_cast<unsigned long long>(status.sequence - watched.first_sequence),
        static_cast<unsigned long long>(status.starvations),
        static_cast<unsigned long long>(last->tick - first->tick),
        static_cast<unsigned long long>(last->missed_ticks - first->missed_ticks));
    return 0;
}
