// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

namespace psicarve::ui {

/// A long name has no spaces to end a line at, and would make the whole window as wide as it is: spaces of no
/// width are put into it.
QString breakable(const QString& text);
/// The file's name; its begin and its end where it is very long.
QString short_file_name(const std::string& path);

}  // namespace psicarve::ui
