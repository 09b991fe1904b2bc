// SPDX-License-Identifier: GPL-3.0-or-later
// How many trace events a second the verifier judges, from memory and from both file forms; what rule 3
// costs.
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "hmi/verify/motor/train_follower.hpp"
#include "hmi/verify/verifier.hpp"
#include "tests/hmi/verify/exact_motion.hpp"
#include "tests/hmi/verify/perfect_machine.hpp"

namespace {

using namespace psicarve;
using namespace psicarve::verify;

double seconds_of(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void print(const char* what, std::size_t events, double seconds, bool ok) {
    std::printf("%-24s %9.0f thousand events, %6.2f million events/s, %s\n", what,
                static_cast<double>(events) / 1e3, static_cast<double>(events) / seconds / 1e6,
                ok ? "verified" : "NOT VERIFIED");
}

bool from_file(const SampleJob& job, const std::string& bytes) {
    const std::string path = "/tmp/psicarve_verify_bench_" + std::to_string(::getpid());
    std::ofstream(path, std::ios::binary) << bytes;
    auto trace = open_trace(path);
    auto sut = Verifier::make(job.view(), job.profile);
    const bool ok = trace && sut && verify_trace(*sut, **trace)->ok;
    ::unlink(path.c_str());
    return ok;
}

/// Rule 3 alone on one axis of the fine profile: 1e6 pulses/s2, 48 000 and 2 000 pulses/s.
void print_rule_3(const char* what, const Motion& motion) {
    const auto events = pulses_of(motion, 3.0, {.jitter_pulses = 0.4});
    TrainFollower rule({.accel_pps2 = 1e6, .speed_pps = 48'000, .jump_pps = 2'000}, 0);
    std::size_t offences = 0;
    const double seconds = seconds_of([&] {
        for (const TrainEvent& event : events) offences += rule.take(event) ? 0 : 1;
    });
    std::printf("rule 3, %-16s %9.0f thousand pulses, %6.0f ns a pulse, %zu offences\n", what,
                static_cast<double>(events.size()) / 1e3, seconds * 1e9 / static_cast<double>(events.size()),
                offences);
}

}  // namespace

int main() {
    print_rule_3("below start-stop", [](double time_s) { return 1'500.0 * time_s; });
    print_rule_3("at 45 kHz", [](double time_s) {
        return time_s < 0.043 ? 2'000.0 * time_s + 5e5 * time_s * time_s
                              : 1'010.5 + 45'000.0 * (time_s - 0.043);
    });
    print_rule_3("swinging at 5 Hz",
                 [](double time_s) { return 900.0 * (1.0 - std::cos(10.0 * kPi * time_s)); });
    const SampleJob job(Profile{}, 200, 500, Joining::continuous, [](double angle, std::uint32_t layer) {
        return 12.0 + 1.5 * std::cos(5.0 * angle) + 0.6 * std::sin(13.0 * angle + 0.02 * layer);
    });
    PerfectMachine machine(job);
    machine.carve_job();
    const std::size_t events = machine.events.size();
    bool ok = false;
    const double memory = seconds_of([&] {
        auto sut = Verifier::make(job.view(), job.profile);
        (void)sut->begin(machine.start);
        sut->feed(machine.events);
        ok = sut->finish().ok;
    });
    print("events in memory", events, memory, ok);
    const std::string binary = as_binary(machine.start, machine.events);
    const double from_binary = seconds_of([&] { ok = from_file(job, binary); });
    print("binary trace file", events, from_binary, ok);
    const std::string dump = as_vcd(machine.start, machine.events);
    const double from_dump = seconds_of([&] { ok = from_file(job, dump); });
    print("value-change dump", events, from_dump, ok);
    return 0;
}
