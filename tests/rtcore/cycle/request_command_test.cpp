// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/request_command.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>

#include "shared/machine/command.hpp"

namespace psicarve::cycle {
namespace {

/// Whether the number stands for a command at all: only those have a name.
bool is_command(CommandKind kind) {
    return kind != CommandKind::none && name_of(kind) != name_of(static_cast<CommandKind>(9999));
}

/// What it does itself: the tick is not asked.
bool is_the_supervisors(CommandKind command) {
    return command == CommandKind::shutdown || command == CommandKind::forget_piece;
}

TEST(RequestCommand, EveryCommandButTheSupervisorsIsARequestAndComesBackAsItself) {
    int commands = 0;
    for (std::uint32_t number = 0; number < 100; ++number) {
        const auto command = static_cast<CommandKind>(number);
        const auto request = request_of(command);
        EXPECT_EQ(request.has_value(), is_command(command) && !is_the_supervisors(command)) << number;
        if (!request) continue;
        ++commands;
        EXPECT_EQ(command_of(*request), command) << number;
    }
    EXPECT_EQ(commands, static_cast<int>(kRequestCommands.size()));
}

TEST(RequestCommand, WhatTheSupervisorAsksForItselfIsNobodysCommand) {
    EXPECT_EQ(command_of(RequestKind::job_loaded), CommandKind::none);
    EXPECT_EQ(command_of(RequestKind::fail), CommandKind::none);
}

}  // namespace
}  // namespace psicarve::cycle
