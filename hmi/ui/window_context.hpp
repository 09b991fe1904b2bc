// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <QApplication>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/program/program_desk.hpp"
#include "hmi/replay/replay_session.hpp"
#include "hmi/session/alarm_bell.hpp"
#include "hmi/session/carving_watch.hpp"
#include "hmi/session/file_presence.hpp"
#include "hmi/session/file_saver.hpp"
#include "hmi/session/journal_history.hpp"
#include "hmi/session/latency_trial.hpp"
#include "hmi/session/layer_cursor.hpp"
#include "hmi/session/level_history.hpp"
#include "hmi/session/log_file.hpp"
#include "hmi/session/machine_session.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/open_job.hpp"
#include "hmi/session/pending_saves.hpp"
#include "hmi/session/pin_recorder.hpp"
#include "hmi/session/profile_files.hpp"
#include "hmi/session/run_watch.hpp"
#include "hmi/session/time_estimator.hpp"
#include "hmi/session/trace_judge.hpp"
#include "hmi/ui/settings_store.hpp"

namespace psicarve::ui {

/// What every part of the window works with.
struct WindowContext {
    /// Null: the user's own settings.
    explicit WindowContext(const session::SessionOptions& options,
                           std::unique_ptr<SettingsStore> kept_settings = nullptr)
        : settings(kept_settings ? std::move(kept_settings) : std::make_unique<SettingsStore>()),
          saves(settings->saves()),
          machine(options, log),
          open_job(options.segment_name, options.group, log),
          keeper(session::state_folder(std::getenv("XDG_STATE_HOME"), std::getenv("HOME")), saves),
          history(options.segment_name, options.state_folder),
          replay(log),
          pins(options.segment_name, options.group, log, saves),
          judge(log),
          files(options.segment_name, options.group, log, saves),
          program(log, options.segment_name, options.group,
                  {session::state_folder(std::getenv("XDG_STATE_HOME"), std::getenv("HOME")) + "/programs",
                   options.segment_name + "-" + std::to_string(::getpid())}) {
        open_job.set_recordings(replay::is_recording, [this](const std::string& path) { open_replay(path); });
        files.set_files_in_use([this] {
            std::vector<std::string> open{open_job.path()};
            if (replay.is_open()) open.push_back(replay.facts().path);
            if (pins.state() != session::PinRecorder::State::idle) open.push_back(pins.path());
            return open;
        });
        open_job.set_opened([this] { replay.leave(); });
        open_job.set_profile([this] { return machine_profile(); });
        settings->set_on_unwritten([this](const Error& why) {
            log.add(session::Severity::warning,
                    session::joined(session::phrase("Settings are not kept"), session::error_phrase(why)),
                    session::phrase("Is the disk full, or the folder another user's?"));
        });
    }

    std::unique_ptr<SettingsStore> settings;
    session::PendingSaves saves;  ///< of everything that is written here
    session::MessageLog log;
    session::AlarmBell bell{[] { QApplication::beep(); }};
    session::MachineSession machine;
    session::OpenJob open_job;
    session::RunWatch runs;
    session::LogKeeper keeper;
    session::JournalHistory history;
    replay::ReplaySession replay;
    session::PinRecorder pins;
    session::TraceJudge judge;
    session::FileSaver files;
    program::ProgramDesk program;
    ProgramReport program_report;    ///< of whichever process's program, at the last look
    session::FilePresence presence;  ///< of what menus offer
    session::TimeEstimator estimate{log};
    // What is shown by views that are made anew when the language changes, and outlives them.
    session::CarvingWatch carving{machine, open_job};
    session::ProfileFiles profile_desk{saves};
    session::LatencyTrial latency{log};
    session::LevelHistory levels;
    session::LayerCursor layer_cursor;
    std::uint64_t read_messages = 0;                        ///< that came while or before the page was open
    session::RunKind wanted_run = session::RunKind::carve;  ///< of every button that starts the job
    /// The boxes that say with which layer to begin, and with which of its points.
    struct LayerChoice {
        std::uint32_t offered = 0;                  ///< by the machine, from 0
        int chosen = 1;                             ///< as it is shown, from 1
        int point = 0;                              ///< of that layer, as it is shown, from 1; 0: its begin
        std::weak_ptr<const cam::PreparedJob> job;  ///< that the point is of
    };
    LayerChoice first_layer;

    /// The core's, else the one that the window was started with, else the built-in one.
    Profile machine_profile() const {
        const auto& of_core = machine.view().profile;
        return of_core ? *of_core : machine.options().profile.value_or(Profile{});
    }
    /// Not only what a job says of it.
    bool knows_core_profile() const noexcept {
        return machine.view().profile.has_value() && !machine.view().is_profile_of_job;
    }
    /// Requires that it is known. It is the window's own from now on.
    void take_core_profile() {
        const Profile of_core = *machine.view().profile;
        log.add(session::Severity::info,
                session::phrase("Taken over from the core: profile %1", of_core.name));
        machine.set_profile(of_core);
    }
    // What the window shows: the machine and its job, or a recording of them.
    const session::MachineView& shown() const noexcept {
        return replay.is_open() ? replay.view() : machine.view();
    }
    replay::JobPointer shown_job() const noexcept {
        return replay.is_open() ? replay.facts().job : open_job.job();
    }
    /// The job that the machine, or the recorded one, is at or was at last.
    replay::JobPointer job_at_work() const noexcept {
        return replay.is_open() ? replay.facts().job : open_job.core_job();
    }
    /// The job of the run that `runs` tells of.
    const replay::JobPointer& job_of_run() const noexcept { return job_of_run_; }
    /// The job that is shown is the one that the machine, or the recorded one, is at.
    bool is_shown_at_job() const noexcept {
        if (replay.is_open()) return replay.shown().place.has_value();
        const MachineState state = machine.view().state();
        return machine.view().status && open_job.view().state == session::OpenJobState::published &&
               (state == MachineState::carving || state == MachineState::held);
    }

    /// The file that was to be opened last and could not be; null: none, or that was read.
    const session::RefusedFile* refused_file() const noexcept {
        const auto& refused = open_job.refused_file() ? open_job.refused_file() : replay.refused_file();
        return refused ? &*refused : nullptr;
    }
    void forget_refused_file() noexcept {
        open_job.forget_refused_file();
        replay.forget_refused_file();
    }

    /// A look at the machine and at what is under way.
    void poll() {
        machine.poll();
        program_report = machine.program();
        program.poll(program_report);
        history.poll(log);
        bell.poll(log);
        open_job.poll(machine.view());
        runs.note(machine.view(), session::RunWatch::Clock::now());
        note_job_of_run();
        pins.poll(machine.view());
        judge.poll();
        files.poll();
        presence.poll();
        keeper.poll(log);
        settings->poll();
        estimate.poll(job_to_estimate(), session::TimeEstimator::Clock::now());
        replay.poll(replay::ReplaySession::Clock::now());
        machine.watch_only(replay.is_open());
        const replay::JobPointer accepted = open_job.core_job();
        machine.take_accepted(accepted ? &accepted->profile : nullptr);
        if (open_job.edition() == offered_edition_) return;
        offered_edition_ = open_job.edition();
        if (open_job.job()) machine.offer_profile(open_job.job()->profile);
        if (accepted) machine.offer_profile(accepted->profile);
    }

private:
    /// The open job, while the computer is not needed for a machine at work. The core, too, knows how long a
    /// published one takes, but not each of its layers.
    std::shared_ptr<const cam::PreparedJob> job_to_estimate() const {
        const session::MachineView& view = machine.view();
        const bool is_at_work = view.is_heard() && !is_at_rest(view.state());
        if (is_at_work || replay.is_open() || open_job.view().is_busy()) return nullptr;
        return open_job.job();
    }

    void open_replay(const std::string& path) {
        replay.open(path, machine.options().profile.value_or(Profile{}));
    }

    void note_job_of_run() {
        const std::uint64_t start_tick = runs.run() ? runs.run()->after.job_start_tick : 0;
        if (run_start_tick_ != start_tick) job_of_run_.reset();
        run_start_tick_ = start_tick;
        if (start_tick != 0 && !job_of_run_) job_of_run_ = open_job.core_job();
    }

    std::uint64_t offered_edition_ = 0;
    std::uint64_t run_start_tick_ = 0;
    replay::JobPointer job_of_run_;
};

}  // namespace psicarve::ui
