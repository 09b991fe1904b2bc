// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "hmi/cli/command_set.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/machine/core_process.hpp"
#include "hmi/machine/machine_link.hpp"
#include "hmi/machine/unique_fd.hpp"
#include "hmi/verify/program/program_verifier.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

struct ProgramCoreLaunch {
    std::string segment;
    std::string group;
    bool is_private = false;  ///< the segment is removed when the core has ended
    std::string trace_path;   ///< empty: no file
    /// What its pins are judged by while it runs; nothing: they are not.
    std::optional<verify::JudgedProgram> program;
    std::string replay_path{};  ///< snapshot whose program it replays; empty: it serves commands
};

/// A core of our own on the simulated machine, by the virtual clock, for a program in G-code.
class ProgramCore {
public:
    static Result<std::unique_ptr<ProgramCore>> start(ProgramCoreLaunch launch, const Profile& profile);
    ~ProgramCore();
    ProgramCore(const ProgramCore&) = delete;
    ProgramCore& operator=(const ProgramCore&) = delete;

    machine::MachineLink& link() noexcept { return link_; }
    machine::CoreProcess& process() noexcept { return core_; }
    Result<void> home(OperatorBreak& operator_break);
    /// Ends the core and returns what its pins came to, nothing where they are not judged; an error where its
    /// trace is not whole.
    Result<std::optional<verify::ProgramVerifyReport>> finish();

private:
    ProgramCore(machine::CoreProcess core, machine::MachineLink link) noexcept
        : core_(std::move(core)), link_(std::move(link)) {}
    void judge(machine::UniqueFd read_end, verify::JudgedProgram program, const Profile& profile);

    std::string trace_path_;
    std::optional<Result<verify::ProgramVerifyReport>> report_;  // by the thread, read after join
    std::thread thread_;
    machine::CoreProcess core_;
    machine::MachineLink link_;
};

}  // namespace psicarve::cli
