// SPDX-License-Identifier: GPL-3.0-or-later
// Motion records, whatever stands in the ring: through the ring's reader and the core's intake into the
// planner, and on a simulated machine by the virtual clock. Nothing crashes, hangs, raises an alarm, stalls a
// motor or leaves the travel; a stop brings every machine to rest.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

#include "rtcore/cycle/cycle.hpp"
#include "rtcore/plan/cycle_config_from_profile.hpp"
#include "rtcore/plan/planner.hpp"
#include "rtcore/plan/record_program.hpp"
#include "rtcore/port/sim_port.hpp"
#include "rtcore/program/record_intake.hpp"
#include "rtcore/sim/machine.hpp"
#include "shared/profile/pin_map.hpp"
#include "tests/fuzz/record_input.hpp"
#include "tests/fuzz/require.hpp"
#include "tests/rtcore/program/program_in_memory.hpp"

namespace psicarve::fuzz {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;
using cycle::SoftLimits;
using plan::Pulses4;

constexpr std::size_t kMostRecords = 1'500;
constexpr std::uint64_t kRunTicks = 2'000;
// One input in so many, by its bytes, carves some millimetres: through cuts of the horizon, and to its end.
constexpr unsigned kOneGoesFar = 8;
constexpr std::uint64_t kFarTicks = 60'000;
constexpr std::uint64_t kStopTicks = 20'000;  ///< from any speed to rest
constexpr std::size_t kMostBlocks = 400'000;

Profile profile_for(const RecordInput& input) {
    Profile profile;
    profile.job.spindle_spinup_s = 0.01;
    profile.job.lifts_on_hold = (input.how & kLiftsOnHold) != 0;
    if ((input.how & kHasBacklash) != 0) {
        profile.r1.backlash_mm = 0.02;
        profile.y.backlash_mm = 0.05;
    }
    if ((input.how & kIsTwoTimer) != 0) {
        profile.tick.schedule = Schedule::two_timer;
        profile.tick.period_us = 100.0;
        profile.psi.speed_deg_s = 112.5;
        profile.psi.accel_deg_s2 = 1125.0;
        for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
            axis->speed_mm_s = 5.0;
            axis->accel_mm_s2 = 50.0;
            axis->home_speed_mm_s = 4.0;
        }
    }
    return profile;
}

/// Writes the input's records into a ring as a writer does, some before each look of the planner, and spoils
/// the ring's words where the input says so.
class SpoiltProgram final : public plan::StepSource {
public:
    SpoiltProgram(const RecordInput& input, const Profile& profile, const Pulses4& start)
        : input_(&input), writer_(memory_.ring(), 0), intake_(memory_.feed(), profile, start) {
        const std::size_t once = input.records.size();
        all_ = std::min(once * (std::size_t{input.passes} + 1), kMostRecords);
    }

    void begin(const Pulses4& start) override { intake_.begin(start); }
    plan::Supply next(plan::ProgramStep& step) override {
        if (asked_++ % (1U + input_->pace / 16U) == 0) write_some();
        const plan::Supply supply = intake_.next(step);
        if (supply == plan::Supply::step) {
            require(step.line > 0 && ++taken_ <= put_, "nothing is taken that was not put");
            require(std::isfinite(step.seconds) && std::isfinite(step.tolerance_mm), "every number is one");
        }
        if (supply == plan::Supply::refused || supply == plan::Supply::lost)
            require(intake_.refusal().has_value(), "a refusal has a reason");
        return supply;
    }

private:
    void write_some() {
        for (int left = 1 + input_->pace % 16; left > 0; --left) {
            if (put_ == all_) return leave();
            MotionRecord record = input_->records[put_ % input_->records.size()];
            if ((input_->how & kIsForeign) == 0) {
                record.program = test::kProgram;
                record.sequence = put_ + 1;
                record.check = record_check(record);
            }
            if (writer_.try_put(record) != RingAnswer::done) return leave();
            ++put_;
            for (const RingEdit& edit : input_->edits) {
                if (edit.after == put_ % 256) spoil(edit);
            }
        }
    }
    /// All is put, or the ring is full or broken for good: nobody waits for a writer that cannot go on.
    void leave() {
        if (put_ == all_ || ++full_ > 4 * kLeastRingRecords) memory_.control().closed.store(test::kProgram);
    }
    void spoil(const RingEdit& edit) {
        std::size_t place = edit.place_low + 256U * edit.place_high;
        auto* bytes = reinterpret_cast<unsigned char*>(&memory_.control());
        if (place >= sizeof(ProgramControl)) {
            bytes = reinterpret_cast<unsigned char*>(&memory_.records().record(0));
            place = (place - sizeof(ProgramControl)) % (kLeastRingRecords * sizeof(RingRecord));
        }
        bytes[place] ^= edit.flip;
    }

    const RecordInput* input_;
    test::ProgramInMemory memory_;
    RecordWriter writer_;
    program::RecordIntake intake_;
    std::size_t all_ = 0;
    std::size_t put_ = 0;
    std::size_t taken_ = 0;
    std::uint64_t asked_ = 0;
    std::uint32_t full_ = 0;
};

void require_within(const SoftLimits& limits, const Pulses4& at) {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        require(at[k] >= limits.least_pulses[k] && at[k] <= limits.most_pulses[k], "motion is within travel");
        require(k >= limits.core_pulses.size() || at[k] >= limits.core_pulses[k],
                "no head comes into the core");
    }
    const auto sum_mm = static_cast<double>(at[0]) * limits.mm_per_pulse[0] +
                        static_cast<double>(at[1]) * limits.mm_per_pulse[1];
    // A place and each way to it are rounded to a pulse of each head.
    require(sum_mm >= limits.least_sum_mm - limits.mm_per_pulse[0] - limits.mm_per_pulse[1],
            "the tips keep apart");
}

void require_sound(const cycle::PathTiming& path) {
    require(std::isfinite(path.length) && path.length > 0.0, "a path block has a length");
    for (std::size_t i = 0; i < path.start_speed2.size(); ++i) {
        require(std::isfinite(path.start_speed2[i]) && path.start_speed2[i] >= 0.0, "a speed is one");
        require(std::isfinite(path.end_speed2[i]) && path.end_speed2[i] >= 0.0, "a speed is one");
        require(path.start_speed2[i] + path.end_speed2[i] > 0.0, "a path block goes on");
    }
}

/// All of it as blocks.
void plan_all(const RecordInput& input, const Profile& profile, const Pulses4& start) {
    const plan::MachineLimits limits = plan::machine_limits(profile);
    const auto source = std::make_shared<SpoiltProgram>(input, profile, start);
    plan::RecordProgram program(limits, source, start, (input.how & kIsSingle) != 0);
    Pulses4 at = start;
    MotionBlock block;
    std::size_t waits = 0;
    for (std::size_t n = 0; n < kMostBlocks; ++n) {
        if (!program.next(block)) {
            if (!program.is_waiting()) return;
            require(++waits < 100 * kMostRecords, "a program that nobody writes any more ends");
            continue;
        }
        for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += block.delta_pulses[k];
        require_within(limits.tick.soft_limits, at);
        if (block.kind == BlockKind::path) require_sound(block.path);
        require(block.kind != BlockKind::dwell || block.ticks >= 0, "no rest takes less than no time");
    }
    require(false, "a program has an end");
}

/// A machine that is homed, in the middle of its travel.
class Bench {
public:
    Bench(const Profile& profile, const sim::SimConfig& sim_config)
        : machine_(sim_config),
          port_(PinMap::from_profile(profile).value(), machine_),
          io_(std::make_unique<cycle::CycleIo>()),
          config_(plan::cycle_config_from_profile(profile)),
          cycle_(config_, port_, *io_),
          planner_(profile, *io_) {}

    void run(const RecordInput& input, const std::shared_ptr<plan::StepSource>& source, const Pulses4& start,
             std::uint64_t most_ticks) {
        cycle_.assume_homed(start);
        planner_.set_source(source, test::kProgram);
        ask(cycle::RequestKind::run_program, (input.how & kIsSingle) != 0 ? 1 : 0, test::kProgram);
        const auto is_over = [&] { return cycle_.next_tick() > 16 && cycle_.state() == MachineState::ready; };
        for (std::uint64_t n = 0; n < most_ticks && !is_over(); ++n) {
            tick();
            operate(input);
        }
        if (!is_over()) stop();
        const sim::SimReport report = machine_.report();
        for (const Axis axis : kAllAxes) {
            const sim::AxisReport& seen = report.axis(axis);
            require(seen.stalls + seen.crashes + seen.pulses_ignored + seen.timing_lost() == 0,
                    "every pulse is followed");
        }
    }

private:
    void ask(cycle::RequestKind kind, std::uint8_t axis = 0, std::uint64_t value = 0) {
        cycle::Request request{};
        request.kind = kind;
        request.axis = axis;
        request.value = value;
        request.sequence = ++sequence_;
        io_->requests.push(request);
    }
    /// Goes on at every stop, and puts in a word now and then.
    void operate(const RecordInput& input) {
        const std::uint64_t tick = cycle_.next_tick();
        if (tick % 128 == 0 && cycle_.state() == MachineState::held) ask(cycle::RequestKind::resume);
        if ((input.how & kIsHeld) == 0 || cycle_.state() != MachineState::carving) return;
        if (tick % 512 == input.pace) ask(cycle::RequestKind::hold);
        if (tick % 256 == input.passes) ask(cycle::RequestKind::override, 0, 10 + (tick * 7) % 191);
    }
    /// Until the path is left: heads go out from there as always.
    void stop() {
        io_->urgent.stop_requests.fetch_add(1);
        tick();
        const auto brakes = [&] {
            const MachineState state = cycle_.state();
            return state != MachineState::ready && state != MachineState::finishing;
        };
        for (std::uint64_t n = 0; brakes(); ++n) {
            require(n < kStopTicks, "a stop brings it to rest");
            tick();
        }
    }
    void tick() {
        if (planner_.wants_poll() || cycle_.next_tick() % 32 == 0) planner_.poll();
        cycle_.tick();
        require(cycle_.state() != MachineState::alarm, "no record raises an alarm");
        require_within(config_.soft_limits, cycle_.pulses().positions());
        cycle::Report report;
        while (io_->reports.pop_into(report)) {
        }
        IncrementEntry entry;
        while (io_->increments.pop_into(entry)) {
        }
    }

    sim::Machine machine_;
    port::SimPort port_;
    std::unique_ptr<cycle::CycleIo> io_;
    cycle::CycleConfig config_;
    cycle::Cycle cycle_;
    plan::Planner planner_;
    std::uint64_t sequence_ = 0;
};

}  // namespace
}  // namespace psicarve::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace psicarve;
    const fuzz::RecordInput input = fuzz::record_input({data, size});
    if (input.records.empty()) return 0;
    const Profile profile = fuzz::profile_for(input);
    const sim::SimConfig sim_config = sim::sim_config_from_profile(profile);
    plan::Pulses4 start{};
    for (const Axis axis : kAllAxes) start[index_of(axis)] = sim_config.axis(axis).start_pulses;
    fuzz::plan_all(input, profile, start);
    fuzz::Bench bench{profile, sim_config};
    const bool goes_far = std::accumulate(data, data + size, 0U) % fuzz::kOneGoesFar == 0;
    bench.run(input, std::make_shared<fuzz::SpoiltProgram>(input, profile, start), start,
              goes_far ? fuzz::kFarTicks : fuzz::kRunTicks);
    return 0;
}
