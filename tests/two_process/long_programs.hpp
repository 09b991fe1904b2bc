// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <sstream>
#include <string>

namespace psicarve::test {

/// Forth and back over many short lines: more than the ring and the core's queue hold.
inline std::string zigzag_program(int lines) {
    std::ostringstream text;
    text << "G21 G90 G94 F600\nG0 X50 Z50 Y10 C0\n";
    for (int i = 0; i < lines; ++i)
        text << "G1 X" << 50.0 - 0.01 * (i % 100) << " C" << 0.5 * (i % 40) << "\n";
    text << "M2\n";
    return text.str();
}

/// Many short ways along a curve on which nothing asks for a rest.
inline std::string wavy_program(int lines) {
    std::ostringstream text;
    text << "G21 G90 G94 F600\nG0 X50 Z50 Y10 C0\n";
    for (int i = 0; i < lines; ++i) {
        text << "G1 X" << 48.0 + 2.0 * std::cos(0.02 * i) << " Y" << 10.0 + 2.0 * std::sin(0.02 * i) << " C"
             << 0.1 * i << "\n";
    }
    text << "M2\n";
    return text.str();
}

}  // namespace psicarve::test
