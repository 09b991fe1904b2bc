// SPDX-License-Identifier: GPL-3.0-or-later
// How many motion records a second go from one process through the ring of a segment into the core's intake,
// which checks each; beside it, in turns, the same 88 bytes a record through a pipe whose reader looks at
// nothing. Five runs of each; in the end the median of the ratios, wanted at least 1. Then ten million
// records through one ring: by how much the resident memory of either process grows, wanted less than 16 MB.
// Ends with 1 when either is missed. Records of a run, and of the long one, may be given.
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "rtcore/program/record_intake.hpp"
#include "shared/computer/process_identity.hpp"
#include "shared/segment/segment_program.hpp"

namespace {

using namespace psicarve;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kRuns = 5;
constexpr double kLeastRatio = 1.0;
constexpr double kMostGrowthMb = 16.0;
constexpr milliseconds kPatience{60'000};

MotionRecord way_record(std::uint64_t number) {
    MotionRecord record{};
    record.line = number;
    record.kind = MotionKind::way;
    record.axes = 0xF;
    const auto step = static_cast<double>(number % 4'000) * 0.0025;
    record.target = {20.0 + step, 30.0 - step, step, 10.0 + step};
    return record;
}

double resident_mb(pid_t pid) {
    std::ifstream file{"/proc/" + std::to_string(pid) + "/statm"};
    double all = 0.0;
    double resident = 0.0;
    file >> all >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) * 1e-6;
}

template <typename Work>
pid_t in_a_process(const Work& work) {
    const pid_t pid = ::fork();
    if (pid != 0) return pid;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    work();
    ::_exit(0);
}

struct Outcome {
    double records_per_s = 0.0;
    double reader_growth_mb = 0.0;
    double writer_growth_mb = 0.0;
};

Outcome through_the_ring(std::uint64_t count) {
    SegmentOptions options;
    options.name = "/" + named_after_this_process("psicarve-bench-");
    Segment segment = Segment::create_or_attach(options).value();
    if (!segment.claim_core()) std::exit(2);
    const pid_t writer = in_a_process([&] {
        Segment own = Segment::attach(options.name).value();
        ProgramWriter sut = ProgramWriter::claim(own).value();
        if (!sut.begin(kPatience)) ::_exit(1);
        for (std::uint64_t i = 1; i <= count; ++i)
            if (sut.put(way_record(i)) != ProgramPut::done) ::_exit(1);
        sut.close();
    });
    ProgramDesk desk{segment};
    auto feed = desk.open();
    for (; !feed; feed = desk.open()) std::this_thread::sleep_for(milliseconds{1});
    program::RecordIntake intake{*feed, Profile{}, {}};
    plan::ProgramStep step;
    Outcome outcome;
    // Once the whole ring has been touched by both.
    const std::uint64_t warm = std::min<std::uint64_t>(count / 4, 100'000);
    Clock::time_point begin = Clock::now();
    for (std::uint64_t taken = 0; taken < count;) {
        const plan::Supply supply = intake.next(step);
        if (supply == plan::Supply::later) {
            intake.wait_for(milliseconds{100});
            continue;
        }
        if (supply != plan::Supply::step) std::exit(2);
        if (++taken == warm) {
            begin = Clock::now();
            outcome.reader_growth_mb = -resident_mb(::getpid());
            outcome.writer_growth_mb = -resident_mb(writer);
        }
        if (taken + kDefaultRingRecords == count) outcome.writer_growth_mb += resident_mb(writer);
    }
    outcome.records_per_s =
        static_cast<double>(count - warm) / std::chrono::duration<double>(Clock::now() - begin).count();
    outcome.reader_growth_mb += resident_mb(::getpid());
    ::waitpid(writer, nullptr, 0);
    (void)Segment::remove(options.name);
    return outcome;
}

double through_a_pipe(std::uint64_t count) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) std::exit(2);
    const pid_t writer = in_a_process([&] {
        for (std::uint64_t i = 1; i <= count; ++i) {
            const MotionRecord record = way_record(i);
            if (::write(ends[1], &record, sizeof(record)) != sizeof(record)) ::_exit(1);
        }
    });
    ::close(ends[1]);
    const Clock::time_point begin = Clock::now();
    std::uint64_t sum = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        MotionRecord record{};
        std::size_t got = 0;
        while (got < sizeof(record)) {
            const ssize_t more =
                ::read(ends[0], reinterpret_cast<char*>(&record) + got, sizeof(record) - got);
            if (more <= 0) std::exit(2);
            got += static_cast<std::size_t>(more);
        }
        sum += record.line;
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    ::close(ends[0]);
    ::waitpid(writer, nullptr, 0);
    return sum == 0 ? 0.0 : static_cast<double>(count) / seconds;
}

}  // namespace

int main(int argc, char** argv) {
    const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
    const std::uint64_t long_count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10'000'000;
    if (count < 100'000 || long_count < 100'000) {
        std::fprintf(stderr, "program_ring: at least 100000 records\n");
        return 2;
    }
    std::vector<double> ratios;
    for (int run = 0; run < kRuns; ++run) {
        const double ring = through_the_ring(count).records_per_s;
        const double pipe = through_a_pipe(count);
        ratios.push_back(ring / pipe);
        std::printf("ring %.2f million records/s, pipe %.2f, ratio %.2f\n", ring * 1e-6, pipe * 1e-6,
                    ratios.back());
    }
    std::sort(ratios.begin(), ratios.end());
    const double ratio = ratios[ratios.size() / 2];
    const Outcome outcome = through_the_ring(long_count);
    std::printf("ratio %.2f (wanted: at least %.2f)\n", ratio, kLeastRatio);
    std::printf(
        "%.1f million records: resident memory of the core's side grows by %.2f MB, of the writer by %.2f "
        "MB (wanted: less than %.0f), %.2f million records/s\n",
        static_cast<double>(long_count) * 1e-6, outcome.reader_growth_mb, outcome.writer_growth_mb,
        kMostGrowthMb, outcome.records_per_s * 1e-6);
    const bool is_kept = ratio >= kLeastRatio && outcome.reader_growth_mb < kMostGrowthMb &&
                         outcome.writer_growth_mb < kMostGrowthMb;
    return is_kept ? 0 : 1;
}
