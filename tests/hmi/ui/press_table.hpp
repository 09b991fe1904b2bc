// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace psicarve::ui::test {

class PressLog;

/// A button, an entry of a menu or a key, and the test that presses it and looks what comes of it.
struct PressLine {
    const char* name;  ///< as in PressLog::pressed()
    const char* test;  ///< of this program: "Suite.Test"
};
/// All there are in the window and its dialogs. A new one needs a line, and a test that fails when it does
/// nothing.
std::span<const PressLine> press_table();

/// The running test has pressed what the table says of it, and has seen nothing that is not in the table.
void expect_pressed_as_in_table(const PressLog& log);

}  // namespace psicarve::ui::test
