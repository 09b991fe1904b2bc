// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/session/job_desk.hpp"
#include "hmi/session/machine_session.hpp"
#include "hmi/session/message_log.hpp"

namespace psicarve::ui {

/// What every part of the window works with.
struct Bench {
    explicit Bench(const session::SessionOptions& options)
        : machine(options, log), desk(options.segment_name, options.group, log) {}

    session::MessageLog log;
    session::MachineSession machine;
    session::JobDesk desk;

    void poll() {
        machine.poll();
        desk.poll(machine.sight());
        if (desk.job()) machine.offer_profile(desk.job()->profile);
    }
};

}  // namespace psicarve::ui
