// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>

#include "hmi/replay/replay_desk.hpp"
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
          keeper(session::state_folder(std::getenv("XDG_STATE_HOME"), std::getenv("HOME"))),
          replay(log) {
        desk.set_recordings(replay::is_recording, [this](const std::string& path) { open_replay(path); });
        desk.set_opened([this] { replay.leave(); });
    }

    session::MessageLog log;
    session::MachineSession machine;
    session::JobDesk desk;
    session::RunWatch runs;
    session::LogKeeper keeper;
    replay::ReplayDesk replay;

    // What the window shows: the machine and its job, or a recording of them.
    const session::MachineSight& shown() const noexcept {
        return replay.is_open() ? replay.sight() : machine.sight();
    }
    replay::JobPointer shown_job() const noexcept {
        return replay.is_open() ? replay.facts().job : desk.job();
    }
    /// The job that the machine, or the recorded one, is at or was at last.
    replay::JobPointer job_at_work() const noexcept {
        return replay.is_open() ? replay.facts().job : desk.core_job();
    }
    /// The job of the run that `runs` tells of.
    const replay::JobPointer& job_of_run() const noexcept { return job_of_run_; }
    /// The job that is shown is the one that the machine, or the recorded one, is at.
    bool is_shown_at_job() const noexcept {
        if (replay.is_open()) return replay.shown().place.has_value();
        const MachineState state = machine.sight().state();
        return machine.sight().status && desk.sight().state == session::DeskState::published &&
               (state == MachineState::carving || state == MachineState::held);
    }

    /// A look at the machine and at what is under way.
    void poll() {
        machine.poll();
        desk.poll(machine.sight());
        runs.note(machine.sight(), session::RunWatch::Clock::now());
        note_job_of_run();
        keeper.poll(log);
        replay.poll(replay::ReplayDesk::Clock::now());
        machine.watch_only(replay.is_open());
        if (desk.edition() == offered_edition_) return;
        offered_edition_ = desk.edition();
        if (desk.job()) machine.offer_profile(desk.job()->profile);
        if (desk.core_job()) machine.offer_profile(desk.core_job()->profile);
    }

private:
    void open_replay(const std::string& path) {
        replay.open(path, machine.options().profile.value_or(Profile{}));
    }

    void note_job_of_run() {
        const std::uint64_t start_tick = runs.run() ? runs.run()->after.job_start_tick : 0;
        if (run_start_tick_ != start_tick) job_of_run_.reset();
        run_start_tick_ = start_tick;
        if (start_tick != 0 && !job_of_run_) job_of_run_ = desk.core_job();
    }

    std::uint64_t offered_edition_ = 0;
    std::uint64_t run_start_tick_ = 0;
    replay::JobPointer job_of_run_;
};

}  // namespace psicarve::ui
