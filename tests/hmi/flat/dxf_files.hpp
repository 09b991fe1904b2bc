// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/hmi/flat/flat_files.hpp"

namespace psicarve::flat {

class DxfTest : public FlatTest {
protected:
    /// "0 LINE 8 0 ..." becomes pairs of lines.
    static std::string lines(const std::string& words) {
        std::string text = words;
        for (char& c : text) c = c == ' ' ? '\n' : c;
        return text + "\n";
    }
    static std::string drawing(const std::string& entities, const std::string& before = "") {
        return lines("0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC" + before + " 0 SECTION 2 ENTITIES " +
                     entities + " 0 ENDSEC 0 EOF");
    }
    model::Mesh dxf(const std::string& entities, const std::string& before = "") const {
        return loaded(file("d.dxf", drawing(entities, before)));
    }
};

/// A square with sides of 10 mm and a corner at the origin.
inline constexpr const char* kSquare =
    "0 LWPOLYLINE 8 0 90 4 70 1 10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10";

}  // namespace psicarve::flat
