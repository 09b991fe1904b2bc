// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace psicarve::ui {

/// Of the dialog that opens a file: everything at first, then each kind.
QString filters_of_files();
/// The same, of programs in G-code alone.
QString filters_of_programs();

}  // namespace psicarve::ui
