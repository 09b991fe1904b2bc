// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/program_desk.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "hmi/phrase/error_phrase.hpp"

namespace psicarve::program {
namespace {

using session::phrase;
using session::Severity;

std::string name_of_file(const std::string& path) {
    return std::filesystem::path{path}.filename().string();
}

}  // namespace

void ProgramDesk::open(const std::string& path, const session::MachineView& machine, const Profile& profile) {
    const bool is_other = path != path_;
    path_ = path;
    if (is_other) {
        program_.reset();
        text_.show(nullptr);
        ended_.reset();
        switches = {};
        asks_for_start = false;
    }
    begin_decode(machine, profile);
}

void ProgramDesk::decode_again(const session::MachineView& machine, const Profile& profile) {
    begin_decode(machine, profile);
}

void ProgramDesk::begin_decode(const session::MachineView& machine, const Profile& profile) {
    problem_ = {};
    ++edition_;
    decoder_.begin({path_, profile, switches.skips_deleted, switches.from_line, known_place(machine),
                    segment_name_, machine.is_simulator()});
}

void ProgramDesk::cancel() {
    asks_for_start = false;
    decoder_.cancel();
}

void ProgramDesk::poll(const ProgramReport& report) {
    // The claim's owner has the one program that runs.
    const bool is_own = process_.pid() != 0 && report.writer_pid == process_.pid();
    if (is_own && report.status.is_running != 0) own_program_ = report.status.program;
    if (auto read = decoder_.take()) {
        ++edition_;
        if (*read) {
            program_ = std::move(*read).value();
            text_.show(program_);
        } else if (read->error().code != ErrorCode::cancelled) {
            program_.reset();
            text_.show(nullptr);
            asks_for_start = false;
            problem_ = session::error_phrase(read->error());
            log_.add(Severity::warning,
                     session::joined(phrase("Not opened: %1", name_of_file(path_)), problem_));
        }
    }
    if (text_.poll()) ++text_edition_;
    if (auto ended = process_.poll()) {
        ended_ = std::move(*ended);
        ++edition_;
        tell_end();
    }
}

void ProgramDesk::tell_end() {
    if (ended_->problems.error_count() > 0) return;  // told where it was typed
    const session::Phrase said =
        ended_->said.empty() ? phrase("it said nothing") : session::error_phrase(ended_->said);
    if (ended_->is_done) return log_.add(Severity::info, session::joined(phrase("Program run"), said));
    log_.add_command(Severity::warning, session::joined(phrase("Program ended"), said));
}

void ProgramDesk::forget_last_run() {
    ended_.reset();
    own_program_ = 0;
    asks_for_start = false;
    ++edition_;
}

RunRequest ProgramDesk::request() const {
    RunRequest request;
    request.segment_name = segment_name_;
    request.group = group_;
    return request;
}

void ProgramDesk::start(const session::MachineView& machine) {
    if (is_under_way()) return;
    RunRequest wanted = request();
    wanted.state = program_->state;
    wanted.is_simulator = machine.is_simulator();
    wanted.offsets = program_->offsets;
    // A working folder that is gone makes no path absolute: the process says what it cannot open.
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(path_, error);
    wanted.file = error ? path_ : whole.string();
    wanted.switches = switches;
    forget_last_run();
    is_block_ = false;
    started_ = {program_->request.path, program_->state, switches};
    log_.add_command(Severity::info, phrase("Program started: %1", name_of_file(path_)));
    process_.begin(std::move(wanted), *machine.profile);
}

void ProgramDesk::give_up(const ProgramReport& report) {
    if (is_on_its_way(report)) process_.give_up();
}

std::string ProgramDesk::started_name() const {
    return name_of_file(started_.path);
}

void ProgramDesk::run_block(const std::string& block, const session::MachineView& machine) {
    if (is_under_way()) return;
    if (blocks_.empty() || blocks_.back() != block) blocks_.push_back(block);
    if (blocks_.size() > kMostBlocks) blocks_.pop_front();
    forget_last_run();
    is_block_ = true;
    log_.add_command(Severity::info, phrase("Block asked for: %1", block));
    DecodeRequest judged;
    judged.profile = *machine.profile;
    judged.start = known_place(machine);
    judged.segment_name = segment_name_;
    judged.is_simulator = machine.is_simulator();
    process_.begin_block(block, request(), judged);
}

}  // namespace psicarve::program
