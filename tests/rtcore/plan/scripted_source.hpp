// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "rtcore/plan/program_step.hpp"

namespace psicarve::plan::test {

/// Gives the steps of a script, as far as they are `written`; after the last of them says how it ends.
class ScriptedSource final : public StepSource {
public:
    explicit ScriptedSource(std::vector<ProgramStep> steps, Supply at_the_end = Supply::ended)
        : written(steps.size()), steps_(std::move(steps)), at_the_end_(at_the_end) {}

    Supply next(ProgramStep& step) override {
        ++asked;
        if (taken_ < steps_.size() && taken_ < written) {
            step = steps_[taken_++];
            return Supply::step;
        }
        return taken_ < steps_.size() ? Supply::later : at_the_end_;
    }
    void begin(const Pulses4& start_pulses) override { start = start_pulses; }
    std::size_t taken() const { return taken_; }

    std::atomic<std::size_t> written;  ///< so many of the steps have come
    std::uint64_t asked = 0;
    Pulses4 start{};

private:
    std::vector<ProgramStep> steps_;
    std::size_t taken_ = 0;
    Supply at_the_end_;
};

/// Sequences of records are no lines.
inline constexpr std::uint64_t kBeforeScript = 7'000'000'000;

/// Writes a program's steps, each in a line of its own.
class Script {
public:
    explicit Script(const Pulses4& start_pulses) : at_(start_pulses) {}

    Script& way(const Pulses4& delta_pulses, double tolerance_mm, double seconds = 0.0,
                bool is_rapid = false) {
        ProgramStep& step = add(MotionKind::way);
        for (std::size_t k = 0; k < kAxisCount; ++k) at_[k] += delta_pulses[k];
        step.target_pulses = at_;
        step.tolerance_mm = tolerance_mm;
        step.seconds = seconds;
        step.is_rapid = is_rapid;
        return *this;
    }
    /// By point-by-point comparison, of r1, y or both.
    Script& stepped_line(const Pulses4& delta_pulses, double seconds = 0.0) {
        way(delta_pulses, 0.0, seconds);
        ProgramStep& step = steps.back();
        step.shape = cycle::OrderShape::stepped;
        for (std::size_t k = 0; k < kAxisCount; ++k)
            if (delta_pulses[k] != 0)
                step.stepped_axes = static_cast<std::uint8_t>(step.stepped_axes | 1U << k);
        return *this;
    }
    /// The same of r1 and y, about a centre so far from where it begins; without a way a whole turn.
    Script& stepped_arc(const Pulses4& delta_pulses, const std::array<std::int64_t, 2>& to_centre,
                        bool is_counterclockwise, double seconds = 0.0) {
        const std::array<std::int64_t, 2> centre{at_[0] + to_centre[0], at_[kAxisCount - 1] + to_centre[1]};
        way(delta_pulses, 0.0, seconds);
        ProgramStep& step = steps.back();
        step.kind = MotionKind::arc;
        step.shape = is_counterclockwise ? cycle::OrderShape::arc : cycle::OrderShape::clockwise;
        step.stepped_axes = 0b1001;
        step.centre_pulses = centre;
        return *this;
    }
    Script& dwell(double seconds) {
        add(MotionKind::dwell).seconds = seconds;
        return *this;
    }
    Script& spindle(bool is_on) {
        add(MotionKind::spindle).is_on = is_on;
        return *this;
    }
    Script& output(Signal which, bool is_on) {
        ProgramStep& step = add(MotionKind::output);
        step.is_on = is_on;
        step.outputs = switched_bit(which);
        return *this;
    }
    Script& stop(StopReason reason = StopReason::program) {
        add(MotionKind::stop).reason = reason;
        return *this;
    }
    Script& end() {
        add(MotionKind::end);
        return *this;
    }

    const Pulses4& at() const { return at_; }
    std::vector<ProgramStep> steps;

private:
    ProgramStep& add(MotionKind kind) {
        ProgramStep& step = steps.emplace_back();
        step.kind = kind;
        step.line = steps.size();
        step.sequence = steps.size() + kBeforeScript;
        step.ends_block = true;
        return step;
    }
    Pulses4 at_;
};

/// Ways of all kinds, of `axes` (bit by axis), mixed with rests; nowhere further than `reach` from the start
/// but for psi.
inline Script random_program(std::uint64_t seed, const Pulses4& start_pulses, std::size_t ways,
                             unsigned axes = 0xF, std::int64_t reach = 500) {
    std::mt19937_64 random{seed};
    const auto up_to = [&](std::int64_t most) {
        return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most + 1)) - most;
    };
    Script script{start_pulses};
    constexpr double kTolerances[] = {0.0, 0.01, 0.03, 0.002};
    double tolerance_mm = 0.01;
    for (std::size_t i = 0; i < ways; ++i) {
        if (random() % 16 == 0) tolerance_mm = kTolerances[random() % 4];
        Pulses4 way{};
        const std::int64_t most = random() % 8 == 0 ? 400 : 12;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if ((axes >> k & 1U) == 0) continue;
            way[k] = up_to(most);
            const std::int64_t off = script.at()[k] + way[k] - start_pulses[k];
            if (k != kPsi && (off > reach || off < -reach)) way[k] = -way[k];
        }
        script.way(way, tolerance_mm, random() % 2 == 0 ? 0.0 : 0.001 * static_cast<double>(random() % 200),
                   random() % 8 == 0);
        if (random() % 40 == 0) script.dwell(0.01);
        if (random() % 60 == 0) script.spindle(random() % 2 == 0);
        if (random() % 60 == 0) script.stop();
    }
    script.end();
    return script;
}

/// A dense program: waves of all its axes with a noise of whole pulses, no corner that asks for a rest.
inline Script dense_program(std::uint64_t seed, int ways, unsigned axes, double step_pulses = 20.0,
                            const Pulses4& start_pulses = {6000, 6200, 100, 3000}) {
    std::mt19937_64 random{seed};
    std::array<double, kAxisCount> phase{};
    for (double& of_axis : phase) of_axis = static_cast<double>(random() % 628) * 0.01;
    Script script{start_pulses};
    Pulses4 at{};
    for (int i = 1; i <= ways; ++i) {
        Pulses4 to{};
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if ((axes >> k & 1U) == 0) continue;
            const double turn = 0.01 * i * (1.0 + 0.3 * static_cast<double>(k));
            const double wave = 100.0 * step_pulses * (std::sin(turn + phase[k]) - std::sin(phase[k]));
            to[k] = k == kPsi ? static_cast<std::int64_t>(step_pulses * i) : std::llround(wave * 0.3);
        }
        Pulses4 way{};
        for (std::size_t k = 0; k < kAxisCount; ++k) way[k] = to[k] - at[k];
        script.way(way, 0.02, random() % 3 == 0 ? 0.002 : 0.0);
        at = to;
    }
    script.end();
    return script;
}

}  // namespace psicarve::plan::test
