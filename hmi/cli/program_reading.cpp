// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_reading.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/program_ready.hpp"
#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/machine_options.hpp"

namespace psicarve::cli {
namespace {

gcode::Position place_of(const Profile& profile, const CoreStatus& status) {
    const gcode::AxisLetters letters{profile.gcode};
    gcode::Position place{};
    // r1 last: where r2 follows it, one letter stands for both.
    for (const Axis axis : {Axis::r2, Axis::psi, Axis::y, Axis::r1}) {
        place[letters.letter_of(axis)] = static_cast<double>(status.position_pulses[index_of(axis)]) /
                                         axis_motion(profile, axis).pulses_per_unit;
    }
    return place;
}

class CheckSinks : public gcode::CanonSink {
public:
    CheckSinks(gcode::MachineCheck& machine, gcode::ApproachFinder& approach) noexcept
        : machine_(machine), approach_(approach) {}

    void take(const gcode::CanonRecord& record) override {
        machine_.take(record);
        approach_.take(record);
    }
    void begin_line(const gcode::ReachedLine& line) override {
        machine_.begin_line(line);
        approach_.begin_line(line);
    }
    void end_block() override { machine_.end_block(); }
    bool wants_more() const noexcept override { return machine_.wants_more(); }

private:
    gcode::MachineCheck& machine_;
    gcode::ApproachFinder& approach_;
};

}  // namespace

gcode::InterpreterOptions language_of(const GcodeRunOptions& options, const Profile& profile,
                                      const CoreStatus& status, const gcode::KeptOffsets& offsets) {
    gcode::InterpreterOptions how = gcode::machine_options(profile);
    how.dialect = options.dialect == "iso" ? gcode::Dialect::iso : gcode::Dialect::ngc;
    how.skips_deleted = options.skips_deleted;
    how.ends_with_input = options.is_stream();
    how.offsets = offsets;
    how.start = place_of(profile, status);
    return how;
}

Result<std::optional<RightProgram>> read_right_program(const GcodeRunOptions& options,
                                                       const gcode::InterpreterOptions& how,
                                                       const Profile& profile, const CommonOptions& common,
                                                       const OperatorBreak& operator_break) {
    gcode::ProblemList problems;
    gcode::MachineCheck machine{profile, problems};
    auto bytes = gcode::open_program(options.path);
    if (!bytes) return bytes.error();
    gcode::LineSource lines{std::move(bytes).value()};
    gcode::ApproachFinder approach{profile, std::max(options.from_line, 1U)};
    CheckSinks sinks{machine, approach};
    const auto facts = interpret_patiently(lines, how, sinks, problems, operator_break);
    if (!facts) return facts.error();
    print_problems(options.path, problems);
    if (problems.error_count() == 0) return std::optional{RightProgram{*facts, approach.found()}};
    if (common.json) print_json_line(check_json(options.path, *facts, problems));
    return std::optional<RightProgram>{};
}

}  // namespace psicarve::cli
