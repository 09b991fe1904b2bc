// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "rtcore/cycle/cycle.hpp"
#include "rtcore/plan/cycle_config_from_profile.hpp"
#include "rtcore/plan/planner.hpp"
#include "rtcore/port/sim_port.hpp"
#include "rtcore/sim/machine.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/pin_map.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cycle {

using Positions = std::array<std::int64_t, kAxisCount>;

/// What left the port at a tick.
struct PortWrite {
    std::uint64_t tick;
    SignalWord levels;
    std::int64_t time_ns;
};

/// A simulated machine's port that remembers what was written.
class RecordingPort final : public port::Port {
public:
    RecordingPort(const PinMap& pins, sim::Machine& machine, std::int64_t period_ns)
        : inner_(pins, machine), period_ns_(period_ns) {}
    SignalWord read_inputs(std::int64_t time_ns) noexcept override {
        if (beside != nullptr) beside->read_inputs(time_ns);
        return inner_.read_inputs(time_ns);
    }
    void write_outputs(SignalWord levels, std::int64_t time_ns) noexcept override {
        if (records) writes.push_back({static_cast<std::uint64_t>(time_ns / period_ns_), levels, time_ns});
        if (beside != nullptr) beside->write_outputs(levels, time_ns);
        inner_.write_outputs(levels, time_ns);
    }
    void wait(std::int64_t width_ns) noexcept override { waited_ns = width_ns; }
    bool is_healthy() const noexcept override { return healthy; }
    void try_safe_state() noexcept override { ++safe_tries; }
    bool is_silent() const noexcept override { return silent; }
    void forget_written() noexcept override { ++forgotten; }
    bool take_up_again() noexcept override {
        if (when_taken_up) when_taken_up();
        healthy = healthy || answers;
        return healthy;
    }

    port::Port* beside = nullptr;  ///< takes and is asked the same; its inputs count for nothing
    bool records = true;
    bool healthy = true;
    bool answers = false;  ///< once it is not healthy
    bool silent = false;
    int forgotten = 0;  ///< how often it was told that its pins are not what was written
    int safe_tries = 0;
    std::function<void()> when_taken_up;
    std::int64_t waited_ns = 0;  ///< the last wait asked for
    std::vector<PortWrite> writes;

private:
    port::SimPort inner_;
    std::int64_t period_ns_;
};

/// Cycle, planner and simulated machine, ticked by hand on virtual time.
class MachineRig {
public:
    explicit MachineRig(const Profile& machine_profile = Profile{},
                        const std::function<void(sim::SimConfig&)>& change = {});

    void tick();
    /// Ticks until the state is reached; false after too many.
    bool run_until(MachineState state, std::uint64_t most_ticks = 20'000'000);
    bool run_while(const std::function<bool()>& condition, std::uint64_t most_ticks = 20'000'000);
    void run(std::uint64_t ticks);

    /// Asks and ticks once; what the answer was.
    Refusal ask(RequestKind kind, std::uint8_t axis = 0, std::uint64_t value = 0);
    Refusal ask(Request request);
    void stop() { io->urgent.stop_requests.fetch_add(1); }
    void emergency_stop() { io->urgent.estop_requests.fetch_add(1); }
    bool home();
    void load(const JobTable& table);
    /// Homed, job loaded, waiting at the first point.
    bool prepare(const JobTable& table);
    Positions positions() const { return cycle->pulses().positions(); }
    std::vector<FlightRecord> records_of(RecordKind kind) const;

    Profile profile;
    std::unique_ptr<sim::Machine> machine;
    std::unique_ptr<RecordingPort> port;
    std::unique_ptr<CycleIo> io;
    std::unique_ptr<Cycle> cycle;
    std::unique_ptr<plan::Planner> planner;
    std::vector<Report> reports;
    std::uint64_t poll_every = 1;  ///< tick's number modulo this: poll even though nothing asks for it

private:
    void drain();
    std::uint64_t sequence_ = 0;
};

/// A default profile with quick spindle and short travels, so that tests are short too.
Profile quick_profile();
/// The same without enable lines: nothing switches its drives off.
Profile always_on_profile();
/// Layers with smooth, rough or random radii; valid for quick_profile().
JobTable random_job(std::uint32_t layers, std::uint32_t points, std::uint64_t seed,
                    Joining joining = Joining::continuous);
/// The job's points in the order of carving: r1, r2, psi, y.
std::vector<Positions> points_of(const JobTable& table);

/// Counts pulses from recorded writes alone: every rising step edge with the direction pin's level.
class PinCounter {
public:
    explicit PinCounter(const Positions& start) : positions_(start) {}
    /// Axes (bit by axis) that stepped with this write.
    std::uint32_t take(SignalWord levels);
    const Positions& positions() const { return positions_; }

private:
    Positions positions_;
    SignalWord levels_ = 0;
};
/// Which axes stepped together, write after write: the merged order of DDA iterations.
std::vector<std::uint32_t> order_of(const std::vector<PortWrite>& writes);

}  // namespace psicarve::cycle
