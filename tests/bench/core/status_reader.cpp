// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the status of a core 60 times a second, as a window does, until it is killed or the core ends. Prints
// how often.
//
//   status_reader SEGMENT

#include <chrono>
#include <cstdio>
#include <thread>

#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"

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
    constexpr std::chrono::nanoseconds kFrame{1'000'000'000 / 60};
    unsigned long reads = 0;
    auto next = std::chrono::steady_clock::now();
    while (segment->core_pid() != 0) {
        if (read_record(segment->header().status)) ++reads;
        next += kFrame;
        std::this_thread::sleep_until(next);
    }
    std::printf("%lu\n", reads);
    return 0;
}
