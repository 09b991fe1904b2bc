// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/run_core.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "rtcore/options/core_profile.hpp"
#include "rtcore/port/fatal_signals.hpp"
#include "rtcore/process/privileges.hpp"
#include "rtcore/process/state_folder.hpp"
#include "rtcore/program/program_server.hpp"
#include "rtcore/realtime/realtime_setup.hpp"
#include "rtcore/replay/recorded_job.hpp"
#include "rtcore/replay/replay_script.hpp"
#include "rtcore/supervisor/core_parts.hpp"
#include "rtcore/supervisor/end_request.hpp"
#include "rtcore/supervisor/guarded_port.hpp"
#include "rtcore/supervisor/latency_run.hpp"
#include "rtcore/supervisor/piece_file.hpp"
#include "rtcore/supervisor/replay.hpp"
#include "rtcore/supervisor/run_loops.hpp"
#include "rtcore/supervisor/supervisor.hpp"
#include "shared/base/printable.hpp"
#include "shared/machine/unreplayed_program.hpp"
#include "shared/record/snapshot_file.hpp"
#include "shared/segment/segment_object.hpp"

namespace psicarve::supervisor {
namespace {

int fail(const Error& error) {
    std::fprintf(stderr, "psicarve-rtcore: %s\n", printable(error.message).c_str());
    switch (error.code) {
        case ErrorCode::bad_usage:
            return 2;
        case ErrorCode::machine_refused:
        case ErrorCode::cancelled:
            return kExitAlarm;
        case ErrorCode::no_core:
        case ErrorCode::timed_out:
            return kExitNoSegment;
        default:
            return kExitBadInput;
    }
}

/// What --replay asks for, read before anything is touched.
struct Replay {
    Snapshot snapshot;
    std::optional<ReplayScript> script;
    std::uint64_t end_tick = 0;
    std::uint64_t program = 0;  ///< whose records a writer gives; 0: it is of none
};

Error nothing_recorded(const std::string& path, const Snapshot& snapshot) {
    const std::string program = unreplayed_program_text(snapshot.records);
    if (!program.empty()) return bad_input(path + ": " + program);
    return bad_input(path +
                     ": nothing to replay: its flight recorder holds no moment at which the machine was "
                     "homed and at rest, with something done after it; 'psicarve carve' carves its job");
}

Error holds_no_job(const std::string& path, const Snapshot& snapshot) {
    const std::string program = unreplayed_program_text(snapshot.records);
    return bad_input(path + ": " + (program.empty() ? std::string{"holds no job to replay"} : program));
}

Error holds_no_program(const std::string& path) {
    return bad_input(path +
                     ": its flight recorder holds no program of which it has the source, from the rest "
                     "before it on");
}

/// Of a machine's snapshot, what was recorded.
void set_end(Replay& replay) {
    replay.end_tick = replay.script->end_tick;
    const auto& status = replay.snapshot.status;
    if (!replay.script->is_cut && status && status->tick > replay.script->first_tick)
        replay.end_tick = std::max(replay.end_tick, status->tick - replay.script->first_tick);
}

constexpr std::int64_t kMostStartPulses = std::int64_t{1} << 52;

Result<std::optional<Replay>> load_replay_of_program(const std::string& path) {
    auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    if (snapshot->source == nullptr || snapshot->source->source.program == 0) return holds_no_program(path);
    Replay replay;
    replay.program = snapshot->source->source.program;
    replay.script = script_of_program(snapshot->records, replay.program);
    if (!replay.script) return holds_no_program(path);
    // Numbers of a file may be anything; what a machine counts is far from where sums overflow.
    for (const std::int64_t pulses : replay.script->start_position_pulses) {
        if (pulses < -kMostStartPulses || pulses > kMostStartPulses) return holds_no_program(path);
    }
    replay.snapshot = std::move(*snapshot);
    set_end(replay);
    return std::optional<Replay>{std::move(replay)};
}

/// A job file is run whole; of a machine's snapshot what was recorded, and nothing else.
Result<std::optional<Replay>> load_replay(const CoreOptions& options) {
    if (options.replay_path.empty()) return std::optional<Replay>{};
    if (options.replays_program) return load_replay_of_program(options.replay_path);
    auto snapshot = load_snapshot(options.replay_path);
    if (!snapshot) return snapshot.error();
    if (snapshot->job_blob.empty()) return holds_no_job(options.replay_path, *snapshot);
    Replay replay;
    replay.script = script_from_records(snapshot->records);
    const bool is_of_a_machine = snapshot->status.has_value() || !snapshot->records.empty();
    if (is_of_a_machine && !replay.script) return nothing_recorded(options.replay_path, *snapshot);
    replay.snapshot = std::move(*snapshot);
    if (replay.script) set_end(replay);
    return std::optional<Replay>{std::move(replay)};
}

/// A job carries the profile it was made for: a replay without --profile runs on that machine; else without
/// it the one applies that psicarve takes, too.
std::string profile_path_of(const CoreOptions& options) {
    if (!options.profile_path.empty()) return options.profile_path;
    return options.replay_path.empty() ? options.unnamed_profile_path : options.replay_path;
}

PartsRequest parts_request_of(const std::optional<Replay>& replay, const Profile& profile,
                              const Profile& machine) {
    PartsRequest request;
    request.machine = machine;
    if (!replay) return request;
    request.homed_start = replay->script ? replay->script->start_position_pulses : home_positions(profile);
    if (replay->script) request.start_levels = replay->script->start_levels;
    if (replay->script) request.start_gaps = replay->script->start_gaps;
    request.plays_recorded_inputs = replay->script.has_value();
    return request;
}

SegmentOptions segment_options_of(const CoreOptions& options) {
    SegmentOptions segment;
    segment.name = options.segment_name;
    segment.capacity_layers = options.capacity_layers;
    segment.capacity_points = options.capacity_points;
    segment.capacity_records = options.capacity_records;
    segment.group = options.group;
    return segment;
}

RealtimeOptions wish_of(const CoreOptions& options) {
    RealtimeOptions wish;
    wish.cpu = options.cpu;
    wish.takes_any_cpu = options.takes_any_cpu;
    wish.priority = options.priority;
    wish.lateness_path = options.lateness_path;
    wish.is_needed = !options.port.is_simulated() && !options.allow_no_realtime;
    return wish;
}

std::uint8_t missing_sensors(const Profile& profile) {
    unsigned mask = 0;
    for (const Axis axis : kAllAxes) {
        if (axis_motion(profile, axis).home == HomeSensor::none) mask |= 1U << index_of(axis);
    }
    return static_cast<std::uint8_t>(mask);
}

/// SIGTERM when the parent ends; a parent that ended before we asked is noticed as well.
bool tie_to_parent() {
    const pid_t parent = getppid();
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    return getppid() == parent && parent != 1;
}

int run_loop(CoreParts& parts, Supervisor& supervisor, std::optional<Replay>& replay, EndRequest& end,
             RealtimeSetup* setup) {
    JobDirector job_director;
    std::optional<RecordDirector> record_director;
    Directors directors;
    if (replay && replay->script) {
        if (parts.recorded_inputs != nullptr)
            parts.recorded_inputs->show_inputs(replay->script->start_levels);
        record_director.emplace(*replay->script, replay->end_tick);
        directors.record = &*record_director;
        if (replay->program != 0) {
            directors.open_program = [&supervisor, program = replay->program] {
                return supervisor.open_program(program).has_value();
            };
        }
    } else if (replay) {
        directors.job = &job_director;
    }
    return setup == nullptr ? run_on_virtual_clock(parts, supervisor, directors, end)
                            : run_on_real_clock(parts, supervisor, directors, end, *setup);
}

Result<void> check_group_of_user(const rtcore::UserAccount& account, const CoreOptions& options) {
    if (options.group.empty()) return {};
    const auto group = group_id(options.group);
    if (!group) return group.error();
    if (rtcore::will_be_in_group(account, *group)) return {};
    return Error{ErrorCode::bad_usage, "--group " + options.group +
                                           ": its members do not trust a segment of " + options.user +
                                           ", who is none: adduser " + options.user + " " + options.group};
}

/// For the user that is asked for. Refused before anything is that user's.
Result<void> leave_root(const CoreOptions& options) {
    if (options.user.empty()) return {};
    const auto account = rtcore::account_of(options.user);
    if (!account) return account.error();
    if (auto fits = check_group_of_user(*account, options); !fits) return fits.error();
    // What a core of root's has left when it ended is taken over, as every core takes it over.
    if (auto handed = Segment::hand_over(options.segment_name, account->user, account->group); !handed)
        return handed.error();
    make_state_folder_for(options.state_folder, account->user, account->group);
    return rtcore::become_user(*account);
}

/// Before any thread starts and any output is opened; port, segment and memory are there.
void leave_privileges(const CoreOptions& options) {
    const bool is_realtime = options.clock == ClockKind::real;
    const auto stayed = rtcore::drop_privileges({.priority = is_realtime ? options.priority : 0,
                                                 .locks_memory = is_realtime,
                                                 .group = options.group});
    for (const std::string& name : stayed) {
        std::fprintf(stderr, "psicarve-rtcore: %s stays: its limit cannot be raised here\n", name.c_str());
    }
    if (!options.port.is_simulated() && geteuid() == 0) {
        std::fprintf(
            stderr,
            "psicarve-rtcore: goes on as root, without privileges but with root's files; --user NAME "
            "makes it another user\n");
    }
}

ProgramAccess access_to(program::ProgramServer& programs) {
    return {.open = [&programs](std::uint64_t program) { return programs.open(program); },
            .note_answer = [&programs](std::uint64_t program,
                                       bool is_done) { programs.note_answer(program, is_done); },
            .serve = [&programs](const std::shared_ptr<Segment>& segment,
                                 const ProgramStatus& status) { programs.serve(segment, status); }};
}

/// The segment is ours.
int serve_segment(const CoreOptions& options, const Profile& profile, PartsRequest request, Segment segment,
                  std::optional<Replay>& replay) {
    EndRequest end;
    if (replay && replay->program == 0) {
        const auto published = publish_recorded_job(segment, replay->snapshot.job_blob);
        if (!published) return fail(published.error());
    }
    std::optional<RealtimeSetup> setup;
    if (options.clock == ClockKind::real) setup.emplace(wish_of(options));
    leave_privileges(options);
    const Profile machine = request.machine;
    auto parts = build_core(options, profile, std::move(request));
    if (!parts) return fail(parts.error());
    const CoreFacts facts{.period_ns = (*parts)->period_ns,
                          .is_simulator = options.port.is_simulated(),
                          .is_virtual_clock = options.clock == ClockKind::virtual_time,
                          .missing_sensors_mask = missing_sensors(profile)};
    // A replay's program has the number that it had.
    const bool replays_program = replay && replay->program != 0;
    const std::uint64_t last_number = replays_program
                                          ? replay->program - 1
                                          : program::first_program_number(std::chrono::steady_clock::now());
    program::ProgramServer programs{profile, last_number};
    Supervisor supervisor{**parts, segment_options_of(options), std::move(segment), facts};
    if (!replay || replays_program) supervisor.set_program_access(access_to(programs));
    if (replay && replay->script) supervisor.refuse_commands(message_of(MessageId::replaying));
    if (facts.is_virtual_clock && !replay) supervisor.load_left_job();
    supervisor.segment().sign_core();
    const int exit_code = run_loop(**parts, supervisor, replay, end, setup ? &*setup : nullptr);
    supervisor.leave();
    if (!options.piece_path.empty()) {
        const auto written = write_piece(options.piece_path, *(*parts)->machine, machine);
        if (!written) return fail(written.error());
    }
    return exit_code;
}

}  // namespace

int run_core(const CoreOptions& options) {
    // Before all else: whatever is made from here on is that user's; and the kernel would forget the parent.
    if (const auto left = leave_root(options); !left) return fail(left.error());
    if (options.exit_with_parent && !tie_to_parent()) return kExitDone;
    if (options.measures_latency) return run_latency_measurement(options);
    auto replay = load_replay(options);
    if (!replay) return fail(replay.error());
    const auto profile = load_core_profile(profile_path_of(options));
    if (!profile) return fail(profile.error());
    if (!options.unnamed_profile_path.empty() && options.replay_path.empty())
        std::fprintf(stderr, "psicarve-rtcore: profile %s\n",
                     printable(options.unnamed_profile_path).c_str());
    const auto machine = options.machine_path.empty() ? profile : load_core_profile(options.machine_path);
    if (!machine) return fail(machine.error());
    PartsRequest request = parts_request_of(*replay, *profile, *machine);
    // What was read so far only that user could read; for port, memory and scheduling they are needed.
    if (!options.user.empty()) rtcore::raise_privileges();
    if (!options.port.is_simulated()) {
        auto side = open_guarded_port(options, *profile);
        if (!side) return fail(side.error());
        if (const int* exit_code = std::get_if<int>(&*side)) return *exit_code;
        request.real_port.emplace(std::move(std::get<GuardedPort>(*side)));
        // Before the segment, which has a use for SIGBUS of its own.
        port::handle_fatal_signals();
    }
    auto segment = Segment::create_or_attach(segment_options_of(options));
    if (!segment) return fail(segment.error());
    if (const auto claimed = segment->take_core_lock(); !claimed) return fail(claimed.error());
    if (const auto fitted = segment->fit_rights(options.group); !fitted) return fail(fitted.error());
    if (!segment->warning().empty())
        std::fprintf(stderr, "psicarve-rtcore: %s\n", printable(segment->warning()).c_str());
    return serve_segment(options, *profile, std::move(request), std::move(*segment), *replay);
}

}  // namespace psicarve::supervisor
