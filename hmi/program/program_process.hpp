// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "hmi/gcode/problem.hpp"
#include "hmi/machine/loose_work.hpp"
#include "hmi/program/decoding.hpp"
#include "hmi/program/run_request.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::program {

/// Where the process of a program finds what it needs, and leaves what it says.
struct RunFiles {
    std::string folder;  ///< made if it is not there
    std::string name;    ///< of the files in it, without what tells them apart: "psicarve-4711"

    std::string profile() const { return folder + "/" + name + ".toml"; }
    std::string log() const { return folder + "/" + name + ".run.log"; }
    std::string block() const { return folder + "/" + name + ".ngc"; }
};

/// Runs programs: each is a process `psicarve gcode run` in a session of its own, which goes on when this one
/// ends. One at a time. One owner's thread, which waits for no disk.
class ProgramProcess {
public:
    enum class State : std::uint8_t { none, starting, running };
    struct Ended {
        bool is_done = false;
        std::string said;             ///< the last line of what it said, without its name; for the log
        std::string text;             ///< the last lines
        gcode::ProblemList problems;  ///< of a typed block that was never started
    };

    explicit ProgramProcess(RunFiles files) : name_(files.name), files_(std::move(files)) {}
    /// What runs goes on.
    ~ProgramProcess() = default;
    ProgramProcess(const ProgramProcess&) = delete;
    ProgramProcess& operator=(const ProgramProcess&) = delete;

    /// Where one is there already nothing happens. `request.profile_path` is filled in here. A file that is
    /// no longer in `request.state` is not run, and nor is a program that would begin with other work offsets
    /// than `request.offsets`.
    void begin(RunRequest request, const Profile& profile);
    /// The same for a program of this block alone and an end, once it is judged.
    void begin_block(const std::string& block, RunRequest request, const DecodeRequest& judged_by);
    /// What is on its way to the machine is not run. Once the core runs it, it is the core's to stop.
    void give_up() noexcept;
    State state() const noexcept { return state_; }
    /// Its number, as that of the program's claim; 0: none.
    std::uint32_t pid() const noexcept { return pid_ ? static_cast<std::uint32_t>(*pid_) : 0; }
    /// How it ended, once.
    std::optional<Ended> poll();

private:
    struct Begun {
        std::optional<pid_t> pid;
        Ended refused;
    };
    static Begun start(const RunFiles& files, RunRequest request, const Profile& profile,
                       const DecodeProgress& progress);
    /// What holds for each new one.
    void note_start();
    void interrupt_once() noexcept;

    std::string name_;
    RunFiles files_;  ///< of the last one
    State state_ = State::none;
    std::shared_ptr<DecodeProgress> progress_;  ///< of the start; cancelled: it is given up
    bool is_interrupted_ = false;
    std::optional<pid_t> pid_;
    machine::LooseWork<Begun> starting_;
    machine::LooseWork<std::string> reading_;
    std::optional<int> exit_code_;
};

/// The last lines of a text that are not empty, at most `most`.
std::string last_lines(const std::string& text, std::size_t most);
/// The last line, without the name of the program that says it.
std::string last_said(const std::string& text);

}  // namespace psicarve::program
