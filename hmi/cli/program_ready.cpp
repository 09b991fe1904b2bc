// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_ready.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>

#include "hmi/cli/job_source.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/program_sight.hpp"
#include "hmi/gcode/axis_letters.hpp"
#include "hmi/machine/core_profile.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

constexpr std::chrono::milliseconds kFirstRecordsLook{2};

/// Takes motion until it is interrupted.
class PatientSink : public gcode::CanonSink {
public:
    PatientSink(gcode::CanonSink& sink, const OperatorBreak& operator_break) noexcept
        : sink_(sink), operator_break_(operator_break) {}

    void take(const gcode::CanonRecord& record) override { sink_.take(record); }
    void begin_line(const gcode::ReachedLine& line) override { sink_.begin_line(line); }
    void end_block() override { sink_.end_block(); }
    bool wants_more() const noexcept override { return !operator_break_.was_asked() && sink_.wants_more(); }

private:
    gcode::CanonSink& sink_;
    const OperatorBreak& operator_break_;
};

}  // namespace

Result<Profile> profile_of_core(const machine::MachineLink& link, const CommonOptions& common) {
    auto profile = chosen_profile(common);
    const std::uint64_t hash = link.segment().header().core_profile_hash.load();
    if (profile && profile_hash(*profile) == hash) return profile;
    if (common.profile.empty()) {
        if (auto found = machine::find_core_profile(link.core_pid().value_or(0), hash)) return *found;
    }
    if (!profile) return profile;
    const std::string path = chosen_profile_path(common);
    return Error{ErrorCode::machine_refused, "the core has another profile than " +
                                                 (path.empty() ? "the built-in one" : path) +
                                                 "; name the one that it was started with: --profile FILE"};
}

Result<void> require_ready(const Segment& segment, const CoreStatus& status) {
    if (status.state == MachineState::ready) return {};
    if (status.state == MachineState::off)
        return error_from(ErrorCode::machine_refused, message_of(MessageId::not_homed));
    if (status.state == MachineState::alarm) return machine::alarm_error(status);
    if (has_living_writer(segment))
        return error_from(
            ErrorCode::machine_refused,
            message_of(MessageId::program_has_writer, count_argument(program_report(segment).writer_pid)));
    return error_from(ErrorCode::machine_refused,
                      message_of(MessageId::wrong_state, argument_of(CommandKind::program),
                                 argument_of(status.state), way_out_of(status.state)));
}

Result<void> require_heads_alike(const Profile& profile, const CoreStatus& status) {
    const gcode::AxisLetters letters{profile.gcode};
    if (letters.letter_of(Axis::r1) != letters.letter_of(Axis::r2)) return {};
    const auto place = [&](Axis axis) {
        return static_cast<double>(status.position_pulses[index_of(axis)]) /
               axis_motion(profile, axis).pulses_per_unit;
    };
    const double pulse_mm = 1.0 / std::min(axis_motion(profile, Axis::r1).pulses_per_unit,
                                           axis_motion(profile, Axis::r2).pulses_per_unit);
    if (std::abs(place(Axis::r1) - place(Axis::r2)) <= pulse_mm) return {};
    return Error{
        ErrorCode::machine_refused,
        "r2 follows r1 (profile: gcode.second_head), and they stand at different radii; bring them to "
        "one radius: psicarve move"};
}

Error interrupted_before_it_began() {
    return {ErrorCode::cancelled, "interrupted; nothing has moved"};
}

Result<void> wait_for_records(const RecordFeeder& feeder, const machine::MachineLink& link,
                              const OperatorBreak& operator_break) {
    while (feeder.records_written() == 0 && !feeder.is_done()) {
        if (operator_break.was_asked()) return interrupted_before_it_began();
        if (const auto core = link.require_core(); !core) return core;
        std::this_thread::sleep_for(kFirstRecordsLook);
    }
    return {};
}

Result<gcode::ProgramFacts> interpret_patiently(gcode::LineSource& lines,
                                                const gcode::InterpreterOptions& how, gcode::CanonSink& sink,
                                                gcode::ProblemList& problems,
                                                const OperatorBreak& operator_break) {
    PatientSink patient{sink, operator_break};
    auto facts = gcode::interpret_program(lines, how, patient, problems);
    if (facts && operator_break.was_asked()) return interrupted_before_it_began();
    return facts;
}

}  // namespace psicarve::cli
