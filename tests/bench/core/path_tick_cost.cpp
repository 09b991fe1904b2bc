// SPDX-License-Identifier: GPL-3.0-or-later
// What a tick costs on a timed curve of four axes, with a port that does nothing: the whole tick and its
// executor alone, at the planned feed, and while an override changes every 2 000 ticks. Segments of 4, 16 and
// 64 iterations; the motion is that of a smooth body at about one iteration in three ticks.
#include <x86intrin.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "rtcore/cycle/cycle.hpp"
#include "tests/bench/core/null_port.hpp"

namespace {

using namespace psicarve;  // NOLINT(google-build-using-namespace)

constexpr double kTick_s = 5e-5;
constexpr std::size_t kTicks = 4'000'000;
constexpr std::size_t kBatch = 16;  // reading the counter takes as long as a tick

/// Endless path segments: psi the long axis, the others to and fro, the speed waves by a third.
class Segments {
public:
    explicit Segments(std::int64_t iterations) : iterations_(iterations) {}

    cycle::MotionBlock next(std::uint32_t epoch) {
        cycle::MotionBlock block{};
        block.kind = cycle::BlockKind::path;
        block.epoch = epoch;
        block.group_blocks = number_ == 0 ? 0xFFFFFFFFU : 0;
        const double angle = static_cast<double>(number_) * 0.05;
        const auto part = [&](double phase) {
            return static_cast<std::int64_t>(
                std::lround(static_cast<double>(iterations_) * std::sin(angle + phase)));
        };
        block.delta_pulses = {part(0.0), part(1.0), iterations_, part(2.0)};
        block.path.length = static_cast<double>(iterations_);
        for (std::size_t p = 0; p < 2; ++p) {
            block.path.start_speed2[p] = speed2(angle) * (p == 0 ? 1.0 : 2.0);
            block.path.end_speed2[p] = speed2(angle + 0.05) * (p == 0 ? 1.0 : 2.0);
        }
        block.path.accel_free.fill(static_cast<float>(1e-4 / (kTick_s * kTick_s)));
        block.path.accel_bend.fill(1e-5F);
        block.path.start_stop_speed = static_cast<float>(0.02 / kTick_s);
        block.reaches_points = number_ % 4 == 3 ? 1 : 0;
        ++number_;
        return block;
    }

private:
    static double speed2(double angle) {
        const double speed = 0.3 + 0.1 * std::sin(0.7 * angle);
        return speed * speed / (kTick_s * kTick_s);
    }
    std::int64_t iterations_;
    std::uint64_t number_ = 0;
};

/// A cycle that carves them; this program is its planner.
struct Core {
    explicit Core(std::int64_t iterations)
        : io(std::make_unique<cycle::CycleIo>()),
          cycle(cycle::CycleConfig{}, port, *io),
          segments(iterations) {
        cycle.assume_homed({});
        ask(cycle::RequestKind::job_loaded, 1);
        ask(cycle::RequestKind::start, 0);
        answer_plan(cycle::BlockKind::program_end);
        cycle.tick();
        if (cycle.state() != MachineState::waiting) {
            std::printf("the core did not start; there is nothing to measure\n");
            std::exit(1);
        }
        cycle::PlanRequest request{};
        while (io->plan_requests.pop_into(request)) epoch = request.epoch;
        fill();
        ask(cycle::RequestKind::start_interpolation, 0);
    }
    void ask(cycle::RequestKind kind, std::uint64_t value) {
        cycle::Request request{};
        request.kind = kind;
        request.value = value;
        request.points_total = request.points_per_layer = 1'000'000'000;
        io->requests.push(request);
        cycle.tick();
    }
    void answer_plan(cycle::BlockKind kind) {
        cycle::PlanRequest request{};
        cycle::MotionBlock block{};
        while (io->plan_requests.pop_into(request)) block.epoch = request.epoch;
        block.kind = kind;
        io->blocks.push(block);
    }
    void fill() {
        while (io->blocks.size() < cycle::kBlockRingEntries) io->blocks.push(segments.next(epoch));
        cycle::Report report;
        while (io->reports.pop_into(report)) {
        }
        IncrementEntry entry;
        while (io->increments.pop_into(entry)) {
        }
    }

    bench::NullPort port;
    std::unique_ptr<cycle::CycleIo> io;
    cycle::Cycle cycle;
    Segments segments;
    std::uint32_t epoch = 0;
};

double ns_per_count() {
    using Clock = std::chrono::steady_clock;
    const auto start_time = Clock::now();
    const std::uint64_t start = __rdtsc();
    while (Clock::now() - start_time < std::chrono::milliseconds{100}) {
    }
    const std::chrono::duration<double, std::nano> passed = Clock::now() - start_time;
    return passed.count() / static_cast<double>(__rdtsc() - start);
}

struct Figures {
    double median_ns;
    double p999_ns;
};

/// Batches for the median, single ticks (the counter's cost included) for the tail; between them whatever is
/// beside the tick.
template <typename Tick, typename Beside>
Figures measure(Tick tick, Beside beside) {
    std::vector<std::uint32_t> singles;
    std::vector<std::uint32_t> batches;
    singles.reserve(kTicks);
    batches.reserve(kTicks / kBatch);
    while (singles.size() < kTicks) {
        beside();
        const std::uint64_t batch_start = __rdtsc();
        for (std::size_t n = 0; n < kBatch; ++n) tick();
        batches.push_back(static_cast<std::uint32_t>(__rdtsc() - batch_start));
        for (std::size_t n = 0; n < kBatch; ++n) {
            const std::uint64_t start = __rdtsc();
            tick();
            singles.push_back(static_cast<std::uint32_t>(__rdtsc() - start));
        }
    }
    std::ranges::sort(singles);
    std::ranges::sort(batches);
    const double scale = ns_per_count();
    return {batches[batches.size() / 2] * scale / kBatch, singles[singles.size() * 999 / 1000] * scale};
}

Figures whole_tick(std::int64_t iterations, bool overrides) {
    Core core(iterations);
    std::uint64_t round = 0;
    const Figures figures =
        measure([&] { core.cycle.tick(); },
                [&] {
                    core.fill();
                    ++round;
                    if (overrides && round % 60 == 0) {
                        core.ask(cycle::RequestKind::override, 60 + round / 60 * 37 % 100);
                    }
                });
    if (core.cycle.state() != MachineState::carving) {
        std::printf("the curve ended early; these figures say nothing\n");
        std::exit(1);
    }
    return figures;
}

Figures executor_alone(std::int64_t iterations) {
    const cycle::CycleConfig config;
    const auto blocks = std::make_unique<cycle::BlockRing>();
    cycle::PulseStage pulses(config);
    const cycle::Inputs inputs(config);
    cycle::Executor executor(config, *blocks, pulses, inputs);
    Segments segments(iterations);
    std::uint64_t now = 0;
    return measure(
        [&] {
            pulses.begin_tick(now);
            executor.step(now);
            ++now;
        },
        [&] {
            while (blocks->size() < cycle::kBlockRingEntries) blocks->push(segments.next(0));
        });
}

void print(const char* what, std::int64_t iterations, const Figures& figures) {
    std::printf("%-36s %3lld iterations a segment: median %5.1f ns (of %zu in a row), p99.9 %6.1f ns\n", what,
                static_cast<long long>(iterations), figures.median_ns, kBatch, figures.p999_ns);
}

}  // namespace

int main() {
    for (const std::int64_t iterations : {4, 16, 64}) {
        print("executor, DDA and pulse stage", iterations, executor_alone(iterations));
        print("whole tick, null port", iterations, whole_tick(iterations, false));
        print("whole tick, override changing", iterations, whole_tick(iterations, true));
    }
    return 0;
}
