// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_core.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <span>
#include <sstream>
#include <utility>

#include "hmi/cli/progress_bar.hpp"
#include "hmi/verify/judged_trace.hpp"
#include "shared/base/printable.hpp"

namespace psicarve::cli {
namespace {

/// Reads to the pipe's end, so that a core that still writes does not wait for us.
void drain(int fd) {
    std::array<char, 65536> bytes;
    while (read(fd, bytes.data(), bytes.size()) > 0) {
    }
}

/// The core's warnings. What it says of the trace is our failure.
Result<void> pass_on(const std::string& said, const std::string& trace_path) {
    std::istringstream lines{said};
    std::optional<Error> failure;
    for (std::string line; std::getline(lines, line);) {
        if (!failure && !trace_path.empty() && line.find(trace_path + ": ") != std::string::npos) {
            failure = Error{ErrorCode::out_of_room, line};
            continue;
        }
        clear_progress_line();
        std::fprintf(stderr, "%s\n", printable(line).c_str());
    }
    if (failure) return *failure;
    return {};
}

}  // namespace

Result<std::unique_ptr<ProgramCore>> ProgramCore::start(ProgramCoreLaunch launch, const Profile& profile) {
    const std::string toml = profile_to_toml(profile);
    const auto profile_file = machine::open_memory_file("profile", std::as_bytes(std::span{toml}));
    if (!profile_file) return profile_file.error();
    auto pipe = machine::open_pipe();
    if (!pipe) return pipe.error();
    machine::CoreLaunch how;
    how.segment_name = launch.segment;
    how.group = launch.group;
    how.is_private = launch.is_private;
    // The child sees both under the same numbers.
    how.profile_path = "/proc/self/fd/" + std::to_string(profile_file->get());
    how.inherited_fds = {profile_file->get()};
    how.no_estimate = true;
    how.replay_path = launch.replay_path;
    how.replays_program = !launch.replay_path.empty();
    if (!launch.trace_path.empty()) how.trace_paths.push_back(launch.trace_path);
    if (launch.program) {
        how.trace_paths.push_back("fd:" + std::to_string(pipe->write_end.get()));
        how.inherited_fds.push_back(pipe->write_end.get());
    }
    auto core = machine::CoreProcess::start(how);
    if (!core) return core.error();
    pipe->write_end.reset();
    auto link = machine::MachineLink::attach(launch.segment, launch.group);
    if (!link) return link.error();
    std::unique_ptr<ProgramCore> made{new ProgramCore{std::move(core).value(), std::move(link).value()}};
    made->trace_path_ = launch.trace_path;
    if (launch.program) {
        made->thread_ = std::thread{
            [self = made.get(), fd = std::move(pipe->read_end), program = std::move(*launch.program),
             profile]() mutable { self->judge(std::move(fd), std::move(program), profile); }};
    }
    return made;
}

ProgramCore::~ProgramCore() {
    // Its end is the pipe's.
    core_.end();
    if (thread_.joinable()) thread_.join();
}

void ProgramCore::judge(machine::UniqueFd read_end, verify::JudgedProgram program, const Profile& profile) {
    const machine::UniqueFd kept{fcntl(read_end.get(), F_DUPFD_CLOEXEC, 0)};
    auto trace = verify::open_trace_fd(read_end.release(), "the core's trace");
    if (trace) {
        verify::ProgramVerifier verifier{std::move(program), profile};
        report_ = verify::judged_trace(verifier, **trace, {});
    } else {
        report_ = trace.error();
    }
    drain(kept.get());
}

Result<void> ProgramCore::home(OperatorBreak& operator_break) {
    ProgressBar bar{"homing"};
    if (const auto sent = link_.send(CommandKind::home); !sent) return sent;
    const auto homed = link_.wait_for_state({MachineState::ready}, [&](const CoreStatus&) -> Result<void> {
        bar.update(0.0, {});
        return operator_break.pass_on(link_);
    });
    if (!homed) return homed.error();
    return {};
}

Result<std::optional<verify::ProgramVerifyReport>> ProgramCore::finish() {
    // As long as it takes: the virtual clock waits for who reads its trace.
    (void)core_.end_while([] { return true; });
    core_.end();
    if (thread_.joinable()) thread_.join();
    if (const auto whole = pass_on(core_.messages(), trace_path_); !whole) return whole.error();
    if (!report_) return std::optional<verify::ProgramVerifyReport>{};
    if (!*report_) return report_->error();
    if ((*report_)->failure) return *(*report_)->failure;
    return std::optional{**report_};
}

}  // namespace psicarve::cli
