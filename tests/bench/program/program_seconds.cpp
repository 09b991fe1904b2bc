// SPDX-License-Identifier: GPL-3.0-or-later
// How long a program in G-code takes, as planned, in continuous time.
//
// usage: program_seconds FILE [PROFILE]
//        program_seconds FILE --curve
//
// Prints, from its last dwell on: seconds | rests on the way | T_ref, the seconds where all ways between two
// rests are planned at once, with no horizon that recedes. A planned program takes the first to a tick for
// each rest. With --curve the curve that is carved, as CSV: parabolas one behind the other, whether each
// begins at rest, its length of u, and by axis dq/du at its begin and its end [pulses].
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/machine_options.hpp"
#include "hmi/gcode/program_check.hpp"
#include "hmi/gcode/record_maker.hpp"
#include "rtcore/plan/record_program.hpp"
#include "rtcore/program/record_rules.hpp"

namespace psicarve {
namespace {

/// Checks each record as the core does, and keeps the steps.
class StepList final : public gcode::RecordSink, public plan::StepSource {
public:
    StepList(const Profile& profile, const plan::Pulses4& start) : rules_(profile), at_(start) {}

    Result<void> take(const MotionRecord& record) override {
        plan::ProgramStep step;
        const Message wrong = rules_.judge(record, at_, step);
        if (!wrong.is_none())
            return bad_input("the core refuses the record of line " + std::to_string(record.line));
        at_ = step.target_pulses;
        steps_.push_back(step);
        return {};
    }
    plan::Supply next(plan::ProgramStep& step) override {
        if (next_ == steps_.size()) return plan::Supply::ended;
        step = steps_[next_++];
        return plan::Supply::step;
    }
    void rewind() { next_ = 0; }

private:
    program::RecordRules rules_;
    plan::Pulses4 at_;
    std::vector<plan::ProgramStep> steps_;
    std::size_t next_ = 0;
};

gcode::ByteSource bytes_of_file(const std::string& path) {
    auto stream = std::make_shared<std::ifstream>(path, std::ios::binary);
    return [stream](std::span<char> room) -> Result<std::size_t> {
        stream->read(room.data(), static_cast<std::streamsize>(room.size()));
        return static_cast<std::size_t>(stream->gcount());
    };
}

/// Where a homed machine of this profile stands.
plan::Pulses4 reference_pulses(const Profile& profile) {
    const gcode::Position reference = gcode::MachineCheck::reference_of(profile);
    const gcode::AxisLetters letters{profile.gcode};
    plan::Pulses4 pulses{};
    for (const Axis axis : kAllAxes) {
        const double per_unit = axis == Axis::psi ? static_cast<double>(profile.psi.pulses_per_rev) / 360.0
                                                  : axis_motion(profile, axis).pulses_per_unit;
        pulses[index_of(axis)] = std::llround(reference[letters.letter_of(axis)] * per_unit);
    }
    return pulses;
}

constexpr std::size_t kAtOnce = std::size_t{1} << 40U;  // more points than any program has

struct Planned {
    double seconds = 0.0;
    int rests = -1;  ///< its end is none
    std::vector<plan::SeenCell> curve;
};

Planned planned_in(const Profile& profile, const std::shared_ptr<StepList>& steps, const plan::Pulses4& start,
                   std::size_t part_points) {
    plan::RecordProgram program(plan::machine_limits(profile), steps, start, false, part_points);
    Planned planned;
    program.show(&planned.curve);
    cycle::MotionBlock block;
    while (program.next(block) || program.is_waiting()) {
        if (program.is_waiting()) continue;
        if (block.kind == cycle::BlockKind::dwell) {
            planned.seconds = 0.0;
            planned.rests = -1;
            planned.curve.clear();
        }
        if (block.kind != cycle::BlockKind::path) continue;
        planned.seconds += 2.0 * block.path.length /
                           (std::sqrt(block.path.start_speed2[0]) + std::sqrt(block.path.end_speed2[0]));
        const bool is_from_rest = block.group_blocks > 0 && (block.joints & cycle::kCarriesOn) == 0;
        planned.rests += is_from_rest ? 1 : 0;
    }
    return planned;
}

void print_curve(const std::vector<plan::SeenCell>& curve) {
    for (const auto& [cell, is_from_rest] : curve) {
        std::printf("%d,%.17g", is_from_rest ? 1 : 0, cell.length);
        for (const plan::Lanes& slope : {cell.slope_begin, cell.slope_end})
            for (const double of_axis : slope) std::printf(",%.17g", of_axis);
        std::printf("\n");
    }
}

int tell(const std::string& path, const Profile& profile, bool wants_curve = false) {
    const plan::Pulses4 start = reference_pulses(profile);
    const auto steps = std::make_shared<StepList>(profile, start);
    gcode::InterpreterOptions options = gcode::machine_options(profile);
    options.start = options.reference;
    gcode::RecordMaker maker{profile, {}, *steps};
    gcode::ProblemList problems;
    gcode::LineSource lines{bytes_of_file(path)};
    const auto facts = gcode::interpret_program(lines, options, maker, problems);
    const auto finished = maker.finish();
    if (!facts || !problems.errors().empty() || !finished) {
        std::fprintf(stderr, "program_seconds: %s is not as it should be: %s\n", path.c_str(),
                     finished ? "see psicarve gcode check" : finished.error().message.c_str());
        return 3;
    }
    const Planned planned = planned_in(profile, steps, start, plan::RecordProgram::kPartPoints);
    if (wants_curve) {
        print_curve(planned.curve);
        return 0;
    }
    steps->rewind();
    const Planned at_once = planned_in(profile, steps, start, kAtOnce);
    std::printf("%.4f %d %.4f\n", planned.seconds, planned.rests, at_once.seconds);
    return 0;
}

int run(int count, char** words) {
    if (count != 2 && count != 3) {
        std::fprintf(stderr, "usage: program_seconds FILE [PROFILE | --curve]\n");
        return 2;
    }
    if (count == 2) return tell(words[1], Profile{});
    if (words[2] == std::string_view{"--curve"}) return tell(words[1], Profile{}, true);
    const auto profile = load_profile(words[2]);
    if (profile) return tell(words[1], *profile);
    std::fprintf(stderr, "program_seconds: %s\n", profile.error().message.c_str());
    return 2;
}

}  // namespace
}  // namespace psicarve

int main(int count, char** words) {
    return psicarve::run(count, words);
}
