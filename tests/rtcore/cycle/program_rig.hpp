// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/rtcore/plan/scripted_source.hpp"

namespace psicarve::cycle {

inline constexpr std::uint64_t kProgram = 7;
inline constexpr std::uint64_t kPatienceTicks = 4000;

inline Profile program_profile() {
    Profile profile = quick_profile();
    profile.job.planner = Planner::lookahead;
    return profile;
}

/// A homed machine, and a program that it is asked to run.
class ProgramRig : public MachineRig {
public:
    explicit ProgramRig(const Profile& machine_profile = program_profile()) : MachineRig(machine_profile) {
        EXPECT_TRUE(home());
        EXPECT_EQ(ask(move_to({-800, -700, 300, 600})), Refusal::none);
        EXPECT_TRUE(run_until(MachineState::ready));
        port->writes.clear();
        reports.clear();
    }
    std::shared_ptr<plan::test::ScriptedSource> give(std::vector<plan::ProgramStep> steps,
                                                     plan::Supply at_the_end = plan::Supply::ended) {
        auto source = std::make_shared<plan::test::ScriptedSource>(std::move(steps), at_the_end);
        planner->set_source(source, kProgram);
        return source;
    }
    Refusal start(bool is_single = false) {
        return ask(RequestKind::run_program, is_single ? 1 : 0, kProgram);
    }
    ProgramStatus program() const { return cycle->sample().program; }
    bool is_spindle_on() const { return (cycle->pulses().levels() & bit_of(Signal::spindle)) != 0; }

private:
    Request move_to(const Positions& delta) const {
        Request request{};
        request.kind = RequestKind::move;
        request.order.axes = 0xF;
        for (std::size_t k = 0; k < kAxisCount; ++k)
            request.order.target_pulses[k] = positions()[k] + delta[k];
        return request;
    }
};

inline std::vector<plan::ProgramStep> some_steps(const Positions& from) {
    plan::test::Script script{from};
    script.spindle(true).way({-200, 0, 100, 50}, 0.01, 0.05).way({100, -50, 100, 0}, 0.01, 0.05).dwell(0.01);
    script.way({-50, 50, 0, -30}, 0.0).end();
    return script.steps;
}

}  // namespace psicarve::cycle
