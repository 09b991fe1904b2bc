// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>

#include "hmi/ui/main_window.hpp"
#include "tests/bench/window/judge.hpp"
#include "tests/bench/window/watched_application.hpp"

namespace psicarve::context {

/// Memory of this process [MB]: all of it, and what is its own.
void print_memory(const char* when);

/// The longest turns of the window's thread in a stage.
void print_longest(WatchedApplication& application, const char* stage, Judge& judge);

/// Opens a mesh of two million triangles, slices it, looks at its pages.
bool load_and_slice(WatchedApplication& application, ui::MainWindow& window, const std::string& folder,
                    Judge& judge);

/// Frames of the carving view while a core carves 500 x 500 points, beside those of a page without one.
bool carve(WatchedApplication& application, ui::MainWindow& window, Judge& judge);

/// From a press of the mouse on Hold and Resume until the core has taken the command, beside the same
/// commands sent without a window.
bool press_buttons(WatchedApplication& application, ui::MainWindow& window, Judge& judge);

/// From the death of the core, killed at work, until the window has said so.
bool lose_core(WatchedApplication& application, ui::MainWindow& window, pid_t core, Judge& judge);

}  // namespace psicarve::context
