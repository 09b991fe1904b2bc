// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

class QString;
class QTabBar;

namespace psicarve::ui {

enum class BadgeTone : unsigned char { warning, alarm };

/// A number behind the name of a tab, for the eye and, in words, for a screen reader; none while it is 0.
void set_tab_badge(QTabBar& bar, int tab, std::size_t count, BadgeTone tone);

}  // namespace psicarve::ui
