// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/sim_port.hpp"

namespace psicarve::port {

SimPort::SimPort(const PinMap& pin_map, sim::Machine& machine) : pin_map_(pin_map), machine_(&machine) {}

}  // namespace psicarve::port
