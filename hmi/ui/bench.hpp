// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>

#include "hmi/session/job_desk.hpp"
#include "hmi/session/log_file.hpp"
#include "hmi/session/machine_session.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/run_watch.hpp"

namespace psicarve::ui {

/// What every part of the window works with.
struct Bench {
    explicit Bench(const session::SessionOptions& options)
        : machine(options, log),
          desk(options.segment_name, options.group, log),
          keeper(session::state_folder(std::getenv("XDG_STATE_HOME"), std::getenv("HOME"))) {}

    session::MessageLog log;
    session::MachineSession machine;
    session::JobDesk desk;
    session::RunWatch runs;
    session::LogKeeper keeper;

    /// A look at the machine and at what is under way.
    void poll() {
        machine.poll();
        desk.poll(machine.sight());
        runs.note(machine.sight(), session::RunWatch::Clock::now());
        keeper.poll(log);
        if (desk.edition() == offered_edition_) return;
        offered_edition_ = desk.edition();
        if (desk.job()) machine.offer_profile(desk.job()->profile);
    }

private:
    std::uint64_t offered_edition_ = 0;
};

}  // namespace psicarve::ui
