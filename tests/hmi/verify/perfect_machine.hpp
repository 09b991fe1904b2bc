// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// A job in memory, its blob and the profile it was made for. The body is asked for R2's radii where R2's tip
/// really stands, so `layer` may lie between two layers or outside them.
struct SampleJob {
    static constexpr std::int64_t kLayerPulses = 80;

    SampleJob(const Profile& machine, std::uint32_t layers, std::uint32_t points, Joining joining,
              const std::function<double(double angle_rad, double layer)>& radius_mm);

    JobView view() const;

    Profile profile;
    std::vector<std::byte> blob;
};

/// A wavy body, unlike itself on any two sides: for most tests.
SampleJob wavy_job(Joining joining = Joining::continuous, std::uint32_t layers = 4,
                   std::uint32_t points = 21);

/// Makes the pins of a machine that carves a job without a fault, slowly: one step of the dual-head DDA every
/// `kIteration_ns`. Knows nothing of the controller; written from the rules alone. Tests then break its pins.
class PerfectMachine {
public:
    static constexpr std::int64_t kIteration_ns = 2'500'000;
    static constexpr std::int64_t kSetup_ns = 100'000;  ///< directions lead each iteration's steps by this
    static constexpr std::int64_t kHigh_ns = 50'000;

    explicit PerfectMachine(const SampleJob& job);

    /// The whole of it: approach, carving, retraction.
    PerfectMachine& carve_job();

    // The parts, for tests that put them together otherwise:
    PerfectMachine& approach(std::uint32_t layer = 0,
                             std::uint32_t step = 0);  ///< up to that point, spindle on
    PerfectMachine& to_point(std::uint32_t layer,
                             std::uint32_t step);  ///< straight, from a point of that layer
    PerfectMachine& link_to(std::uint32_t layer);  ///< outward, Y, inward
    PerfectMachine& layer(std::uint32_t layer);    ///< from its first point to its last
    PerfectMachine& finish();                      ///< retract, spindle off
    PerfectMachine& move(Axis axis, std::int64_t pulses);
    PerfectMachine& line(const std::array<std::int64_t, kAxisCount>& delta);
    PerfectMachine& set(Signal signal, bool level);
    PerfectMachine& pulse(Axis axis, bool positive);
    PerfectMachine& wait(std::int64_t time_ns);
    PerfectMachine& define_positions(const std::array<std::int64_t, kAxisCount>& positions);

    /// The motors stand beyond their gaps, as after a way down: call it first, with `gap` set.
    PerfectMachine& begin_crossed();

    TraceStart start;
    std::vector<TraceEvent> events;
    std::array<std::int64_t, kAxisCount> position{};
    std::int64_t iteration_ns = kIteration_ns;
    std::array<std::int64_t, kAxisCount> gap{};  ///< backlash: extra pulses wherever an axis turns round

private:
    void emit(std::int64_t time_ns, SignalWord levels);
    void step_all(unsigned axes, unsigned positive);

    JobView view_;
    std::int64_t now_ns_ = 1'000'000;
    void cross_gap(Axis axis, bool positive);
    SignalWord levels_ = 0;
    unsigned pushes_down_ = 0;  ///< bit by axis
};

/// The events as a value-change dump and as the binary form, the way our own core writes them.
std::string as_vcd(const TraceStart& start, const std::vector<TraceEvent>& events);
std::string as_binary(const TraceStart& start, const std::vector<TraceEvent>& events);

}  // namespace psicarve::verify
