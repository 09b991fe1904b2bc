// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve::ui {

/// psicarve-hmi. Returns its exit code.
int run(int argc, char** argv);

}  // namespace psicarve::ui
