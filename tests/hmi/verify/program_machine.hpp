// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "hmi/gcode/machine_options.hpp"
#include "hmi/verify/program/program_verifier.hpp"
#include "tests/hmi/gcode/read_program.hpp"
#include "tests/hmi/verify/perfect_machine.hpp"

namespace psicarve::verify {

using ProgramPlace = std::array<double, kAxisCount>;  ///< r1, r2 [mm], psi [deg], y [mm]

/// The pins of a machine that stands at 40 mm, 41 mm, 0, 0 and goes straight to one place after the other,
/// slowly; written from places alone, it knows nothing of a program. Tests break its pins.
class PlacedMachine {
public:
    explicit PlacedMachine(const Profile& profile = {}) : profile_(profile), machine_(sample_) {
        machine_.start.position_pulses = machine_.position = pulses({40.0, 41.0, 0.0, 0.0});
        for (const Axis axis : kAllAxes) machine_.set(enable_of(axis), true);
    }
    PlacedMachine& to(const ProgramPlace& place) {
        const auto wanted = pulses(place);
        std::array<std::int64_t, kAxisCount> delta{};
        for (std::size_t k = 0; k < kAxisCount; ++k) delta[k] = wanted[k] - machine_.position[k];
        machine_.line(delta);
        return *this;
    }
    /// Straight lines along a path from 0 to 1.
    template <typename Path>
    PlacedMachine& along(int parts, const Path& path) {
        for (int part = 1; part <= parts; ++part) to(path(static_cast<double>(part) / parts));
        return *this;
    }
    PlacedMachine& rest(double seconds) {
        machine_.wait(std::llround(seconds * 1e9));
        return *this;
    }
    PlacedMachine& spindle(bool is_on) {
        machine_.set(Signal::spindle, is_on);
        return *this;
    }
    PerfectMachine& pins() { return machine_; }

private:
    std::array<std::int64_t, kAxisCount> pulses(const ProgramPlace& place) const {
        return {std::llround(place[0] * profile_.r1.pulses_per_mm),
                std::llround(place[1] * profile_.r2.pulses_per_mm),
                std::llround(place[2] / 360.0 * static_cast<double>(profile_.psi.pulses_per_rev)),
                std::llround(place[3] * profile_.y.pulses_per_mm)};
    }

    Profile profile_;
    SampleJob sample_ = wavy_job();
    PerfectMachine machine_;
};

inline JudgedProgram judged_program(const std::string& text, const Profile& profile = {}) {
    JudgedProgram program;
    program.open = [text] {
        return Result<gcode::ProgramBytes>{gcode::ProgramBytes{gcode::bytes_of(text), {}}};
    };
    program.language = gcode::machine_options(profile);
    return program;
}

inline ProgramVerifyReport judged(const std::string& text, PlacedMachine& machine,
                                  const Profile& profile = {}, double override_ratio = 1.0) {
    JudgedProgram program = judged_program(text, profile);
    program.override_ratio = override_ratio;
    ProgramVerifier sut{std::move(program), profile};
    EXPECT_TRUE(sut.begin(machine.pins().start).has_value());
    sut.feed(machine.pins().events);
    return sut.finish();
}

/// "FAULT LINE" of rule 1, or of the first rule that is broken; "ok".
inline std::string verdict(const ProgramVerifyReport& report) {
    if (report.failure) return report.failure->message;
    const Offence* first = report.rules[0].first ? &*report.rules[0].first : first_offence_of(report.rules);
    if (first == nullptr) return report.ok ? "ok" : "not ok";
    return first->fault + " " + (first->line ? std::to_string(*first->line) : "-");
}

}  // namespace psicarve::verify
