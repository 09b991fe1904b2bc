// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

class QWidget;

namespace psicarve::ui::test {

/// What a person would see cut off, on top of each other or only by scrolling sideways: one line a finding.
/// Looks at all that is visible below `root` as it is laid out now; tables and drawn views scroll as they
/// like.
std::set<std::string> misfits(const QWidget& root);

}  // namespace psicarve::ui::test
