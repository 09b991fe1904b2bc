// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to show any instant of a long trace: reading it once, a jump against a read from the begin,
// the last twenty seconds for the timing diagram, and the piece at another time. With a file name: that
// trace (and the job beside it); else one of 200 x 500 points.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "hmi/replay/carving_timeline.hpp"
#include "hmi/replay/pin_looks.hpp"
#include "hmi/replay/recording.hpp"
#include "hmi/replay/trace_cursor.hpp"
#include "tests/hmi/verify/perfect_machine.hpp"

namespace {

using namespace psicarve;
using namespace psicarve::replay;

double seconds_of(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Cost {
    double median_ms;
    double most_ms;
};
Cost cost_of(std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    return {1e3 * seconds[seconds.size() / 2], 1e3 * seconds.back()};
}
void print(const char* what, const Cost& cost) {
    std::printf("%-34s median %9.3f ms, most %9.3f ms\n", what, cost.median_ms, cost.most_ms);
}

std::string made_trace() {
    const verify::SampleJob job(
        Profile{}, 200, 500, Joining::continuous, [](double angle, std::uint32_t layer) {
            return 12.0 + 1.5 * std::cos(5.0 * angle) + 0.6 * std::sin(13.0 * angle + 0.02 * layer);
        });
    verify::PerfectMachine machine(job);
    machine.carve_job();
    const std::string stem = "/tmp/psicarve_scrub_bench_" + std::to_string(::getpid());
    std::ofstream(stem + ".trace", std::ios::binary) << verify::as_binary(machine.start, machine.events);
    Snapshot file;
    file.job_blob = job.blob;
    if (const auto saved = save_snapshot(file, stem + ".job"); !saved)
        std::fprintf(stderr, "%s\n", saved.error().message.c_str());
    return stem;
}

int measure(const std::string& path) {
    Result<std::unique_ptr<Recording>> opened = bad_input("not opened");
    const double open_s = seconds_of([&] { opened = open_recording({path, {}, Profile{}}, {}); });
    if (!opened) {
        std::fprintf(stderr, "%s\n", opened.error().message.c_str());
        return 1;
    }
    const auto index = (*opened)->index();
    const std::int64_t end_ns = index->end_ns();
    std::printf(
        "%.1f million events in %.0f s of machine time; read once: %.2f s, %.1f million/s; %zu keyframes, "
        "%.1f MB\n",
        static_cast<double>(index->events()) / 1e6, static_cast<double>(end_ns) / 1e9, open_s,
        static_cast<double>(index->events()) / open_s / 1e6, index->keyframes().size(),
        static_cast<double>(index->keyframes().size() * sizeof(TraceIndex::Keyframe)) / 1e6);
    std::mt19937_64 random{5};
    std::uniform_int_distribution<std::int64_t> any_time{0, end_ns};
    std::vector<double> jumps;
    std::vector<double> reads;
    std::vector<double> looks;
    TraceCursor cursor{index};
    for (int i = 0; i < 500; ++i) {
        const std::int64_t time_ns = any_time(random);
        jumps.push_back(seconds_of([&] { (void)cursor.at(time_ns); }));
        if (i % 25 != 0) continue;
        TraceCursor from_begin{index};
        reads.push_back(
            seconds_of([&] { (void)from_begin.go_on(time_ns, [](const auto&, const auto&) {}); }));
        PinLooks fresh{index};
        looks.push_back(seconds_of([&] { (void)fresh.until(time_ns); }));
    }
    print("jump to any instant", cost_of(jumps));
    print("linear read from the begin", cost_of(reads));
    std::printf("%-34s %.0f\n", "ratio of the medians", cost_of(reads).median_ms / cost_of(jumps).median_ms);
    print("last 20 s for the timing diagram", cost_of(looks));
    const auto job = (*opened)->facts().job;
    if (!job) return 0;
    Result<std::shared_ptr<const CarvingTimeline>> timeline = bad_input("not made");
    const double made_s = seconds_of([&] { timeline = CarvingTimeline::of_trace(job, index, {}); });
    auto record = session::CarvingRecord::make(job);
    if (!timeline || !record) return 1;
    std::vector<double> pieces;
    std::size_t cuts = 0;
    for (int i = 0; i < 100; ++i) {
        const std::int64_t time_ns = any_time(random);
        pieces.push_back(
            seconds_of([&] { cuts = (*timeline)->apply(**record, cuts, time_ns, (*timeline)->cuts()); }));
    }
    std::printf("the piece: %zu cuts, worked out once in %.2f s\n", (*timeline)->cuts(), made_s);
    print("the piece at another time", cost_of(pieces));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1) return measure(argv[1]);
    const std::string stem = made_trace();
    const int exit_code = measure(stem + ".trace");
    ::unlink((stem + ".trace").c_str());
    ::unlink((stem + ".job").c_str());
    return exit_code;
}
