// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/record_states.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "shared/machine/recorded_program.hpp"

namespace psicarve::replay {
namespace {

FlightRecord record_at(std::uint64_t tick, RecordKind kind, std::uint16_t code) {
    FlightRecord record{};
    record.tick = tick;
    record.kind = kind;
    record.code = code;
    record.axis = kNoAxis;
    return record;
}
FlightRecord entering(std::uint64_t tick, MachineState state) {
    return record_at(tick, RecordKind::state_change, static_cast<std::uint16_t>(state));
}
FlightRecord of_program(std::uint64_t tick, ProgramEvent event) {
    return record_at(tick, RecordKind::program, recorded_code(event));
}

// What is carved then is no layer of the job that is loaded.
TEST(RecordStates, KnowAProgramFromAJob) {
    const RecordStates sut{{entering(10, MachineState::carving), entering(20, MachineState::ready),
                            of_program(30, ProgramEvent::begun), entering(30, MachineState::carving),
                            of_program(35, ProgramEvent::line), entering(40, MachineState::holding),
                            of_program(50, ProgramEvent::held), entering(50, MachineState::held),
                            of_program(60, ProgramEvent::ended), entering(60, MachineState::ready),
                            entering(70, MachineState::carving)}};
    for (const std::uint64_t tick : {5U, 10U, 20U, 60U, 70U}) EXPECT_FALSE(sut.runs_program(tick)) << tick;
    for (const std::uint64_t tick : {30U, 37U, 45U, 59U}) EXPECT_TRUE(sut.runs_program(tick)) << tick;
    CoreStatus status{};
    sut.fill(status, 37);
    EXPECT_EQ(status.state, MachineState::carving) << "a line changes no state";
}

TEST(RecordStates, EndAProgramWithAnAlarm) {
    const RecordStates sut{{of_program(1, ProgramEvent::begun), entering(1, MachineState::carving),
                            record_at(5, RecordKind::alarm, static_cast<std::uint16_t>(AlarmCause::limit))}};
    EXPECT_TRUE(sut.runs_program(4));
    EXPECT_FALSE(sut.runs_program(5));
}

}  // namespace
}  // namespace psicarve::replay
