// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/block_list.hpp"
#include "rtcore/plan/record_program.hpp"

// What a program asks for at rest.

namespace psicarve::plan {

using cycle::BlockKind;
using cycle::MotionBlock;

MotionBlock& RecordProgram::add_block(BlockKind kind, std::uint64_t line) {
    MotionBlock& block = blocks_.emplace_back();
    block.kind = kind;
    set_program_line(block, line);
    set_program_sequence(block, sequence_);
    return block;
}

void RecordProgram::halt(ProgramHold hold, std::uint64_t line, std::uint8_t marks) {
    MotionBlock& block = add_block(BlockKind::halt, line);
    block.halt = hold;
    block.marks = marks;
}

void RecordProgram::dwell(std::int64_t ticks, std::uint64_t line) {
    if (ticks > 0) add_block(BlockKind::dwell, line).ticks = ticks;
}

MotionBlock& RecordProgram::add_switch(std::uint64_t line) {
    MotionBlock& block = add_block(BlockKind::outputs, line);
    block.enable_mask = kAllDrives;
    return block;
}

void RecordProgram::switch_spindle(bool is_on, std::uint64_t line) {
    add_switch(line).spindle = is_on ? cycle::Spindle::on : cycle::Spindle::off;
    if (is_on) dwell(machine_.spinup_ticks, line);
}

void RecordProgram::switch_outputs(SwitchedOutputs outputs, bool is_on, std::uint64_t line) {
    MotionBlock& block = add_switch(line);
    (is_on ? block.switched_on : block.switched_off) = outputs;
}

void RecordProgram::end(std::uint64_t line) {
    MotionBlock& block = add_switch(line);
    block.spindle = cycle::Spindle::off;
    block.switched_off = kAllSwitchedOutputs;
    add_block(BlockKind::program_end, line);
    is_ended_ = true;
}

}  // namespace psicarve::plan
