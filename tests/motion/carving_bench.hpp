// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "hmi/verify/verifier.hpp"
#include "rtcore/cycle/layer_range.hpp"
#include "rtcore/sim/sim_config.hpp"
#include "rtcore/trace/trace_entry.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::motion {

/// What a body looks like: the radius [mm] in a direction [rad] at a layer.
using Shape = std::function<double(double direction, std::uint32_t layer)>;

struct NamedShape {
    const char* name;
    Shape shape;
};
/// A smooth vase, a figurine's deep curves, a gear with sharp flanks and a noisy relief.
std::vector<NamedShape> sample_shapes();

JobTable table_of(const Profile& profile, const Shape& shape, std::uint32_t layers, std::uint32_t points,
                  Joining joining = Joining::continuous);

/// What came out of the pins.
struct Carved {
    verify::VerifyReport report;
    std::vector<std::uint32_t> order;  ///< which axes stepped together while the job was carved
    double carve_s = 0.0;
    double t_ref_s = -1.0;  ///< the planner's own; -1: it has none
    std::uint64_t waited_ticks = 0;
    std::uint64_t iterations = 0;
    std::uint64_t stalls = 0;  ///< of the simulated motors
};

/// Called once a tick while the job is carved.
using Disturbance = std::function<void(cycle::MachineRig&)>;

/// What is not as usual.
struct Conditions {
    std::function<void(sim::SimConfig&)> machine;
    cycle::LayerRange layers;
    std::optional<Profile> judged_by{};  ///< nothing: the machine's own profile
};

/// Homes, carves the table on a simulated machine and has the pins judged by all four rules.
Carved carved(const Profile& profile, const JobTable& table, const Disturbance& disturb = {},
              const Conditions& conditions = {});

}  // namespace psicarve::motion
